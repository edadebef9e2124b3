#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <sys/types.h>

namespace stepmill {

/// A control group (Linux' cgroup v2) for one process and all that it starts: the system ends them where they
/// take more memory than the group may, mapped files included.
class MemoryGroup {
  public:
    /// \param folder  new, below a group whose groups have the memory controller
    /// \throws Error(SystemLimit)
    MemoryGroup(std::filesystem::path folder, std::uint64_t bytes);
    /// Removes the group.
    /// \pre its processes have ended
    ~MemoryGroup();
    MemoryGroup(const MemoryGroup&) = delete;
    MemoryGroup& operator=(const MemoryGroup&) = delete;

    /// Takes this process in; false where the system does not let it.
    [[nodiscard]] bool enter() const;
    /// Has the system ended any of its processes for its memory?
    bool ranOut() const;

  private:
    std::filesystem::path folder_;
};

/// The control groups below this process' own, where the system lets it make some: the group is delegated to
/// its user, has the memory controller, and holds no other process ("systemd-run --user --scope -p
/// Delegate=yes stepmill batch ...").
class MemoryGroups {
  public:
    /// Nothing where any of that is not so. This process stands in a group below from now on, since one with
    /// groups below may hold no process.
    /// \param own  folder of the group; see ownGroupFolder()
    static std::unique_ptr<MemoryGroups> take(const std::filesystem::path& own);
    /// Puts the process back.
    ~MemoryGroups();
    MemoryGroups(const MemoryGroups&) = delete;
    MemoryGroups& operator=(const MemoryGroups&) = delete;

    /// For the next child.
    /// \throws Error(SystemLimit)
    std::unique_ptr<MemoryGroup> make(std::uint64_t bytes);

  private:
    explicit MemoryGroups(std::filesystem::path own);

    std::filesystem::path own_;
    std::filesystem::path ours_;  ///< where this process stands
    int made_ = 0;
};

/// Of this process; empty where the system has no cgroup v2.
std::filesystem::path ownGroupFolder();

}  // namespace stepmill
