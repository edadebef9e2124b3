#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "support/planned_parts.h"
#include "support/text_file.h"

namespace stepmill::test {

using Words = std::vector<std::string>;

inline ProgramRun verify(const std::filesystem::path& dir, Words options = {}) {
    options.insert(options.begin(), {stepmillBinary(), "verify", dir.string()});
    return runProgram(options);
}

/// A library with which the rounded pocket takes a roughing and a rest operation.
inline const Words kWithTwoTools{
    "--tools", std::string(STEPMILL_SOURCE_DIR) + "/tests/corpus/verify_plans/two_tools.json"};

/// A plan of the rounded pocket whose program can be spoilt.
class SpoiltProgram : public testing::Test {
  protected:
    void SetUp() override {
        copyOfPlan(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + part(), dir_, options());
        std::ifstream file(dir_ / "S1.ngc");
        for (std::string line; std::getline(file, line);)
            lines_.push_back(line);
    }

    virtual std::string part() const { return "rounded_pocket.step"; }
    virtual Words options() const { return kWithTwoTools; }

    /// Index of the first line from `after` on with these words.
    std::size_t find(const std::string& words, std::size_t after = 0) const {
        for (std::size_t i = after; i < lines_.size(); ++i)
            if (lines_[i].find(words) != std::string::npos) return i;
        ADD_FAILURE() << "no line with '" << words << "'";
        return 0;
    }

    void replace(std::size_t index, const std::string& words, const std::string& by) {
        std::string& line = lines_[index];
        const std::size_t at = line.find(words);
        ASSERT_NE(at, std::string::npos) << line;
        line.replace(at, words.size(), by);
    }

    ProgramRun verifySpoilt() const {
        std::ofstream file(dir_ / "S1.ngc");
        for (const std::string& line : lines_)
            file << line << '\n';
        file.close();
        return verify(dir_);
    }

    void expectFails(std::size_t index, const std::string& words) const {
        const ProgramRun run = verifySpoilt();
        EXPECT_EQ(run.exit_code, 2) << run.out << run.err;
        const std::string place = fmt::format("S1.ngc, line {}: ", index + 1);
        const std::size_t at = run.out.find(place);
        ASSERT_NE(at, std::string::npos) << place << " is not named in\n" << run.out;
        const std::string complaint = run.out.substr(at, run.out.find('\n', at) - at);
        EXPECT_NE(complaint.find(words), std::string::npos) << complaint;
    }

    void expectRefused(std::size_t index, const std::string& words) const {
        const ProgramRun run = verifySpoilt();
        EXPECT_EQ(run.exit_code, 2) << run.out << run.err;
        EXPECT_NE(run.err.find(fmt::format("S1.ngc, line {}: ", index + 1)), std::string::npos) << run.err;
        EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    }

    /// The straight feed whose X lies farthest left, which is along the left wall; of the lines before `end`.
    std::size_t wallLine(double& x, std::size_t end) const {
        std::size_t found = 0;
        x = 1e9;
        for (std::size_t i = 0; i < end; ++i) {
            const std::size_t at = lines_[i].find(" X");
            if (lines_[i].find("G1 ") == std::string::npos || at == std::string::npos) continue;
            const double here = std::stod(lines_[i].substr(at + 2));
            if (here < x) {
                x = here;
                found = i;
            }
        }
        return found;
    }

    TemporaryFolder folder_;
    std::filesystem::path dir_ = std::filesystem::path(folder_.path()) / "plan";
    std::vector<std::string> lines_;
};

}  // namespace stepmill::test
