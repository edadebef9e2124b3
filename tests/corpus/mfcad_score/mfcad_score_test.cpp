// Labelled parts of the MFCAD data set: faces named as their labels say, books that close.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Share of faces whose class agrees with the label, at least.
constexpr double kGoal = 0.97;
/// Volumes by slab and by feature agree to this share [features.md].
constexpr double kBooksShare = 1e-3;

/// Labels in the order of TopExp_Explorer, by file name; nothing where the folder is missing.
Json readLabels(const std::vector<std::string>& parts) {
    if (parts.empty()) return {};
    std::ifstream file(fs::path(parts.front()).parent_path() / "labels_explorer.json");
    return Json::parse(file);
}

using Confusion = std::map<std::string, std::map<std::string, int>>;

void print(const Confusion& confusion) {
    for (const auto& [label, found] : confusion) {
        std::string row;
        for (const auto& [name, count] : found)
            row += fmt::format("  {} {}", count, name);
        fmt::print("{:<26} ->{}\n", label, row);
    }
}

TEST(MfcadScore, FacesAreNamedAsTheirLabelsSayAndBooksClose) {
    const std::vector<std::string> parts = sharedParts("mfcad");
    if (parts.empty()) GTEST_SKIP() << "the folder of STEP parts is not beside this checkout";
    const Json labels = readLabels(parts);
    Confusion confusion;
    int faces = 0;
    int right = 0;
    for (const std::string& part : parts) {
        const std::string name = fs::path(part).filename().string();
        const ProgramRun run = runProgram({stepmillBinary(), "inspect", part, "--json"});
        ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 1) << name << ": " << run.err;
        const Json inspection = Json::parse(run.out);
        EXPECT_LE(inspection.at("books").at("gap_share").get<double>(), kBooksShare) << name;
        const Json& wanted = labels.at(name);
        ASSERT_EQ(inspection.at("faces").size(), wanted.size()) << name;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const Json& found = inspection.at("faces")[i].at("mfcad_class");
            const std::string found_name = found.is_null() ? "none" : found.get<std::string>();
            const std::string label = wanted[i];
            ++faces;
            right += found_name == label ? 1 : 0;
            ++confusion[label][found_name];
            if (found_name != label) fmt::print("{} face {}: {} for {}\n", name, i, found_name, label);
        }
    }
    print(confusion);
    fmt::print("{} of {} faces, {:.2f} %\n", right, faces, 100.0 * right / faces);
    EXPECT_GE(right, kGoal * faces);
}

}  // namespace
}  // namespace stepmill::test
