#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace stepmill::test {

/// JSON for people to compare: what fits on a line stands on one, so that points and short lists do.
inline std::string jsonText(const nlohmann::ordered_json& value, const std::string& indent = "") {
    constexpr std::size_t kLine = 100;
    const std::string line = value.dump();
    if (!value.is_structured() || line.size() + indent.size() <= kLine) return line;
    const std::string deeper = indent + " ";
    std::string text;
    for (const auto& [key, item] : value.items()) {
        text += (text.empty() ? "" : ",\n") + deeper;
        if (value.is_object()) text += nlohmann::ordered_json(key).dump() + ": ";
        text += jsonText(item, deeper);
    }
    return (value.is_object() ? "{\n" : "[\n") + text + "\n" + indent + (value.is_object() ? "}" : "]");
}

}  // namespace stepmill::test
