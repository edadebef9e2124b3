#include "catalog/schema_words.h"

#include <algorithm>
#include <numeric>
#include <regex>

#include <fmt/format.h>

#include "stepmill/catalog/json_text.h"

namespace stepmill {
namespace {

using nlohmann::json;

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : separator) + word;
    return text;
}

std::vector<std::string> typesOf(const json& schema) {
    if (!schema.contains("type")) return {};
    if (schema["type"].is_string()) return {schema["type"].get<std::string>()};
    return schema["type"].get<std::vector<std::string>>();
}

std::string numberWords(const json& schema, const std::string& noun) {
    const auto limit = [&schema](const char* name) {
        return fmt::format("{:.15g}", schema[name].get<double>());
    };
    if (schema.contains("minimum") && schema.contains("maximum"))
        return noun + " from " + limit("minimum") + " to " + limit("maximum");
    std::vector<std::string> limits;
    if (schema.contains("exclusiveMinimum")) limits.push_back("greater than " + limit("exclusiveMinimum"));
    if (schema.contains("minimum")) limits.push_back("of at least " + limit("minimum"));
    if (schema.contains("exclusiveMaximum")) limits.push_back("less than " + limit("exclusiveMaximum"));
    if (schema.contains("maximum")) limits.push_back("of at most " + limit("maximum"));
    return limits.empty() ? noun : noun + " " + joined(limits, " and ");
}

/// "of 3 items", "of 1 to 100 items", "of at most 100 items", "of at least 1 item(s)"; empty without limits.
std::string countWords(const json& schema, const char* fewest_field, const char* most_field,
                       const std::string& noun) {
    const std::size_t fewest = schema.value(fewest_field, std::size_t{0});
    if (!schema.contains(most_field))
        return fewest == 0 ? "" : " of at least " + std::to_string(fewest) + " " + noun + "(s)";
    const std::size_t most = schema[most_field].get<std::size_t>();
    const std::string end = std::to_string(most) + " " + noun + "s";
    if (fewest == most) return " of " + end;
    return fewest == 0 ? " of at most " + end : " of " + std::to_string(fewest) + " to " + end;
}

std::string arrayWords(const json& schema) {
    return "a list" + countWords(schema, "minItems", "maxItems", "item");
}

std::string stringWords(const json& schema) {
    if (schema.contains("pattern")) return "a text like " + schema["pattern"].get<std::string>();
    if (schema.contains("maxLength"))
        return "a text" + countWords(schema, "minLength", "maxLength", "character");
    return schema.contains("minLength") ? "a text that is not empty" : "a text";
}

std::string typeWords(const json& schema, const std::string& type) {
    if (type == "number") return numberWords(schema, "a number");
    if (type == "integer") return numberWords(schema, "a whole number");
    if (type == "string") return stringWords(schema);
    if (type == "array") return arrayWords(schema);
    if (type == "boolean") return "true or false";
    if (type == "null") return "null";
    return "an object";
}

bool isOfType(const json& value, const std::string& type) {
    if (type == "number") return value.is_number();
    if (type == "integer") return value.is_number_integer();
    if (type == "string") return value.is_string();
    if (type == "array") return value.is_array();
    if (type == "boolean") return value.is_boolean();
    if (type == "null") return value.is_null();
    return value.is_object();
}

bool withinLimits(const json& schema, double value) {
    const auto limit = [&schema](const char* name) { return schema[name].get<double>(); };
    return !(schema.contains("exclusiveMinimum") && value <= limit("exclusiveMinimum")) &&
           !(schema.contains("minimum") && value < limit("minimum")) &&
           !(schema.contains("exclusiveMaximum") && value >= limit("exclusiveMaximum")) &&
           !(schema.contains("maximum") && value > limit("maximum"));
}

/// Characters, not bytes, as JSON schema counts them.
/// \pre the text is UTF-8
std::size_t lengthOf(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Patterns in schemas/ repeat nothing without bound, so that std::regex needs no deep stack for long texts.
bool textFits(const json& schema, const std::string& text) {
    const std::size_t length = lengthOf(text);
    if (length < schema.value("minLength", std::size_t{0})) return false;
    if (schema.contains("maxLength") && length > schema["maxLength"].get<std::size_t>()) return false;
    return !schema.contains("pattern") ||
           std::regex_search(text, std::regex(schema["pattern"].get<std::string>()));
}

/// The value's own type, limits and length; fields and items are looked at on their own.
bool fits(const json& schema, const json& value) {
    if (schema.contains("const") && value != schema["const"]) return false;
    if (schema.contains("enum")) {
        const json& allowed = schema["enum"];
        if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) return false;
    }
    const std::vector<std::string> types = typesOf(schema);
    if (!types.empty() && std::none_of(types.begin(), types.end(),
                                       [&](const std::string& type) { return isOfType(value, type); }))
        return false;
    if (value.is_number()) return withinLimits(schema, value.get<double>());
    if (value.is_array())
        return value.size() >= schema.value("minItems", std::size_t{0}) &&
               !(schema.contains("maxItems") && value.size() > schema["maxItems"].get<std::size_t>());
    return !value.is_string() || textFits(schema, value.get_ref<const std::string&>());
}

