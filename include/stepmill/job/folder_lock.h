#pragma once

#include <filesystem>

namespace stepmill {

/// What keeps a second writer out of a folder: a lock on an empty file beside it, which is removed at the
/// end, or on the folder itself where its parent cannot be written to. The system frees the lock of a process
/// that dies.
class FolderLock {
  public:
    /// \param file    of the lock
    /// \param folder  locked where no such file can be made; may be absent otherwise
    /// \throws Error(OutputUnwritable) naming the folder, when another process has it or it cannot be locked
    FolderLock(std::filesystem::path file, const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// The folder's parent can be written to.
    bool isBeside() const { return beside_; }

  private:
    std::filesystem::path file_;
    bool beside_ = true;
    int fd_ = -1;
};

}  // namespace stepmill
