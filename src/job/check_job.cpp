#include <algorithm>

#include "job/work_folder.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/job/job_folder.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

void checkFiles(const fs::path& dir, const Manifest& manifest, JobCheck& check) {
    std::error_code ignored;
    for (const ManifestFile& file : manifest.files) {
        if (!fs::exists(dir / file.name, ignored))
            check.missing.push_back(file.name);
        else if (sha256(readFile(dir / file.name)) != file.sha256)
            check.changed.push_back(file.name);
    }
}

std::vector<std::string> programsIn(const fs::path& dir) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(dir, ignored)) {
        const std::string name = entry.path().filename().string();
        if (isProgramName(name) && !fs::is_directory(entry.symlink_status(ignored))) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

JobCheck checkJob(const fs::path& dir) {
    const std::optional<Manifest> manifest = readManifest(dir);
    if (!manifest && !job::workFolders(job::insidePrefix(dir)).empty())
        throw Error(ErrorCode::FileUnreadable, dir.string(),
                    "its writing was not finished; plan or post again, or wait for the run that writes");
    JobCheck check;
    check.has_manifest = manifest.has_value();
    if (manifest) checkFiles(dir, *manifest, check);
    for (const std::string& name : programsIn(dir))
        if (!manifest || findFile(*manifest, name) == nullptr) check.programs.push_back(name);
    return check;
}

}  // namespace stepmill
