#include "stepmill/job/folder_lock.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "stepmill/core/error.h"

namespace stepmill {
namespace {

[[noreturn]] void fail(const std::filesystem::path& folder, const std::string& why) {
    throw Error(ErrorCode::OutputUnwritable, folder.string(), why);
}

/// The open file still has its name: nobody removed it between opening and locking.
bool stillNamed(int fd, const std::filesystem::path& file) {
    struct stat opened {};
    struct stat named {};
    return ::fstat(fd, &opened) == 0 && ::lstat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

/// Takes the lock or closes.
/// \throws Error when another process has it
void lockOrFail(int fd, const std::filesystem::path& folder) {
    if (::flock(fd, LOCK_EX | LOCK_NB) == 0) return;
    const int why = errno;
    ::close(fd);
    if (why == EWOULDBLOCK)
        fail(folder, "another run is writing to this folder; wait for its end, or choose another folder");
    fail(folder, std::string("cannot be locked: ") + std::strerror(why));
}

bool isRefused(int error_number) {
    return error_number == EACCES || error_number == EPERM || error_number == EROFS;
}

}  // namespace

FolderLock::FolderLock(std::filesystem::path file, const std::filesystem::path& folder)
    : file_(std::move(file)) {
    constexpr int kTries = 100;  // each is lost to another run that ended just then
    for (int i = 0; i < kTries; ++i) {
        fd_ = ::open(file_.c_str(), O_RDONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK, 0666);
        if (fd_ < 0 && isRefused(errno)) {
            beside_ = false;
            fd_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        }
        if (fd_ < 0) fail(folder, std::string("cannot be written to: ") + std::strerror(errno));
        lockOrFail(fd_, folder);
        if (!beside_ || stillNamed(fd_, file_)) return;
        ::close(fd_);
    }
    fail(folder, "other runs keep it locked");
}

FolderLock::~FolderLock() {
    struct stat status {};
    // Empty as we make it; a file of somebody else's that has this name stays.
    if (beside_ && ::fstat(fd_, &status) == 0 && status.st_size == 0 && stillNamed(fd_, file_))
        ::unlink(file_.c_str());
    ::close(fd_);
}

}  // namespace stepmill
