#include "support/expected_outcomes.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <ostream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
// Rows keep the file's order.
using Json = nlohmann::ordered_json;

template <typename Value>
Value valueOf(const std::map<std::string, Value>& words, const std::string& word) {
    const auto found = words.find(word);
    if (found == words.end()) throw std::runtime_error("expected_outcomes.json: '" + word + "'");
    return found->second;
}

Outcome outcomeFrom(const std::string& word) {
    static const std::map<std::string, Outcome> kWords{{"planned", Outcome::Planned},
                                                       {"gaps", Outcome::Gaps},
                                                       {"refused", Outcome::Refused},
                                                       {"too slow", Outcome::TooSlow}};
    return valueOf(kWords, word);
}

ErrorCode refusalFrom(const std::string& word) {
    using enum ErrorCode;
    static const std::map<std::string, ErrorCode> kWords{
        {"NotStep", NotStep},     {"StepDamaged", StepDamaged},   {"NoSolid", NoSolid},
        {"OpenShell", OpenShell}, {"InvalidSolid", InvalidSolid}, {"ImplausibleSize", ImplausibleSize}};
    return valueOf(kWords, word);
}

ExpectedOutcome rowFrom(const std::string& part, const Json& fields) {
    ExpectedOutcome row;
    row.part = part;
    const fs::path path = fs::path(folderOfParts(fs::path(part).parent_path())) / fs::path(part).filename();
    if (fs::exists(path)) row.path = path;
    row.outcome = outcomeFrom(fields.at("outcome"));
    row.cpu_s = fields.at("cpu_s");
    if (fields.contains("import")) row.refusal = refusalFrom(fields.at("import"));
    row.solids = fields.value("solids", 1);
    row.slow = fields.value("slow", false);
    row.slow_proofs = fields.value("slow_proofs", false);
    return row;
}

/// "mfcad/*" stands for every n-th file of the folder, n as its row says.
void addPattern(const std::string& folder, const Json& fields, std::vector<ExpectedOutcome>& rows) {
    const std::vector<std::string> parts = sharedParts(folder);
    for (std::size_t i = 0; i < parts.size(); i += fields.at("every").get<std::size_t>())
        rows.push_back(rowFrom(folder + "/" + fs::path(parts[i]).filename().string(), fields));
}

std::vector<ExpectedOutcome> readTable() {
    std::ifstream file(std::string(STEPMILL_SOURCE_DIR) + "/tests/corpus/expected_outcomes.json");
    const Json table = Json::parse(file);
    std::vector<ExpectedOutcome> rows;
    for (const auto& [part, fields] : table.at("parts").items()) {
        if (part.ends_with("/*"))
            addPattern(part.substr(0, part.size() - 2), fields, rows);
        else
            rows.push_back(rowFrom(part, fields));
    }
    return rows;
}

std::string folderOf(const ExpectedOutcome& expected) {
    return fs::path(expected.part).parent_path();
}

}  // namespace

void PrintTo(const ExpectedOutcome& expected, std::ostream* out) {
    *out << expected.part;
}

const std::vector<ExpectedOutcome>& expectedOutcomes() {
    static const std::vector<ExpectedOutcome> rows = readTable();
    return rows;
}

std::vector<ExpectedOutcome> expectedOf(const std::string& folder) {
    std::vector<ExpectedOutcome> rows;
    for (const ExpectedOutcome& expected : expectedOutcomes())
        if (folderOf(expected) == folder) rows.push_back(expected);
    return rows;
}

std::vector<ExpectedOutcome> expectedRows(const std::vector<std::string>& parts) {
    std::vector<ExpectedOutcome> rows;
    for (const ExpectedOutcome& expected : expectedOutcomes())
        if (std::find(parts.begin(), parts.end(), expected.part) != parts.end()) rows.push_back(expected);
    return rows;
}

std::vector<ExpectedOutcome> expectedPlans(const std::vector<std::string>& folders) {
    std::vector<ExpectedOutcome> rows;
    for (const std::string& folder : folders)
        for (const ExpectedOutcome& expected : expectedOf(folder))
            if (expected.hasPlan() && !expected.slow) rows.push_back(expected);
    return rows;
}

std::vector<ExpectedOutcome> slowPlans() {
    std::vector<ExpectedOutcome> rows;
    for (const ExpectedOutcome& expected : expectedOutcomes())
        if (expected.hasPlan() && expected.slow) rows.push_back(expected);
    return rows;
}

std::vector<ExpectedOutcome> withSlowProofs(std::vector<ExpectedOutcome> rows, bool slow) {
    std::erase_if(rows, [slow](const ExpectedOutcome& row) { return (row.slow || row.slow_proofs) != slow; });
    return rows;
}

std::string testName(const ExpectedOutcome& expected) {
    std::string name = fs::path(expected.part).replace_extension();
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
}

std::string folderOfParts(const std::string& folder) {
    const fs::path source = STEPMILL_SOURCE_DIR;
    const fs::path path =
        folder == "step_parts" ? source / folder : source.parent_path() / "shared" / "parts" / folder;
    return fs::is_directory(path) ? path.string() : "";
}

}  // namespace stepmill::test
