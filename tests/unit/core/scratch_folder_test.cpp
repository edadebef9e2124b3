#include "stepmill/core/scratch_folder.h"

#include <cstdlib>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

TEST(ScratchFolder, IsGoneWithAllThatIsInIt) {
    fs::path path;
    {
        const ScratchFolder folder("test");
        path = folder.path();
        EXPECT_TRUE(path.filename().string().starts_with("stepmill-test-"));
        fs::create_directory(path / "inner");
        writeFile(path / "inner" / "file", "bytes");
        EXPECT_NE(ScratchFolder("test").path(), path);
    }
    EXPECT_FALSE(fs::exists(path));
}

TEST(ScratchFolder, TellsWhereNoneCanBeMade) {
    const char* const before = std::getenv("TMPDIR");
    const std::optional<std::string> kept = before != nullptr ? std::optional(before) : std::nullopt;
    ::setenv("TMPDIR", "/no/such/folder", 1);
    std::optional<ErrorCode> code;
    try {
        const ScratchFolder folder("test");
    } catch (const Error& error) {
        code = error.code();
    }
    if (kept)
        ::setenv("TMPDIR", kept->c_str(), 1);
    else
        ::unsetenv("TMPDIR");
    EXPECT_EQ(code, ErrorCode::OutputUnwritable);
}

}  // namespace
}  // namespace stepmill
