#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "stepmill/part/part.h"
#include "stepmill/planar/region.h"
#include "support/canon_run.h"
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
        double feed = 0;
        int tool = 0;
        double speed_rpm = 0;
        double pitch = 0;
        for (const CanonCall& call : canonCalls(output)) {
            if (call.name == "COMMENT") {
                noteOperation(call.inside);
            } else if (call.name == "SELECT_TOOL") {
                tool = std::stoi(call.inside);
            } else if (call.name == "SET_FEED_RATE") {
                feed = std::stod(call.inside);
            } else if (call.name == "SET_SPINDLE_SPEED") {
                speed_rpm = call.numbers().at(1);
            } else if (call.name == "START_SPEED_FEED_SYNC") {
                pitch = call.numbers().at(0);
            } else if (call.name == "RIGID_TAP") {
                addTapping(call, pitch * speed_rpm);
            } else if (call.name == "STRAIGHT_TRAVERSE" || call.name == "STRAIGHT_FEED" ||
                       call.name == "ARC_FEED") {
                if (operations.empty()) operations.emplace_back();
                operations.back().tool = tool;
                operations.back().motions.push_back(motion(call, feed));
            }
        }
    }

    /// Down, and back up to where it began.
    void addTapping(const CanonCall& call, double feed_mm_per_min) {
        const std::vector<double> v = call.numbers();
        std::vector<CanonMotion>& motions = operations.back().motions;
        const Vec3 from = motions.back().to;
        for (const Vec3& to : {Vec3(v.at(0), v.at(1), v.at(2)), from}) {
            CanonMotion motion;
            motion.kind = CanonMotion::Kind::Feed;
            motion.to = to;
            motion.feed_mm_per_min = feed_mm_per_min;
            motion.n_word = call.n_word;
            motions.push_back(motion);
        }
    }

    void noteOperation(const std::string& comment) {
        const std::string first = comment.substr(1, comment.find(' ') - 1);
        if (first.find(".O") == std::string::npos) return;
        operations.emplace_back();
        operations.back().id = first;
    }

    static CanonMotion motion(const CanonCall& call, double feed) {
        const std::vector<double> v = call.numbers();
        CanonMotion motion;
        motion.n_word = call.n_word;
        if (call.name == "ARC_FEED") {
            motion.kind = CanonMotion::Kind::Arc;
            motion.to = Vec3(v.at(0), v.at(1), v.at(5));
            motion.centre = Vec2(v.at(2), v.at(3));
            motion.turn = static_cast<int>(v.at(4));
        } else {
            motion.kind = call.name == "STRAIGHT_FEED" ? CanonMotion::Kind::Feed : CanonMotion::Kind::Rapid;
            motion.to = Vec3(v.at(0), v.at(1), v.at(2));
        }
        motion.feed_mm_per_min = motion.kind == CanonMotion::Kind::Rapid ? 0 : feed;
        return motion;
    }

    TemporaryFolder folder_;
};

}  // namespace stepmill::test
