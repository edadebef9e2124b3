#include "batch_work.h"

#include <csignal>
#include <cstdlib>
#include <new>
#include <thread>

#include <unistd.h>

#include <oneapi/tbb/global_control.h>

#include "commands.h"
#include "output.h"
#include "plan_job.h"
#include "stepmill/batch/job_record.h"
#include "stepmill/batch/part_figures.h"
#include "stepmill/core/error.h"
#include "stepmill/report/part_views.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

/// The file was another when the batch read it.
struct FileChanged {};

void takeMemory() {
    constexpr std::size_t kPiece = std::size_t{64} << 20;
    std::vector<std::vector<char>> taken;
    while (true)
        taken.emplace_back(kPiece, 'x');
}

/// What a test asks the part of this name to do wrong.
void sufferFault(const std::vector<std::string>& faults, const std::string& name) {
    for (const std::string& fault : faults) {
        if (fault == name + ":hang")
            while (true)
                ::pause();
        if (fault == name + ":memory") takeMemory();
        if (fault == name + ":crash") std::raise(SIGSEGV);
        const std::string wait = name + ":wait:";
        while (fault.starts_with(wait) && !fs::exists(fault.substr(wait.size())))
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        if (fault == name + ":task") ::kill(::getppid(), SIGKILL);
    }
}

/// The first of its files that is still there.
fs::path fileOf(const BatchPlan::Source& source) {
    std::error_code ignored;
    for (const fs::path& file : source.files)
        if (fs::exists(file, ignored)) return file;
    return source.files.front();
}

/// A plan is not lost for its picture.
std::string pictureOf(const Part& part) {
    try {
        return smallPicture(part);
    } catch (const Error&) {
        return {};
    }
}

class PlannedJob {
  public:
    PlannedJob(const BatchJob& job, const fs::path& batch, const JobFolder& folder)
        : job_(job), batch_(batch), folder_(folder) {}

    PlanListener listener() {
        return {[this](const std::vector<Part>& parts) { requireListed(parts); },
                [this](const ProvenPlan& proven, const fs::path& folder,
                       const std::vector<OfferWorth>& offers) { take(proven.plan, folder, offers); }};
    }

    void writeRecordOf(int exit_code) const { writeRecord(batch_, job_, {exit_code, figuresJson(figures_)}); }

  private:
    void requireListed(const std::vector<Part>& parts) const {
        if (parts.front().sha256 != job_.key.part_sha256) throw FileChanged();
    }

    void take(const Plan& plan, const fs::path& folder, const std::vector<OfferWorth>& offers) {
        const bool own = folder == folder_.path();
        PartFigures figures =
            figuresOf(plan, own ? "report.html" : (folder.filename() / "report.html").string());
        figures.picture = pictureOf(plan.part);
        figures.offers = offers;
        addFigures(figures_, figures);
    }

    const BatchJob& job_;
    fs::path batch_;
    const JobFolder& folder_;
    PartFigures figures_;
};

int exitFor(const Error& error, const std::string& part_file) {
    const int exit_code = reportError(error);
    if (error.code() == ErrorCode::OutputUnwritable) return kExitUnwritable;
    if (error.code() == ErrorCode::FileUnreadable && error.subject() == part_file) return kExitMissing;
    return exit_code;
}

}  // namespace

int planBatchJob(const BatchOptions& options, const BatchPlan& plan, const BatchJob& job, int threads,
                 JobFolder& folder, StageBoard& board) {
    const BatchPlan::Source& source = plan.sources.at(job.key.text());
    PlanOptions wanted = planOptions(source.options);
    wanted.part_file = fileOf(source).string();
    wanted.limits = options.limits;
    wanted.viewer = false;  // a megabyte a part
    try {
        const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                                static_cast<std::size_t>(threads));
        ProgressLine progress(board);
        Workplace place{progress, &folder};
        progress.show("beginning", 0);
        sufferFault(options.faults, fs::path(wanted.part_file).filename().string());
        PlannedJob planned(job, options.out_dir, folder);
        const int exit_code = planFile(wanted, place, planned.listener());
        planned.writeRecordOf(exit_code);
        return exit_code;
    } catch (const FileChanged&) {
        tell("{}: is no longer the file that the batch read", wanted.part_file);
        return kExitChanged;
    } catch (const Error& error) {
        return exitFor(error, wanted.part_file);
    } catch (const std::bad_alloc&) {
        throw;  // the supervisor tells
    } catch (const std::exception& error) {
        return reportError(error);
    }
}

}  // namespace stepmill
