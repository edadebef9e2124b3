#include "stepmill/core/file.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <stdlib.h>

#include "stepmill/core/error.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

class FileTest : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "stepmill-file-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_;
};

template <class Work>
std::optional<ErrorCode> codeOf(Work&& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.code();
    }
    return std::nullopt;
}

// Test vectors of FIPS 180-4 as NIST publishes them.
TEST(Sha256, MatchesPublishedVectors) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_F(FileTest, ReadsBackWhatItWrote) {
    const std::string bytes("a\0b\r\n\xff", 6);
    writeFile(folder_ / "x.bin", bytes);
    EXPECT_EQ(readFile(folder_ / "x.bin"), bytes);
}

TEST_F(FileTest, WritingReplacesTheOldFileAndLeavesNothingElse) {
    writeFile(folder_ / "x", "first, longer");
    writeFile(folder_ / "x", "second");
    EXPECT_EQ(readFile(folder_ / "x"), "second");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(FileTest, MissingFileAndFolderAreUnreadable) {
    EXPECT_EQ(codeOf([&] { readFile(folder_ / "missing"); }), ErrorCode::FileUnreadable);
    EXPECT_EQ(codeOf([&] { readFile(folder_); }), ErrorCode::FileUnreadable);
}

TEST_F(FileTest, UnreadableErrorNamesTheFile) {
    try {
        readFile(folder_ / "missing.step");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.subject(), (folder_ / "missing.step").string());
    }
}

TEST_F(FileTest, WritingIntoAMissingFolderOrOverAFolderIsAnErrorAndLeavesNothing) {
    EXPECT_EQ(codeOf([&] { writeFile(folder_ / "no" / "x", "data"); }), ErrorCode::OutputUnwritable);
    fs::create_directory(folder_ / "taken");
    EXPECT_EQ(codeOf([&] { writeFile(folder_ / "taken", "data"); }), ErrorCode::OutputUnwritable);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace stepmill
