#include "stepmill/core/file.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

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

TEST_F(FileTest, PipesDevicesAndSocketsAreNoFilesAndAreNotWaitedFor) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(codeOf([&] { readFile(folder_ / "pipe"); }), ErrorCode::FileUnreadable);
    for (const char* device : {"/dev/zero", "/dev/null", "/dev/tty"})
        EXPECT_EQ(codeOf([&] { readFile(device); }), ErrorCode::FileUnreadable) << device;
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::snprintf(address.sun_path, sizeof(address.sun_path), "%s", (folder_ / "socket").c_str());
    ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    EXPECT_EQ(codeOf([&] { readFile(folder_ / "socket"); }), ErrorCode::FileUnreadable);
    ::close(socket);
}

TEST_F(FileTest, AFileLargerThanTheLimitIsNotRead) {
    writeFile(folder_ / "x", "12345");
    EXPECT_EQ(readFile(folder_ / "x", 5), "12345");
    EXPECT_EQ(codeOf([&] { readFile(folder_ / "x", 4); }), ErrorCode::FileUnreadable);
    fs::resize_file(folder_ / "x", std::uintmax_t{100} << 30);  // a hole
    EXPECT_EQ(codeOf([&] { readFile(folder_ / "x"); }), ErrorCode::FileUnreadable);
}

TEST_F(FileTest, ANewFileDoesNotReplaceOne) {
    EXPECT_FALSE(writeNewFile(folder_ / "x", "first"));
    EXPECT_EQ(writeNewFile(folder_ / "x", "second"), std::errc::file_exists);
    EXPECT_EQ(readFile(folder_ / "x"), "first");
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
