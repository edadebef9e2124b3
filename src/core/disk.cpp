#include "stepmill/core/disk.h"

#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace stepmill {

int Disk::create(const std::filesystem::path& file) {
    return ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
}

ssize_t Disk::write(int fd, const char* bytes, std::size_t count) {
    return ::write(fd, bytes, count);
}

int Disk::sync(int fd) {
    return ::fsync(fd);
}

int Disk::makeFolder(const std::filesystem::path& folder) {
    return ::mkdir(folder.c_str(), 0777);
}

int Disk::setMode(const std::filesystem::path& folder, mode_t mode) {
    return ::chmod(folder.c_str(), mode);
}

int Disk::rename(const std::filesystem::path& from, const std::filesystem::path& to) {
    return ::rename(from.c_str(), to.c_str());
}

int Disk::renameToNew(const std::filesystem::path& from, const std::filesystem::path& to) {
    return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE);
}

int Disk::exchange(const std::filesystem::path& one, const std::filesystem::path& other) {
    return ::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE);
}

int Disk::link(const std::filesystem::path& file, const std::filesystem::path& name) {
    return ::link(file.c_str(), name.c_str());
}

int Disk::removeFile(const std::filesystem::path& file) {
    return ::unlink(file.c_str());
}

int Disk::removeFolder(const std::filesystem::path& folder) {
    return ::rmdir(folder.c_str());
}

Disk& systemDisk() {
    static Disk disk;
    return disk;
}

}  // namespace stepmill
