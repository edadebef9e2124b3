#include "job/replace_folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <functional>

#include <sys/stat.h>

#include "job/work_folder.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill::job {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, int error_number) {
    throw Error(ErrorCode::OutputUnwritable, path.string(),
                std::string("cannot be written: ") + std::strerror(error_number));
}

/// The file system has no such call, or the folder is one that cannot move.
bool isImpossibleHere(int error_number) {
    constexpr std::array kReasons = {EINVAL, ENOSYS, ENOTSUP, EPERM, EACCES, EBUSY, EXDEV, EMLINK};
    return std::find(kReasons.begin(), kReasons.end(), error_number) != kReasons.end();
}

/// The manifest first: what it names in a work folder is known to be ours, however far the writing came.
void writeAll(const fs::path& work, const fs::path& job, const Replacement& with, Disk& disk) {
    const auto write = [&](const std::string& name, const std::string& bytes) {
        const std::error_code why = writeNewFile(work / name, bytes, disk);
        if (why) fail(job / name, why.value());  // the name that the user knows
    };
    write(kManifestName, manifestJson(with.manifest));
    for (const NewFile& file : with.files)
        write(file.name, file.bytes);
}

/// False where the file system has no second names.
bool linkAll(const fs::path& job, const fs::path& work, const Replacement& with, Disk& disk) {
    for (const std::string& name : with.stay) {
        if (disk.link(job / name, work / name) == 0) continue;
        if (!isImpossibleHere(errno)) fail(work / name, errno);
        return false;
    }
    return true;
}

void takeMode(const fs::path& job, const fs::path& work, Disk& disk) {
    struct stat before {};
    struct stat now {};
    constexpr mode_t kPermissions = 07777;
    if (::stat(job.c_str(), &before) != 0 || ::stat(work.c_str(), &now) != 0) return;
    if (before.st_mode == now.st_mode) return;
    if (disk.setMode(work, before.st_mode & kPermissions) != 0) fail(work, errno);
}

/// Work and job change places; false where they cannot.
bool swapIn(const fs::path& work, const fs::path& job, Disk& disk) {
    const bool replaces = isThere(job);
    if (replaces ? disk.exchange(work, job) == 0 : disk.renameToNew(work, job) == 0) return true;
    const int why = errno;
    if (!isImpossibleHere(why)) fail(job, why);
    if (replaces) return false;
    if (disk.rename(work, job) != 0) fail(job, errno);  // the old call, on file systems without the new one
    return true;
}

/// What the user saved in the old folder between the links and the swap.
void carryOver(const fs::path& old, const fs::path& job, const Manifest& before, const Manifest& now,
               Disk& disk) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(old, ignored)) {
        const std::string name = entry.path().filename().string();
        const bool ours =
            name == kManifestName || findFile(before, name) != nullptr || findFile(now, name) != nullptr;
        if (!ours && !fs::equivalent(entry.path(), job / name, ignored))
            disk.rename(entry.path(), job / name);
    }
}

/// Does `work`; when it fails, `undo` before the error goes on.
void orUndo(const std::function<void()>& work, const std::function<void()>& undo) {
    try {
        work();
    } catch (...) {
        undo();
        throw;
    }
}

void move(const fs::path& from, const fs::path& to, Disk& disk) {
    if (disk.rename(from, to) != 0) fail(to, errno);
}

void moveAll(const fs::path& job, const fs::path& work, const Replacement& with, Disk& disk) {
    const fs::path old = work / kOldName;
    if (disk.makeFolder(old) != 0) fail(old, errno);
    if (isThere(job / kManifestName)) move(job / kManifestName, old / kManifestName, disk);
    for (const std::string& name : with.gone)
        move(job / name, old / name, disk);
    for (const NewFile& file : with.files)
        move(work / file.name, job / file.name, disk);
    syncFolder(job, disk);
    move(work / kManifestName, job / kManifestName, disk);
}

}  // namespace

bool replaceAtOnce(const fs::path& job, const Replacement& with, Disk& disk) {
    const fs::path work = makeWorkFolder(besidePrefix(job), disk);
    const Manifest before = manifestIfWhole(job).value_or(Manifest{});
    const auto tidy = [&] { removeWorkFolder(work, job, disk); };
    bool swapped = false;
    orUndo(
        [&] {
            writeAll(work, job, with, disk);
            if (!linkAll(job, work, with, disk)) return;
            takeMode(job, work, disk);
            syncFolder(work, disk);
            swapped = swapIn(work, job, disk);
            if (!swapped) return;
            if (isThere(work)) carryOver(work, job, before, with.manifest, disk);
            syncFolder(job.parent_path(), disk);
        },
        tidy);
    if (isThere(work)) tidy();
    return swapped;
}

void replaceOneByOne(const fs::path& job, const Replacement& with, Disk& disk) {
    const fs::path work = makeWorkFolder(insidePrefix(job), disk);
    orUndo(
        [&] {
            writeAll(work, job, with, disk);
            syncFolder(work, disk);
            moveAll(job, work, with, disk);
        },
        [&] {
            undoMoves(work, job, disk);
            removeWorkFolder(work, job, disk);
        });
    removeWorkFolder(work, job, disk);
    syncFolder(job, disk);
}

}  // namespace stepmill::job