/// How many letters must be added, removed, changed or swapped with a neighbour's to turn one word into the
/// other.
std::size_t editDistance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1, 0));
    for (std::size_t i = 0; i <= a.size(); ++i)
        cost[i][0] = i;
    std::iota(cost[0].begin(), cost[0].end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            cost[i][j] = std::min({change, cost[i - 1][j] + 1, cost[i][j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
        }
    }
    return cost[a.size()][b.size()];
}

/// The known field a misspelt one most likely stands for; empty when none is near.
std::string nearestField(const std::string& name, const json& properties) {
    std::string nearest;
    std::size_t fewest_edits = std::min<std::size_t>(3, name.size() / 2 + 1);
    for (const auto& [known, schema] : properties.items()) {
        const std::size_t edits = editDistance(name, known);
        if (edits < fewest_edits) {
            fewest_edits = edits;
            nearest = known;
        }
    }
    return nearest;
}

std::string unknownFieldText(const std::string& name, const json& properties) {
    const std::string nearest = nearestField(name, properties);
    if (!nearest.empty()) return "unknown field; \"" + nearest + "\" is the nearest known one";
    std::vector<std::string> names;
    for (const auto& [known, schema] : properties.items())
        names.push_back(known);
    return "unknown field; expected one of " + joined(names, ", ");
}

}  // namespace

const json& SchemaWords::resolve(const json& schema) const {
    const json* node = &schema;
    while (node->is_object() && node->contains("$ref"))
        node = &root_.at(json::json_pointer((*node)["$ref"].get<std::string>().substr(1)));
    return *node;
}

const json* SchemaWords::child(const json& schema, const std::string& step) const {
    if (schema.contains("properties") && schema["properties"].contains(step))
        return &resolve(schema["properties"][step]);
    if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object())
        return &resolve(schema["additionalProperties"]);
    if (schema.contains("items")) return &resolve(schema["items"]);
    return nullptr;
}

const json* SchemaWords::find(const std::vector<std::string>& steps) const {
    const json* node = &resolve(root_);
    for (const std::string& step : steps) {
        node = child(*node, step);
        if (node == nullptr) return nullptr;
    }
    return node;
}

std::string SchemaWords::expectation(const json& schema) const {
    const json& node = resolve(schema);
    if (node.contains("const")) return node["const"].dump();
    if (node.contains("enum")) {
        std::vector<std::string> values;
        for (const json& value : node["enum"])
            values.push_back(value.dump());
        return values.size() == 1 ? values.front() : "one of " + joined(values, ", ");
    }
    std::vector<std::string> words;
    for (const std::string& type : typesOf(node))
        words.push_back(typeWords(node, type));
    return words.empty() ? "any value" : joined(words, " or ");
}

std::vector<CatalogFinding> SchemaWords::objectBreaches(const json& schema, const json& value,
                                                        const std::string& pointer) const {
    std::vector<CatalogFinding> findings;
    const json none = json::object();
    const json& properties = schema.contains("properties") ? schema["properties"] : none;
    const auto missing = [&](const std::string& name, const std::string& why) {
        const std::string what = properties.contains(name) ? ", " + expectation(properties[name]) : "";
        findings.push_back({pointer, "expected the field \"" + name + "\"" + what + why + ", found none"});
    };
    for (const json& name : schema.value("required", json::array()))
        if (!value.contains(name.get<std::string>())) missing(name.get<std::string>(), "");
    const json& dependencies = schema.contains("dependencies") ? schema["dependencies"] : none;
    for (const auto& [field, needed] : dependencies.items())
        for (const json& name : needed)
            if (value.contains(field) && !value.contains(name.get<std::string>()))
                missing(name.get<std::string>(), " beside \"" + field + "\"");
    if (schema.contains("additionalProperties") && schema["additionalProperties"] == false)
        for (const auto& [name, item] : value.items())
            if (!properties.contains(name))
                findings.push_back({childPointer(pointer, name), unknownFieldText(name, properties)});
    return findings;
}

std::vector<CatalogFinding> SchemaWords::breaches(const json& schema, const json& value,
                                                  const std::string& pointer) const {
    const json& node = resolve(schema);
    if (!fits(node, value)) return {{pointer, "expected " + expectation(node) + ", found " + quoted(value)}};
    return value.is_object() ? objectBreaches(node, value, pointer) : std::vector<CatalogFinding>{};
}

void SchemaWords::collectUnknown(const json& schema, const json& value, const std::string& pointer,
                                 std::vector<std::string>& unknown) const {
    const auto visit = [&](const std::string& step, const json& item, const std::string& item_pointer) {
        const json* item_schema = child(schema, step);
        if (item_schema == nullptr)
            unknown.push_back(item_pointer);
        else
            collectUnknown(*item_schema, item, item_pointer, unknown);
    };
    if (value.is_object())
        for (const auto& [name, item] : value.items())
            visit(name, item, childPointer(pointer, name));
    if (value.is_array())
        for (std::size_t i = 0; i < value.size(); ++i)
            visit(std::to_string(i), value[i], childPointer(pointer, i));
}

std::vector<std::string> SchemaWords::unknownFields(const json& value) const {
    std::vector<std::string> unknown;
    collectUnknown(resolve(root_), value, "#", unknown);
    return unknown;
}

}  // namespace stepmill
