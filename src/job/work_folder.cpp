#include "job/work_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <random>

#include <sys/stat.h>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill::job {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kChanceLetters = 6;

std::string chanceLetters() {
    static constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
    std::random_device chance;
    std::string letters;
    for (std::size_t i = 0; i < kChanceLetters; ++i)
        letters += kLetters[chance() % kLetters.size()];
    return letters;
}

bool isWorkFolder(const fs::directory_entry& entry, const std::string& beginning) {
    const std::string name = entry.path().filename().string();
    std::error_code ignored;
    return name.size() == beginning.size() + kChanceLetters && name.starts_with(beginning) &&
           fs::is_directory(entry.symlink_status(ignored));
}

/// Two names of one file.
bool isSameFile(const fs::path& one, const fs::path& other) {
    struct stat a {};
    struct stat b {};
    return ::lstat(one.c_str(), &a) == 0 && ::lstat(other.c_str(), &b) == 0 && a.st_ino == b.st_ino &&
           a.st_dev == b.st_dev;
}

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// Files that `owner` names, what is in `job` too, then the manifest, then the folder. One without a readable
/// manifest is ours when it holds nothing but the beginning of one.
void removeOurs(const fs::path& folder, const fs::path& job, Disk& disk) {
    const std::optional<Manifest> owner = manifestIfWhole(folder);
    bool others = false;
    for (const std::string& name : namesIn(folder)) {
        if (name == kManifestName) continue;
        const bool named = owner && findFile(*owner, name) != nullptr;
        const bool gone =
            (named || isSameFile(folder / name, job / name)) && disk.removeFile(folder / name) == 0;
        others = others || !gone;
    }
    if (owner)
        for (const std::string& solid : owner->solids)
            if (isThere(folder / solid)) removeOurs(folder / solid, job / solid, disk);
    if (!others) disk.removeFile(folder / kManifestName);
    disk.removeFolder(folder);
}

void moveBack(const fs::path& from, const fs::path& to, Disk& disk) {
    if (disk.rename(from, to) == 0) return;
    throw Error(ErrorCode::OutputUnwritable, to.string(),
                std::string("cannot be put back: ") + std::strerror(errno));
}

bool isKept(const ManifestFile& file, const Manifest& before, const fs::path& old) {
    const ManifestFile* same = findFile(before, file.name);
    return same != nullptr && same->sha256 == file.sha256 && !isThere(old / file.name);
}

}  // namespace

bool isThere(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(path, ignored));
}

fs::path besidePrefix(const fs::path& job) {
    constexpr std::size_t kLongestName = 200;  // 255 bytes less what is added here
    std::string name = job.filename().string();
    if (name.size() > kLongestName) name = sha256(name);
    return job.parent_path() / ("." + name + ".stepmill-");
}

fs::path insidePrefix(const fs::path& job) {
    return job / ".stepmill-";
}

fs::path makeWorkFolder(const fs::path& prefix, Disk& disk) {
    constexpr int kTries = 100;
    for (int i = 0; i < kTries; ++i) {
        fs::path work = prefix;
        work += chanceLetters();
        if (disk.makeFolder(work) == 0) return work;
        if (errno != EEXIST) break;
    }
    throw Error(ErrorCode::OutputUnwritable, prefix.parent_path().string(),
                std::string("cannot be written to: ") + std::strerror(errno));
}

std::vector<fs::path> workFolders(const fs::path& prefix) {
    std::vector<fs::path> found;
    const std::string beginning = prefix.filename().string();
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(prefix.parent_path(), ignored))
        if (isWorkFolder(entry, beginning)) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

std::optional<Manifest> manifestIfWhole(const fs::path& folder) {
    try {
        return readManifest(folder);
    } catch (const Error&) {
        return std::nullopt;
    }
}

void removeWorkFolder(const fs::path& work, const fs::path& job, Disk& disk) {
    if (isThere(work / kOldName)) removeOurs(work / kOldName, job, disk);
    removeOurs(work, job, disk);
}

void undoMoves(const fs::path& work, const fs::path& job, Disk& disk) {
    const std::optional<Manifest> unfinished = manifestIfWhole(work);
    const fs::path old = work / kOldName;
    if (!unfinished || !isThere(old)) return;
    const Manifest before = manifestIfWhole(old).value_or(Manifest{});
    for (const ManifestFile& file : unfinished->files) {
        const bool moved = !isThere(work / file.name) && isThere(job / file.name);
        if (moved && !isKept(file, before, old)) moveBack(job / file.name, work / file.name, disk);
    }
    for (const std::string& name : namesIn(old))
        if (name != kManifestName) moveBack(old / name, job / name, disk);
    if (isThere(old / kManifestName)) moveBack(old / kManifestName, job / kManifestName, disk);
}

void tidyJob(const fs::path& job, Disk& disk) {
    for (const fs::path& work : workFolders(insidePrefix(job))) {
        undoMoves(work, job, disk);
        removeWorkFolder(work, job, disk);
    }
    for (const fs::path& work : workFolders(besidePrefix(job)))
        removeWorkFolder(work, job, disk);
}

}  // namespace stepmill::job
