#include "batch/job_run.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "stepmill/batch/job_record.h"
#include "stepmill/core/error.h"

namespace stepmill::batch {
namespace {

/// A book's line about a job holds no more of what it told [bytes].
constexpr std::size_t kMostTold = 4000;

bool isBug(const Supervised& end) {
    return end.end == Supervised::End::Crashed && end.reads == StageBoard::Reads::Own;
}

Outcome outcomeOf(const Supervised& end) {
    switch (end.end) {
        case Supervised::End::Exited:
            return outcomeOfExit(end.exit_code);
        case Supervised::End::TimedOut:
            return Outcome::TimedOut;
        case Supervised::End::OutOfMemory:
            return Outcome::OutOfMemory;
        case Supervised::End::Stopped:
            return Outcome::Waiting;
        case Supervised::End::Killed:
            return Outcome::Killed;
        case Supervised::End::Crashed:
            return isBug(end) ? Outcome::Bug : Outcome::KernelCrash;
    }
    return Outcome::Bug;
}

/// As `stepmill plan` would have exited.
int exitCodeOf(const Supervised& end) {
    constexpr int kBadInput = 2;
    constexpr int kBug = 3;
    if (end.end == Supervised::End::Exited) return end.exit_code > kBug ? kBadInput : end.exit_code;
    return isBug(end) ? kBug : kBadInput;
}

}  // namespace

Outcome outcomeOfExit(int exit_code) {
    switch (exit_code) {
        case 0:
            return Outcome::Complete;
        case 1:
            return Outcome::Gaps;
        case 2:
            return Outcome::Refused;
        case kExitUnwritable:
            return Outcome::Unwritable;
        case kExitMissing:
            return Outcome::Missing;
        case kExitChanged:
            return Outcome::Changed;
        default:
            return Outcome::Bug;
    }
}

Whispers::Whispers() : file_(::memfd_create("stepmill-job", MFD_CLOEXEC)) {
    if (file_ < 0)
        throw Error(ErrorCode::SystemLimit, "system",
                    std::string("grants no file for messages: ") + std::strerror(errno));
}

Whispers::~Whispers() {
    ::close(file_);
}

void Whispers::takeStreams() const {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(file_, STDERR_FILENO);
}

std::string Whispers::text() const {
    std::string told(kMostTold, '\0');
    const ssize_t got = ::pread(file_, told.data(), told.size(), 0);
    told.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    return told;
}

JobRun::JobRun(BatchJob job, const std::filesystem::path& batch, const SupervisedLimits& limits,
               const JobWork& work, const StopSignals& stop)
    : job_(std::move(job)),
      batch_(batch),
      work_(work),
      folder_(jobFolder(batch, job_)),
      child_(
          [this](StageBoard& board) {
              whispers_.takeStreams();
              return work_.plan(job_, folder_, board);
          },
          limits, stop) {}

BatchJob JobRun::finished(const Supervised& end) const {
    BatchJob job = job_;
    job.seconds = child_.elapsed_s();
    job.outcome = outcomeOf(end);
    job.exit_code = exitCodeOf(end);
    job.message = whispers_.text();
    if (end.end != Supervised::End::Exited) {
        tidyFoldersBelow(folder_.path());  // of a file with several solids
        job.message += work_.end_words(end) + "\n";
    }
    if (const std::optional<JobRecord> record = readRecord(batch_, job)) job.figures = record->figures;
    return job;
}

std::optional<BatchJob> JobRun::ended() {
    const std::optional<Supervised> end = child_.ended();
    if (!end) return std::nullopt;
    return finished(*end);
}

}  // namespace stepmill::batch
