#include "stepmill/job/job_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <sys/stat.h>
#include <unistd.h>

#include "job/replace_folder.h"
#include "job/work_folder.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/job/folder_lock.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
    throw Error(ErrorCode::OutputUnwritable, path.string(), why);
}

/// Makes the folders on the way to a new one, innermost first in `made`.
void makeParents(const fs::path& folder, std::vector<fs::path>& made) {
    std::error_code why;
    for (fs::path parent = folder; !parent.empty() && !fs::exists(parent, why); parent = parent.parent_path())
        made.push_back(parent);
    fs::create_directories(folder, why);
    if (why) refuse(folder, "cannot be made: " + why.message());
}

/// The folder without links and dots on the way; its parents are made.
fs::path resolved(const fs::path& dir, std::vector<fs::path>& made) {
    std::error_code why;
    const fs::path absolute = fs::absolute(dir / "", why).parent_path();
    const fs::file_status status = fs::status(absolute, why);
    if (fs::is_directory(status)) return fs::canonical(absolute);
    if (job::isThere(absolute)) refuse(dir, "is not a folder");
    const fs::path lexical = absolute.lexically_normal();
    makeParents(lexical.parent_path(), made);
    return fs::canonical(lexical.parent_path()) / lexical.filename();
}

fs::path lockFile(const fs::path& job) {
    fs::path file = job::besidePrefix(job);
    file += "lock";
    return file;
}

/// What lies in the folder, sorted into the job's and the user's.
struct Contents {
    std::vector<std::string> job;    ///< files, and folders of solids, that the manifest names
    std::vector<std::string> files;  ///< the user's
    bool has_folders = false;        ///< of anyone
};

Contents contentsOf(const fs::path& folder, const Manifest& manifest) {
    Contents contents;
    std::error_code why;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, why)) {
        const std::string name = entry.path().filename().string();
        const bool is_folder = fs::is_directory(entry.symlink_status(why));
        contents.has_folders = contents.has_folders || is_folder;
        const std::vector<std::string>& solids = manifest.solids;
        const bool ours = is_folder ? std::find(solids.begin(), solids.end(), name) != solids.end()
                                    : findFile(manifest, name) != nullptr;
        if (ours)
            contents.job.push_back(name);
        else if (!is_folder && name != kManifestName)
            contents.files.push_back(name);
    }
    std::sort(contents.job.begin(), contents.job.end());
    std::sort(contents.files.begin(), contents.files.end());
    return contents;
}

void requireNoStrangePrograms(const fs::path& folder, const Contents& contents) {
    for (const std::string& name : contents.files)
        if (isProgramName(name))
            refuse(folder / name,
                   "is a program that is not of this folder's job; move it away, or choose another folder");
}

/// New files do not land on the user's.
void requireFreeNames(const fs::path& folder, const NewJob& job, const Contents& contents) {
    for (const NewFile& file : job.files) {
        const auto& own = contents.job;
        const bool taken =
            job::isThere(folder / file.name) && std::find(own.begin(), own.end(), file.name) == own.end();
        if (taken)
            refuse(
                folder / file.name,
                "is not of this folder's job and is not overwritten; move it away, or choose another folder");
    }
}

/// A solid that goes holds nothing of the user's.
void requireOnlyJobs(const fs::path& folder) {
    const Manifest manifest = readManifest(folder).value_or(Manifest{});
    const Contents contents = contentsOf(folder, manifest);
    if (!contents.files.empty())
        refuse(folder / contents.files.front(),
               "is not of the job that is replaced; move it away, or choose another folder");
}

bool isPage(JobWriter writer) {
    return writer == JobWriter::Inspect || writer == JobWriter::Curves;
}

bool hasPlan(const Manifest& manifest) {
    return !manifest.solids.empty() ||
           std::any_of(manifest.files.begin(), manifest.files.end(),
                       [](const ManifestFile& file) { return file.by == JobWriter::Plan; });
}

bool hasDialect(const NewJob& job, const std::string& dialect) {
    return std::any_of(job.files.begin(), job.files.end(),
                       [&](const NewFile& file) { return file.dialect == dialect; });
}

/// Pages and programs beside a plan are of that plan.
void requireSameJob(const fs::path& folder, const Manifest& before, const NewJob& job) {
    if (job.by == JobWriter::Plan || !hasPlan(before)) return;
    if (isPage(job.by) && before.part_sha256 != job.part_sha256)
        refuse(folder, "holds the plan of another part, " + before.part_file + "; choose another folder");
    if (job.by == JobWriter::Post && before.plan_sha256 != job.plan_sha256)
        refuse(folder, "holds another plan, of " + before.part_file + "; choose another folder");
}

/// The file of the old job is part of the new one.
bool stays(const ManifestFile& file, const Manifest& before, const NewJob& job) {
    const bool same_part = before.part_sha256 == job.part_sha256;
    switch (job.by) {
        case JobWriter::Plan:
            return same_part && isPage(file.by);
        case JobWriter::Post:
            if (isPage(file.by)) return same_part;
            return before.plan_sha256 == job.plan_sha256 &&
                   (file.dialect.empty() || !hasDialect(job, file.dialect));
        case JobWriter::Inspect:
        case JobWriter::Curves:
            return same_part && file.by != job.by;
    }
    return false;
}

