#include "stepmill/batch/tidy_batch.h"

#include <string>
#include <vector>

#include "stepmill/job/job_folder.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

/// Removes the files of a folder whose names fit.
template <typename Fits>
void removeFiles(const fs::path& folder, Fits fits) {
    std::error_code ignored;
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (entry.is_regular_file(ignored) && fits(entry.path().filename().string()))
            files.push_back(entry.path());
    for (const fs::path& file : files)
        fs::remove(file, ignored);
}

/// As writeFile() calls what it has not finished: of any name, or of one.
bool isHalfWritten(const std::string& name, const std::string& of = {}) {
    return name.ends_with(".part") && name.starts_with(of.empty() ? of : of + ".");
}

}  // namespace

void tidyBatch(const fs::path& batch) {
    removeFiles(batch / "records", [](const std::string& name) { return isHalfWritten(name); });
    removeFiles(batch, [](const std::string& name) {
        return isHalfWritten(name, "index.html") || isHalfWritten(name, "parts.csv") ||
               isHalfWritten(name, "tools.csv") || isHalfWritten(name, "magazine.csv") ||
               isHalfWritten(name, "order.csv") || isHalfWritten(name, "ledger.sqlite");
    });
    tidyFoldersBelow(batch / "jobs");
}

void removeOldRecords(const fs::path& batch) {
    removeFiles(batch / "records", [](const std::string& name) { return name.ends_with(".json"); });
}

}  // namespace stepmill
