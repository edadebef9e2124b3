#include "crib/json_reader.h"

#include "crib/tool_maker.h"
#include "stepmill/catalog/json_text.h"
#include "stepmill/core/plain_text.h"

namespace stepmill::crib {

using nlohmann::json;

json JsonReader::parse(std::string_view text, const std::string& file) {
    ParsedJson parsed = parseJson(withoutByteOrderMark(text));
    if (!parsed.findings.empty()) refuse(file, parsed.findings.front().pointer, parsed.findings.front().text);
    return std::move(parsed.value);
}

const json* JsonReader::find(const char* field) const {
    if (!value_.is_object()) return nullptr;
    const auto found = value_.find(field);
    return found == value_.end() || found->is_null() ? nullptr : &*found;
}

std::optional<JsonReader> JsonReader::object(const char* field) const {
    const json* found = find(field);
    if (found == nullptr) return std::nullopt;
    if (!found->is_object()) refuseField(field, "an object");
    return JsonReader(*found, file_, childPointer(pointer_, field));
}

std::vector<JsonReader> JsonReader::list(const char* field) const {
    std::vector<JsonReader> items;
    const json* found = find(field);
    if (found == nullptr) return items;
    if (!found->is_array()) refuseField(field, "a list");
    for (std::size_t i = 0; i < found->size(); ++i) {
        const std::string pointer = childPointer(childPointer(pointer_, field), i);
        if (!(*found)[i].is_object())
            refuse(file_, pointer, "expected an object, found " + quoted((*found)[i]));
        items.emplace_back((*found)[i], file_, pointer);
    }
    return items;
}

std::string JsonReader::text(const char* field) const {
    const json* found = find(field);
    if (found == nullptr) return {};
    if (!found->is_string()) refuseField(field, "a text");
    return found->get<std::string>();
}

double JsonReader::number(const char* field) const {
    const json* found = find(field);
    if (found == nullptr) return 0;
    if (!found->is_number() || !std::isfinite(found->get<double>())) refuseField(field, "a number");
    return found->get<double>();
}

double JsonReader::positive(const char* field) const {
    const double value = number(field);
    if (value < 0) refuseField(field, "a number of 0 or more");
    return value;
}

bool JsonReader::flag(const char* field, bool otherwise) const {
    const json* found = find(field);
    if (found == nullptr) return otherwise;
    if (!found->is_boolean()) refuseField(field, "true or false");
    return found->get<bool>();
}

void JsonReader::refuseField(const char* field, const std::string& expected) const {
    const json* found = find(field);
    refuse(file_, childPointer(pointer_, field),
           "expected " + expected + ", found " + (found == nullptr ? "nothing" : quoted(*found)));
}

}  // namespace stepmill::crib
