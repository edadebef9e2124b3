#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/text_file.h"

namespace stepmill::test {

/// Compares a text with the file of that name under tests/golden. `make golden` writes the file instead, but
/// never after something else in the test has failed.
inline void expectGolden(const std::filesystem::path& name, const std::string& text) {
    const std::filesystem::path file = std::filesystem::path(STEPMILL_SOURCE_DIR) / "tests" / "golden" / name;
    const bool rewrite = std::getenv("STEPMILL_REWRITE_GOLDEN") != nullptr;
    if (rewrite && !testing::Test::HasFailure()) {
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
    }
    EXPECT_EQ(text, slurp(file)) << "if this is meant: make golden";
}

}  // namespace stepmill::test
