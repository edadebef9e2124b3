#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stepmill {

/// The whole file as bytes. \throws Error(FileUnreadable) naming the file and the system's reason.
std::string readFile(const std::filesystem::path& path);

/// Writes to a temporary name beside `path`, then renames: the file is complete or absent.
/// \throws Error(OutputUnwritable)
void writeFile(const std::filesystem::path& path, std::string_view bytes);

/// SHA-256 of the bytes, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace stepmill
