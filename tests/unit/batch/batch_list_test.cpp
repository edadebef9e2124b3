#include "stepmill/batch/batch_list.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "support/run_program.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

class BatchList : public testing::Test {
  protected:
    void file(const std::string& name) const {
        fs::create_directories((root_ / name).parent_path());
        std::ofstream(root_ / name) << "x";
    }

    std::vector<std::string> found() const {
        std::vector<std::string> names;
        for (const ListedPart& part : findParts(root_, root_ / "out"))
            names.push_back(part.name);
        return names;
    }

    test::TemporaryFolder folder_;
    fs::path root_ = fs::path(folder_.path()) / "parts";
};

using Names = std::vector<std::string>;

TEST_F(BatchList, FindsStepFilesOfAllFoldersByName) {
    for (const char* name : {"b.STEP", "a/z.stp", "a/deep/er.p21", "notes.txt", "a.step", "A.StP"})
        file(name);
    EXPECT_EQ(found(), (Names{"A.StP", "a.step", "a/deep/er.p21", "a/z.stp", "b.STEP"}));
}

TEST_F(BatchList, LeavesTheBatchItselfHiddenFoldersAndLinksToFoldersOut) {
    for (const char* name : {"a.step", "out/jobs/x.step", ".trash/b.step", "sub/c.step"})
        file(name);
    fs::create_directory_symlink(root_ / "sub", root_ / "link");
    fs::create_directory(root_ / "folder.step");
    EXPECT_EQ(found(), (Names{"a.step", "sub/c.step"}));
}

TEST_F(BatchList, NamesOfAnyBytesStayAsTheyAre) {
    const Names hostile{"\n.step", " .step", "'; rm -rf .step", "-o.step", "<b>.step", "\xff\xfe.step"};
    for (const std::string& name : hostile)
        file(name);
    Names sorted = hostile;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(found(), sorted);
}

TEST_F(BatchList, AFolderThatIsNotThereIsAnError) {
    EXPECT_THROW(findParts(root_, root_ / "out"), Error);
}

TEST_F(BatchList, OfNoPartsIsAnError) {
    file("notes.txt");
    EXPECT_THROW(findParts(root_, root_ / "out"), Error);
    EXPECT_THROW(readPartList("list.csv", "file,quantity\n"), Error);
}

TEST_F(BatchList, ReadsRowsByTheNamesOfTheirColumns) {
    const auto parts = readPartList("/orders/march.csv",
                                    "\xEF\xBB\xBFquantity,file,due,options,material\r\n"
                                    "10,a.step,2026-12-01,\"--setup +z --stock-margin 2,1,0\",steel\r\n"
                                    "\r\n"
                                    ",\"sub/b \"\"best\"\".step\"\r\n");
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].file, "/orders/a.step");
    EXPECT_EQ(parts[0].quantity, 10);
    EXPECT_EQ(parts[0].due, "2026-12-01");
    EXPECT_EQ(parts[0].options, "--setup +z --stock-margin 2,1,0");
    EXPECT_EQ(parts[0].material, "steel");
    EXPECT_EQ(parts[1].name, "sub/b \"best\".step");
    EXPECT_EQ(parts[1].quantity, 1);
}

/// What readPartList says of a list it refuses; empty where it takes it.
std::string refusal(const std::string& text) {
    try {
        readPartList("list.csv", text);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST_F(BatchList, AListThatMakesNoSenseIsRefusedWithItsLine) {
    EXPECT_NE(refusal("").find("list.csv"), std::string::npos);
    EXPECT_NE(refusal("quantity\n1\n").find("line 1"), std::string::npos);
    EXPECT_NE(refusal("file,colour\na.step,red\n").find("colour"), std::string::npos);
    EXPECT_NE(refusal("file,file\n").find("line 1"), std::string::npos);
    EXPECT_NE(refusal("file\na.step\na,b\n").find("line 3"), std::string::npos);
    EXPECT_NE(refusal("file\n\"a.step\n").find("line 2"), std::string::npos);
    for (const char* quantity : {"0", "-1", "1.5", "many", "99999999999"})
        EXPECT_NE(refusal(std::string("file,quantity\na.step,") + quantity + "\n").find("line 2"),
                  std::string::npos)
            << quantity;
}

/// The system takes a name to end at its first zero byte: another part would be planned under that name.
TEST_F(BatchList, AZeroByteIsRefusedWithItsLine) {
    const std::string row("file\na.step\nb.step\0c.step\n", 24);
    EXPECT_NE(refusal(row).find("line 3: expected UTF-8 text"), std::string::npos) << refusal(row);
    const std::string utf16(
        "\xFF\xFE"
        "f\0i\0l\0e\0",
        10);
    EXPECT_NE(refusal(utf16).find("UTF-16"), std::string::npos) << refusal(utf16);
}

TEST_F(BatchList, LinesWithinQuotesCount) {
    EXPECT_NE(refusal("file,due\n\"a\nb.step\",\n,x\n").find("line 4"), std::string::npos);
}

TEST(SafeFolderNames, AreOfLettersAndTellAlikesApart) {
    for (const char* name : {"", ".", "..", "-o", "a/b", "\n\xff", "$(x)", "a b"}) {
        const std::string safe = safeFolderName(name, "x");
        EXPECT_EQ(safe.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.-"), std::string::npos)
            << safe;
        EXPECT_NE(safe.front(), '.');
        EXPECT_NE(safe.front(), '-');
    }
    EXPECT_EQ(safeFolderName("a_b", "x").substr(0, 4), safeFolderName("a/b", "y").substr(0, 4));
    EXPECT_NE(safeFolderName("a_b", "x"), safeFolderName("a/b", "y"));
    EXPECT_LT(safeFolderName(std::string(5000, 'a'), "x").size(), 100U);
}

}  // namespace
}  // namespace stepmill
