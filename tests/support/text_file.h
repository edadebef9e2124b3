#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace stepmill::test {

/// A file's bytes; nothing where it is missing.
inline std::string slurp(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace stepmill::test
