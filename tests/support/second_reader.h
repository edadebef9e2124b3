#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "stepmill/part/part.h"
#include "stepmill/planar/region.h"
#include "support/run_program.h"
#include "support/text_file.h"

namespace stepmill::test {

/// Is LinuxCNC's stand-alone interpreter here?
inline bool hasSecondReader() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (std::filesystem::exists(std::filesystem::path(folder) / "rs274")) return true;
    return false;
}

/// Every CI sets CI: there the second reader must be installed. Elsewhere its tests are skipped without it.
#define STEPMILL_NEEDS_SECOND_READER()                                                 \
    if (!::stepmill::test::hasSecondReader()) {                                        \
        if (std::getenv("CI") != nullptr) FAIL() << "rs274 must be installed in CI";   \
        GTEST_SKIP() << "LinuxCNC's rs274 is not installed (package linuxcnc-uspace)"; \
    }

/// A motion as LinuxCNC's interpreter passes it on.
struct CanonMotion {
    enum class Kind { Rapid, Feed, Arc };
    Kind kind = Kind::Rapid;
    Vec3 to = Vec3::Zero();
    Vec2 centre = Vec2::Zero();
    int turn = 0;  ///< +1 counter-clockwise, -1 clockwise
    double feed_mm_per_min = 0;
    std::string n_word;
};

/// The motions after one operation's comment.
struct CanonOperation {
    std::string id;
    int tool = 0;
    std::vector<CanonMotion> motions;
};

/// A run of LinuxCNC's interpreter in a folder of its own: it keeps its tool table under HOME.
class SecondReader {
  public:
    /// \param variables  of the interpreter, "number value" a line; offsets are in inches
    SecondReader(const std::string& text, const std::string& table, const std::string& variables = "") {
        namespace fs = std::filesystem;
        const fs::path folder = folder_.path();
        std::ofstream(folder / "in.ngc") << text;
        std::ofstream(folder / "tool.tbl") << table;
        std::ofstream(folder / "rs274.var") << variables;
        const std::string command =
            "cd '" + folder.string() +
            "' && HOME=\"$PWD\" timeout 60 rs274 -t tool.tbl -v rs274.var -g in.ngc out.txt"
            " </dev/null 2>err.txt";
        exit_code = std::system(command.c_str());
        output = slurp(folder / "out.txt");
        refusal = slurp(folder / "err.txt");
        parse();
    }

    int count(const std::string& word) const {
        int found = 0;
        for (std::size_t at = output.find(word); at != std::string::npos; at = output.find(word, at + 1))
            ++found;
        return found;
    }

    int exit_code = -1;
    std::string output;
    std::string refusal;
    std::vector<CanonOperation> operations;

  private:
    void parse() {
        std::istringstream lines(output);
        double feed = 0;
        int tool = 0;
        for (std::string line; std::getline(lines, line);) {
            const std::size_t open = line.find('(');
            if (open == std::string::npos) continue;
            std::istringstream head(line.substr(0, open));
            std::string number;
            std::string n_word;
            std::string call;
            head >> number >> n_word >> call;
            const std::string inside = line.substr(open + 1, line.rfind(')') - open - 1);
            if (call == "COMMENT") {
                noteOperation(inside);
            } else if (call == "SELECT_TOOL") {
                tool = std::stoi(inside);
            } else if (call == "SET_FEED_RATE") {
                feed = std::stod(inside);
            } else if (call == "STRAIGHT_TRAVERSE" || call == "STRAIGHT_FEED" || call == "ARC_FEED") {
                if (operations.empty()) operations.emplace_back();
                operations.back().tool = tool;
                operations.back().motions.push_back(motion(call, numbers(inside), feed, n_word));
            }
        }
    }

    void noteOperation(const std::string& comment) {
        const std::string first = comment.substr(1, comment.find(' ') - 1);
        if (first.find(".O") == std::string::npos) return;
        operations.emplace_back();
        operations.back().id = first;
    }

    static std::vector<double> numbers(const std::string& text) {
        std::vector<double> values;
        std::istringstream items(text);
        for (std::string item; std::getline(items, item, ',');)
            values.push_back(std::stod(item));
        return values;
    }

    static CanonMotion motion(const std::string& call, const std::vector<double>& v, double feed,
                              const std::string& n_word) {
        CanonMotion motion;
        motion.n_word = n_word;
        if (call == "ARC_FEED") {
            motion.kind = CanonMotion::Kind::Arc;
            motion.to = Vec3(v.at(0), v.at(1), v.at(5));
            motion.centre = Vec2(v.at(2), v.at(3));
            motion.turn = static_cast<int>(v.at(4));
        } else {
            motion.kind = call == "STRAIGHT_FEED" ? CanonMotion::Kind::Feed : CanonMotion::Kind::Rapid;
            motion.to = Vec3(v.at(0), v.at(1), v.at(2));
        }
        motion.feed_mm_per_min = motion.kind == CanonMotion::Kind::Rapid ? 0 : feed;
        return motion;
    }

    TemporaryFolder folder_;
};

}  // namespace stepmill::test
