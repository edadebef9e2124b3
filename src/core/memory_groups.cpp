#include "stepmill/core/memory_groups.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <unistd.h>

#include "stepmill/core/error.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

/// A word to the system, in one write as it wants it.
/// \return why it was not taken, 0 where it was
int tellSystem(const fs::path& file, const std::string& word) {
    const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (opened < 0) return errno;
    const ssize_t written = ::write(opened, word.data(), word.size());
    const int why = written < 0 ? errno : 0;
    ::close(opened);
    return why;
}

/// A line of /proc/self/mountinfo: "41 31 0:38 / /sys/fs/cgroup rw - cgroup2 cgroup2 rw".
fs::path mountPointOf(const std::string& line) {
    std::istringstream words(line);
    std::string skipped;
    std::string point;
    words >> skipped >> skipped >> skipped >> skipped >> point;
    return point;
}

fs::path groupMount() {
    std::ifstream mounts("/proc/self/mountinfo");
    for (std::string line; std::getline(mounts, line);)
        if (line.find(" - cgroup2 ") != std::string::npos) return mountPointOf(line);
    return {};
}

bool hasWord(const fs::path& file, const std::string& wanted) {
    std::ifstream words(file);
    for (std::string word; words >> word;)
        if (word == wanted) return true;
    return false;
}

/// Is this process the group's only one?
bool isAloneIn(const fs::path& group) {
    std::ifstream ids(group / "cgroup.procs");
    int others = 0;
    for (long id = 0; ids >> id;)
        if (id != ::getpid()) ++others;
    return others == 0 && hasWord(group / "cgroup.procs", std::to_string(::getpid()));
}

}  // namespace

MemoryGroup::MemoryGroup(fs::path folder, std::uint64_t bytes) : folder_(std::move(folder)) {
    std::error_code why;
    fs::create_directory(folder_, why);
    const int untold = why ? why.value() : tellSystem(folder_ / "memory.max", std::to_string(bytes));
    if (untold != 0)
        throw Error(ErrorCode::SystemLimit, "system",
                    std::string("grants no control group: ") + std::strerror(untold));
    // Systems without swap have no such file.
    std::error_code ignored;
    const fs::path swap = folder_ / "memory.swap.max";
    if (fs::exists(swap, ignored)) tellSystem(swap, "0");
}

MemoryGroup::~MemoryGroup() {
    ::rmdir(folder_.c_str());
}

bool MemoryGroup::enter() const {
    return tellSystem(folder_ / "cgroup.procs", std::to_string(::getpid())) == 0;
}

bool MemoryGroup::ranOut() const {
    std::ifstream events(folder_ / "memory.events");
    std::string what;
    for (long times = 0; events >> what >> times;)
        if (what == "oom_kill") return times > 0;
    return false;
}

MemoryGroups::MemoryGroups(fs::path own)
    : own_(std::move(own)), ours_(own_ / ("stepmill-" + std::to_string(::getpid()))) {}

std::unique_ptr<MemoryGroups> MemoryGroups::take(const fs::path& own) {
    if (own.empty() || !hasWord(own / "cgroup.controllers", "memory") || !isAloneIn(own)) return nullptr;
    std::unique_ptr<MemoryGroups> groups(new MemoryGroups(own));
    std::error_code why;
    fs::create_directory(groups->ours_, why);
    if (why) return nullptr;
    const bool taken = tellSystem(groups->ours_ / "cgroup.procs", std::to_string(::getpid())) == 0 &&
                       tellSystem(own / "cgroup.subtree_control", "+memory") == 0;
    return taken ? std::move(groups) : nullptr;
}

MemoryGroups::~MemoryGroups() {
    tellSystem(own_ / "cgroup.subtree_control", "-memory");
    tellSystem(own_ / "cgroup.procs", std::to_string(::getpid()));
    ::rmdir(ours_.c_str());
}

std::unique_ptr<MemoryGroup> MemoryGroups::make(std::uint64_t bytes) {
    return std::make_unique<MemoryGroup>(ours_.string() + "-job-" + std::to_string(++made_), bytes);
}

fs::path ownGroupFolder() {
    const fs::path mount = groupMount();
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);)
        if (line.starts_with("0::/") && !mount.empty()) return mount / line.substr(4);
    return {};
}

}  // namespace stepmill
