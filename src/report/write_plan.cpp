#include <system_error>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/report/report.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

/// Files are made here first, on the same file system, and moved when all are complete.
fs::path workFolder(const fs::path& dir) {
    const fs::path clean = (dir / "").parent_path();
    return clean.parent_path() / ("." + clean.filename().string() + ".partial");
}

[[noreturn]] void failWriting(const fs::path& path, const std::error_code& why) {
    throw Error(ErrorCode::OutputUnwritable, path.string(), "cannot be written: " + why.message());
}

/// Removes the work folder, and the folders made on the way to it, unless told that all went well.
class WorkFolder {
  public:
    explicit WorkFolder(const fs::path& dir) : path_(workFolder(dir)) {
        std::error_code why;
        fs::remove_all(path_, why);
        for (fs::path parent = path_.parent_path(); !parent.empty() && !fs::exists(parent, why);
             parent = parent.parent_path())
            made_.push_back(parent);
        fs::create_directories(path_, why);
        if (why) {
            const fs::path target = dir;
            undo();
            failWriting(target, why);
        }
    }
    ~WorkFolder() { undo(); }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    const fs::path& path() const { return path_; }
    void keepParents() { made_.clear(); }

  private:
    void undo() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
        for (const fs::path& folder : made_)
            fs::remove(folder, ignored);
    }

    fs::path path_;
    std::vector<fs::path> made_;  // innermost first
};

void removePrograms(const PlanFiles& files, const fs::path& dir) {
    std::error_code ignored;
    for (const auto& [setup, programs] : files.programs)
        for (const PostedProgram& program : programs)
            fs::remove(dir / program.file, ignored);
}

}  // namespace

void removeUnfinished(const fs::path& dir) {
    std::error_code ignored;
    fs::remove_all(workFolder(dir), ignored);
}

void writePlan(const ProvenPlan& proven, const fs::path& dir, const Tolerances& tol) {
    std::vector<std::pair<std::string, std::string>> files;
    const PlanFiles& posted = proven.files;
    files.emplace_back("plan.json", posted.plan_json);
    files.emplace_back("report.html", reportHtml(proven.plan, tol));
    if (proven.verification.proven())
        for (const auto& [setup, programs] : posted.programs)
            for (const PostedProgram& program : programs)
                files.emplace_back(program.file, program.text);

    WorkFolder work(dir);
    for (const auto& [name, bytes] : files)
        writeFile(work.path() / name, bytes);

    std::error_code why;
    fs::create_directories(dir, why);
    if (why) failWriting(dir, why);
    for (const auto& [name, bytes] : files) {
        fs::rename(work.path() / name, dir / name, why);
        if (why) failWriting(dir / name, why);
    }
    if (!proven.verification.proven()) removePrograms(posted, dir);
    work.keepParents();
}

}  // namespace stepmill