Manifest manifestOf(const NewJob& job, const Manifest& before) {
    Manifest manifest{job.part_file, job.part_sha256, job.plan_sha256, {}, job.solids};
    const bool beside = isPage(job.by) && before.part_sha256 == job.part_sha256;
    if (beside) manifest.plan_sha256 = before.plan_sha256;
    if (beside) manifest.solids = before.solids;
    for (const NewFile& file : job.files)
        manifest.files.push_back({file.name, job.by, file.dialect, file.bytes.size(), sha256(file.bytes)});
    for (const ManifestFile& file : before.files)
        if (stays(file, before, job) && findFile(manifest, file.name) == nullptr)
            manifest.files.push_back(file);
    return manifest;
}

bool isNew(const NewJob& job, const std::string& name) {
    return std::any_of(job.files.begin(), job.files.end(),
                       [&](const NewFile& file) { return file.name == name; });
}

bool isSolid(const Manifest& manifest, const std::string& name) {
    return std::find(manifest.solids.begin(), manifest.solids.end(), name) != manifest.solids.end();
}

job::Replacement replacementFor(const NewJob& job, const Manifest& before, const Contents& contents) {
    job::Replacement with{manifestOf(job, before), job.files, {}, contents.files};
    for (const std::string& name : contents.job) {
        const bool kept =
            isSolid(with.manifest, name) || (findFile(with.manifest, name) != nullptr && !isNew(job, name));
        (kept ? with.stay : with.gone).push_back(name);
    }
    return with;
}

/// The folder can change places with another without anybody noticing but by its files.
bool canMove(const fs::path& folder, const Contents& contents, const NewJob& job) {
    if (contents.has_folders || !job.solids.empty()) return false;
    std::error_code ignored;
    if (fs::equivalent(folder, fs::current_path(ignored), ignored)) return false;
    struct stat status {};
    return ::stat(folder.c_str(), &status) != 0 || status.st_uid == ::geteuid();
}

bool isEdited(const fs::path& folder, const ManifestFile& file) {
    try {
        return sha256(readFile(folder / file.name)) != file.sha256;
    } catch (const Error&) {
        return false;  // gone, or no file: nothing of hers is lost
    }
}

}  // namespace

struct JobFolder::State {
    Disk& disk;
    std::vector<fs::path> made;  // parents that were not there, innermost first
    fs::path folder;
    std::optional<FolderLock> lock;
    std::vector<std::string> edits;

    ~State() {
        std::error_code ignored;
        lock.reset();
        for (const fs::path& parent : made)
            fs::remove(parent, ignored);  // fails, as it should, where something was written
    }
};

JobFolder::JobFolder(const fs::path& dir, Disk& disk) : state_(new State{disk, {}, {}, {}, {}}) {
    state_->folder = resolved(dir, state_->made);
    state_->lock.emplace(lockFile(state_->folder), state_->folder);
    job::tidyJob(state_->folder, disk);
    const Manifest manifest = readManifest(state_->folder).value_or(Manifest{});
    requireNoStrangePrograms(state_->folder, contentsOf(state_->folder, manifest));
    if (fs::exists(state_->folder) && ::access(state_->folder.c_str(), W_OK | X_OK) != 0)
        refuse(dir, std::string("cannot be written to: ") + std::strerror(errno));
}

JobFolder::~JobFolder() {
    try {
        job::tidyJob(state_->folder, state_->disk);
    } catch (const std::exception&) {
        // The next writer tries again, and tells.
    }
}

const fs::path& JobFolder::path() const {
    return state_->folder;
}

const std::vector<std::string>& JobFolder::replacedEdits() const {
    return state_->edits;
}

void JobFolder::write(const NewJob& job) {
    const fs::path& folder = state_->folder;
    const Manifest before = readManifest(folder).value_or(Manifest{});
    const Contents contents = contentsOf(folder, before);
    requireNoStrangePrograms(folder, contents);
    requireFreeNames(folder, job, contents);
    requireSameJob(folder, before, job);
    const job::Replacement with = replacementFor(job, before, contents);
    for (const std::string& name : with.gone) {
        if (isSolid(before, name)) requireOnlyJobs(folder / name);
        const ManifestFile* file = findFile(before, name);
        if (file != nullptr && isEdited(folder, *file)) state_->edits.push_back(name);
    }
    const bool movable = state_->lock->isBeside() && canMove(folder, contents, job);
    if (movable && job::replaceAtOnce(folder, with, state_->disk)) return;
    std::error_code why;
    fs::create_directory(folder, why);
    if (why) refuse(folder, "cannot be made: " + why.message());
    job::replaceOneByOne(folder, with, state_->disk);
}

void tidyFoldersBelow(const fs::path& dir) {
    static const std::string kMark = ".stepmill-";
    std::error_code ignored;
    std::vector<fs::path> jobs;
    for (const fs::directory_entry& entry : fs::directory_iterator(dir, ignored)) {
        const std::string name = entry.path().filename().string();
        const std::size_t at = name.rfind(kMark);
        if (name.starts_with(".") && at != std::string::npos && at > 1)
            jobs.push_back(dir / name.substr(1, at - 1));
    }
    for (const fs::path& job : jobs) {
        try {
            const JobFolder tidied(job);
        } catch (const std::exception&) {
            // Somebody writes there, or it is none of ours.
        }
    }
}

}  // namespace stepmill
