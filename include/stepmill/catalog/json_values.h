#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace stepmill::json {

using Json = nlohmann::ordered_json;

/// Six decimals: a nanometre in lengths, a microsecond in times. Keeps files short and the same everywhere.
inline double number(double value) {
    constexpr double kDecimals = 1e6;
    const double rounded = std::round(value * kDecimals) / kDecimals;
    return rounded == 0 ? 0.0 : rounded;
}

template <typename Vector>
Json point(const Vector& p) {
    Json json = Json::array();
    for (const double value : p)
        json.push_back(number(value));
    return json;
}

/// A JSON list of what `make` gives for each item.
template <typename Items, typename Make>
Json listOf(const Items& items, Make make) {
    Json list = Json::array();
    for (const auto& item : items)
        list.push_back(make(item));
    return list;
}

inline Json numberOrNull(const std::optional<double>& value) {
    return value ? Json(number(*value)) : Json(nullptr);
}

inline Json textOrNull(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

}  // namespace stepmill::json
