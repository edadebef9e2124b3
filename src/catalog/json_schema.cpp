#include "stepmill/catalog/json_schema.h"

#include <algorithm>
#include <map>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "catalog/embedded.h"
#include "catalog/json_layout.h"
#include "catalog/schema_check.h"
#include "catalog/schema_words.h"
#include "stepmill/catalog/json_text.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

using nlohmann::json;
using Steps = std::vector<std::string>;

/// valijson writes a place as {"<root>", "[tools]", "[3]", "[diameter]"}.
Steps stepsOf(const Steps& context) {
    Steps steps;
    for (std::size_t i = 1; i < context.size(); ++i)
        steps.push_back(context[i].substr(1, context[i].size() - 2));
    return steps;
}

bool startsWith(const Steps& steps, const Steps& beginning) {
    return steps.size() > beginning.size() && std::equal(beginning.begin(), beginning.end(), steps.begin());
}

struct Place {
    const json* value;
    std::string pointer;
};

Place placeOf(const json& root, const Steps& steps) {
    Place place{&root, "#"};
    for (const std::string& step : steps) {
        const bool in_list = place.value->is_array();
        place.value = in_list ? &place.value->at(std::stoul(step)) : &place.value->at(step);
        place.pointer = childPointer(place.pointer, step);
    }
    return place;
}

/// Document order: list items by number, not by digit.
bool comesBefore(const Steps& a, const Steps& b) {
    const auto is_number = [](const std::string& s) {
        return !s.empty() && s.find_first_not_of("0123456789") == std::string::npos;
    };
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                        [&](const std::string& x, const std::string& y) {
                                            if (is_number(x) && is_number(y) && x.size() != y.size())
                                                return x.size() < y.size();
                                            return x < y;
                                        });
}

/// A compiled-in schema, the word it is known by ("plan" for plan.schema.json and plan.json), and the version
/// of the files that it describes.
struct NamedSchema {
    SchemaName name;
    std::string_view word;
    int format;
    const std::string_view& text;  ///< set before main() begins, in another file
};

constexpr NamedSchema kSchemas[] = {
    {SchemaName::Tools, "tools", 1, embedded::kToolsSchema},
    {SchemaName::Machine, "machine", 1, embedded::kMachineSchema},
    {SchemaName::Plan, "plan", 2, embedded::kPlanSchema},
    {SchemaName::Inspect, "inspect", 1, embedded::kInspectSchema},
    {SchemaName::Rank, "rank", 1, embedded::kRankSchema},
    {SchemaName::Fixtures, "fixtures", 1, embedded::kFixturesSchema},
    {SchemaName::Holes, "holes", 1, embedded::kHolesSchema},
    {SchemaName::Verify, "verify", 1, embedded::kVerifySchema},
    {SchemaName::Manifest, "manifest", 1, embedded::kManifestSchema},
    {SchemaName::Quote, "quote", 1, embedded::kQuoteSchema},
    {SchemaName::Job, "job", 1, embedded::kJobSchema},
    {SchemaName::Materials, "materials", 1, embedded::kMaterialsSchema},
    {SchemaName::CuttingData, "cutting-data", 1, embedded::kCuttingDataSchema},
    {SchemaName::Replan, "replan", 1, embedded::kReplanSchema}};

const NamedSchema& schemaOf(SchemaName name) {
    for (const NamedSchema& schema : kSchemas)
        if (schema.name == name) return schema;
    throw Error(ErrorCode::Internal, "schema", "unknown value");
}

using FailedPlaces = std::map<Steps, std::string, bool (*)(const Steps&, const Steps&)>;

/// Every place valijson reports with its first remark there.
FailedPlaces failedPlaces(const json& schema_json, const json& value) {
    valijson::Schema schema;
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_json), schema);
    valijson::Validator validator(valijson::Validator::kStrongTypes);
    valijson::ValidationResults results;
    FailedPlaces places(&comesBefore);
    if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(value), &results)) return places;
    for (const auto& error : results)
        places.emplace(stepsOf(error.context), error.description);
    if (places.empty()) places.emplace(Steps{}, "breaks the schema");
    return places;
}

}  // namespace

std::string_view schemaText(SchemaName name) {
    return schemaOf(name).text;
}

int schemaFormat(SchemaName name) {
    return schemaOf(name).format;
}

json schemaJson(SchemaName name) {
    ParsedJson parsed = parseJson(schemaText(name));
    STEPMILL_CHECK(parsed.findings.empty(), "a compiled-in schema is not JSON");
    return std::move(parsed.value);
}

std::vector<CatalogFinding> checkSchema(const json& schema, const json& value) {
    const FailedPlaces places = failedPlaces(schema, value);
    const SchemaWords words(schema);
    std::vector<CatalogFinding> findings;
    for (auto place = places.begin(); place != places.end(); ++place) {
        const Steps& steps = place->first;
        const Place where = placeOf(value, steps);
        const json* place_schema = words.find(steps);
        std::vector<CatalogFinding> causes;
        if (place_schema != nullptr) causes = words.breaches(*place_schema, *where.value, where.pointer);
        // valijson reports every container of a faulty value too; such a place has no cause of its own.
        const auto next = std::next(place);
        const bool fault_is_inside = next != places.end() && startsWith(next->first, steps);
        if (causes.empty() && !fault_is_inside) causes.push_back({where.pointer, place->second});
        findings.insert(findings.end(), causes.begin(), causes.end());
    }
    return findings;
}

ParsedJson checkedJson(std::string_view text, const json& schema) {
    ParsedJson parsed = parseJson(text);
    if (parsed.findings.empty()) parsed.findings = checkSchema(schema, parsed.value);
    return parsed;
}

void throwFirstError(const std::vector<CatalogFinding>& findings, const std::string& file_name) {
    const auto is_error = [](const CatalogFinding& finding) { return !finding.doubt; };
    const auto first = std::find_if(findings.begin(), findings.end(), is_error);
    if (first == findings.end()) return;
    const auto count = std::count_if(findings.begin(), findings.end(), is_error);
    const std::string others = count == 1 ? "" : " (and " + std::to_string(count - 1) + " more in this file)";
    throw Error(ErrorCode::InvalidCatalog, file_name + first->pointer, first->text + others);
}

std::vector<std::string> schemaErrors(SchemaName name, std::string_view json_text) {
    const ParsedJson parsed = parseJson(json_text);
    std::vector<CatalogFinding> findings = parsed.findings;
    if (!parsed.value.is_discarded()) {
        const std::vector<CatalogFinding> breaches = checkSchema(schemaJson(name), parsed.value);
        findings.insert(findings.end(), breaches.begin(), breaches.end());
    }
    std::vector<std::string> lines;
    lines.reserve(findings.size());
    for (const CatalogFinding& finding : findings)
        lines.push_back(finding.pointer + ": " + finding.text);
    return lines;
}

std::string finishJson(SchemaName name, nlohmann::ordered_json content) {
    const NamedSchema& schema = schemaOf(name);
    nlohmann::ordered_json json{{"format", schema.format}, {"stepmill", {{"version", STEPMILL_VERSION}}}};
    for (auto& [key, value] : content.items())
        json[key] = std::move(value);
    std::string text = laidOut(json) + "\n";
    const std::vector<std::string> errors = schemaErrors(name, text);
    if (!errors.empty()) throw Error(ErrorCode::Internal, std::string(schema.word) + ".json", errors.front());
    return text;
}

}  // namespace stepmill
