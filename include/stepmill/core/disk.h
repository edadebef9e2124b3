#pragma once

#include <cstddef>
#include <filesystem>

#include <sys/types.h>

namespace stepmill {

/// The system calls that change a disk, one virtual function each, so that a test can put a disk in between
/// that is full, fails or dies at any of them. Each returns what the call does: -1 with errno set when it
/// fails.
class Disk {
  public:
    virtual ~Disk() = default;

    /// A new file, open for writing; fails where anything of that name exists.
    virtual int create(const std::filesystem::path& file);
    virtual ssize_t write(int fd, const char* bytes, std::size_t count);
    /// Waits until what was written is on the disk. `fd` may be a folder.
    virtual int sync(int fd);
    virtual int makeFolder(const std::filesystem::path& folder);
    virtual int setMode(const std::filesystem::path& folder, mode_t mode);
    /// Replaces a file of the new name.
    virtual int rename(const std::filesystem::path& from, const std::filesystem::path& to);
    /// Fails where the new name exists.
    virtual int renameToNew(const std::filesystem::path& from, const std::filesystem::path& to);
    /// Swaps two names at once; fails with EINVAL or ENOSYS where the file system cannot.
    virtual int exchange(const std::filesystem::path& one, const std::filesystem::path& other);
    /// A second name for a file; does not follow links.
    virtual int link(const std::filesystem::path& file, const std::filesystem::path& name);
    virtual int removeFile(const std::filesystem::path& file);
    /// Fails where the folder is not empty.
    virtual int removeFolder(const std::filesystem::path& folder);
};

/// The real one.
Disk& systemDisk();

}  // namespace stepmill
