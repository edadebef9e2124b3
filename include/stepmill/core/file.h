#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "stepmill/core/disk.h"

namespace stepmill {

/// Files larger than this are not read unless a caller says otherwise (--max-file-size) [bytes].
inline constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{512} << 20;

/// The whole file as bytes. Pipes, devices, sockets and folders are not files, and are not opened.
/// \throws Error(FileUnreadable) naming the file and the reason; also when it has more than `max_bytes`.
std::string readFile(const std::filesystem::path& path, std::uintmax_t max_bytes = kMaxFileBytes);

/// Writes to a temporary name beside `path`, then renames: the file is complete or absent.
/// \throws Error(OutputUnwritable)
void writeFile(const std::filesystem::path& path, std::string_view bytes);

/// Writes a file of a new name and waits until it is on the disk. What a failure leaves is the caller's to
/// remove.
/// \return why it failed; also where anything of that name exists
[[nodiscard]] std::error_code writeNewFile(const std::filesystem::path& path, std::string_view bytes,
                                           Disk& disk = systemDisk());

/// Waits until the names in a folder are on the disk; a file system that cannot is taken as it is.
/// \throws Error(OutputUnwritable)
void syncFolder(const std::filesystem::path& folder, Disk& disk = systemDisk());

/// SHA-256 of the bytes, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace stepmill
