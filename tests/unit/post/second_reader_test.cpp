#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "unit/post/gcode_reader.h"
#include "unit/post/sample_plan.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

bool onPath(const std::string& program_name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (fs::exists(fs::path(folder) / program_name)) return true;
    }
    return false;
}

/// A run of LinuxCNC's interpreter in a folder of its own: it keeps its tool table under HOME.
struct SecondReader {
    fs::path folder;
    int exit_code = -1;
    std::string output;
    std::string refusal;

    SecondReader(const std::string& text, const std::string& table) {
        folder = fs::temp_directory_path() / ("stepmill-post-" + std::to_string(getpid()));
        fs::create_directories(folder);
        std::ofstream(folder / "in.ngc") << text;
        std::ofstream(folder / "tool.tbl") << table;
        std::ofstream(folder / "rs274.var") << "";
        const std::string command =
            "cd '" + folder.string() +
            "' && HOME=\"$PWD\" timeout 60 rs274 -t tool.tbl -v rs274.var -g in.ngc out.txt"
            " </dev/null 2>err.txt";
        exit_code = std::system(command.c_str());
        output = read("out.txt");
        refusal = read("err.txt");
    }
    ~SecondReader() { fs::remove_all(folder); }
    SecondReader(const SecondReader&) = delete;
    SecondReader& operator=(const SecondReader&) = delete;

    std::string read(const char* name) const {
        std::ostringstream text;
        text << std::ifstream(folder / name).rdbuf();
        return text.str();
    }
    int count(const std::string& word) const {
        int found = 0;
        for (std::size_t at = output.find(word); at != std::string::npos; at = output.find(word, at + 1))
            ++found;
        return found;
    }
};

TEST(SecondReader, AcceptsTheProgramAndSeesEveryMotion) {
    if (!onPath("rs274")) GTEST_SKIP() << "LinuxCNC's rs274 is not installed";
    const Plan plan = samplePlan();
    const std::string text = program(plan, plan.setups[0]);
    const SecondReader reader(text, toolTable(plan, plan.setups[0]));
    ASSERT_EQ(reader.exit_code, 0) << reader.refusal << text;
    const Program read = readProgram(text);
    int lines = 0;
    int arcs = 0;
    int rapids = 0;
    for (const Block& block : read.blocks)
        ++(block.g == 0 ? rapids : block.g == 1 ? lines : arcs);
    EXPECT_EQ(reader.count("STRAIGHT_TRAVERSE("), rapids);
    EXPECT_EQ(reader.count("STRAIGHT_FEED("), lines);
    EXPECT_EQ(reader.count("ARC_FEED("), arcs);
    EXPECT_EQ(reader.count("CHANGE_TOOL("), 2);
    EXPECT_EQ(reader.count("PROGRAM_END("), 1);
}

TEST(SecondReader, RefusesAToolTheTableLacks) {
    if (!onPath("rs274")) GTEST_SKIP() << "LinuxCNC's rs274 is not installed";
    const Plan plan = samplePlan();
    const SecondReader reader(program(plan, plan.setups[0]), "T3 P3 Z0 D10 ;EM10\n");
    EXPECT_NE(reader.exit_code, 0);
}

}  // namespace
}  // namespace stepmill::test
