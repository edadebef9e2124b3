#pragma once

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <limits>

#include <unistd.h>

#include "stepmill/core/disk.h"

namespace stepmill::test {

/// A disk on which the n-th call fails or kills the process, that is full after some bytes, or that lacks a
/// call.
class FaultyDisk : public Disk {
  public:
    enum class Fault { Fails, Kills };

    int fault_at = std::numeric_limits<int>::max();  ///< the first call is 0
    Fault fault = Fault::Fails;
    /// Every call from fault_at on fails, clean-up too.
    bool stays_broken = false;
    std::size_t bytes_left = std::numeric_limits<std::size_t>::max();
    bool can_exchange = true;
    bool can_link = true;
    int calls = 0;

    int create(const std::filesystem::path& file) override { return fails() ? -1 : Disk::create(file); }
    ssize_t write(int fd, const char* bytes, std::size_t count) override {
        if (fails()) return -1;
        if (count > 0 && bytes_left == 0) return error(ENOSPC);
        const std::size_t fits = std::min(count, bytes_left);
        bytes_left -= fits;
        return Disk::write(fd, bytes, fits);
    }
    /// Does not wait: a test that pulls no plug gains nothing by it.
    int sync(int) override { return fails() ? -1 : 0; }
    int makeFolder(const std::filesystem::path& folder) override {
        return fails() ? -1 : Disk::makeFolder(folder);
    }
    int setMode(const std::filesystem::path& folder, mode_t mode) override {
        return fails() ? -1 : Disk::setMode(folder, mode);
    }
    int rename(const std::filesystem::path& from, const std::filesystem::path& to) override {
        return fails() ? -1 : Disk::rename(from, to);
    }
    int renameToNew(const std::filesystem::path& from, const std::filesystem::path& to) override {
        return fails() ? -1 : Disk::renameToNew(from, to);
    }
    int exchange(const std::filesystem::path& one, const std::filesystem::path& other) override {
        if (!can_exchange) return error(EINVAL);
        return fails() ? -1 : Disk::exchange(one, other);
    }
    int link(const std::filesystem::path& file, const std::filesystem::path& name) override {
        if (!can_link) return error(EPERM);
        return fails() ? -1 : Disk::link(file, name);
    }
    int removeFile(const std::filesystem::path& file) override {
        return fails() ? -1 : Disk::removeFile(file);
    }
    int removeFolder(const std::filesystem::path& folder) override {
        return fails() ? -1 : Disk::removeFolder(folder);
    }

  private:
    static int error(int number) {
        errno = number;
        return -1;
    }
    bool fails() {
        const int call = calls++;
        const bool now = stays_broken ? call >= fault_at : call == fault_at;
        if (now && fault == Fault::Kills) ::kill(::getpid(), SIGKILL);
        if (now) errno = EIO;
        return now;
    }
};

}  // namespace stepmill::test
