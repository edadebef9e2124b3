#include "stepmill/core/supervise.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "stepmill/core/error.h"

namespace stepmill {

struct SharedBoard {
    static constexpr std::size_t kStageBytes = 256;
    char stage[kStageBytes] = {};
    std::atomic<bool> out_of_memory = false;
    std::atomic<StageBoard::Reads> reads = StageBoard::Reads::Own;

    std::string text() const { return {stage, ::strnlen(stage, kStageBytes)}; }
};

namespace {

constexpr int kExitBug = 3;

[[noreturn]] void refuse(const char* what) {
    throw Error(ErrorCode::SystemLimit, "system",
                std::string("grants no ") + what + ": " + std::strerror(errno));
}

/// The board in anonymous memory that parent and child both see.
SharedBoard* newBoard() {
    void* memory =
        ::mmap(nullptr, sizeof(SharedBoard), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) refuse("memory to share with a child");
    return new (memory) SharedBoard;
}

void unmapBoard(SharedBoard* board) {
    ::munmap(board, sizeof(SharedBoard));
}

/// A new-handler has no arguments: this is where it finds its process' board.
SharedBoard* board_of_this_child = nullptr;

/// Ends the child at the first allocation that fails. An exception instead could be caught on its way, as the
/// failure of one feature say, and the plan would depend on how much memory there was.
[[noreturn]] void endOutOfMemory() {
    board_of_this_child->out_of_memory = true;
    ::_exit(kExitBug);
}

int runGuarded(const std::function<int(StageBoard&)>& work, StageBoard& board) {
    try {
        return work(board);
    } catch (const std::bad_alloc&) {
        endOutOfMemory();  // thrown by hand: malloc's failures call no handler
    } catch (const std::exception& error) {
        std::cerr << "internal error: " << error.what() << '\n';
    } catch (...) {
        std::cerr << "internal error: an exception that is not a std::exception\n";
    }
    return kExitBug;
}

void flushStreams() {
    std::cout.flush();
    std::cerr.flush();
    std::clog.flush();
    std::fflush(nullptr);
}

#ifdef STEPMILL_SANITIZED
constexpr bool kShadowed = true;  // the sanitizer's shadow alone is larger than any limit
#else
constexpr bool kShadowed = false;
#endif

void limitMemory(std::uint64_t bytes) {
    if (bytes == 0 || kShadowed) return;
    rlimit limit{};
    ::getrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
    ::setrlimit(RLIMIT_DATA, &limit);
}

/// The child's whole life. Ends with _exit so that neither static destructors nor a test framework's
/// exit handlers run a second time.
[[noreturn]] void childMain(const std::function<int(StageBoard&)>& work, StageBoard& stage,
                            SharedBoard* board, pid_t parent) {
    ::setpgid(0, 0);
    // A parent that is killed takes the child with it: its own group does not get the terminal's Ctrl-C.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(kExitBug);
    board_of_this_child = board;
    std::set_new_handler(endOutOfMemory);
    const int code = runGuarded(work, stage);
    flushStreams();
    ::_exit(code);
}

/// True once the child has ended; leaves it as a zombie so that its id cannot be reused yet.
bool hasEnded(pid_t child) {
    siginfo_t info{};
    const int result = ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT);
    if (result != 0) return errno != EINTR;
    return info.si_pid == child;
}

int reap(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

/// Signals that a process' own code raises; all others come from outside.
bool isCrash(int signal) {
    constexpr std::array kOwn = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS};
    return std::find(kOwn.begin(), kOwn.end(), signal) != kOwn.end();
}

void describeEnd(int status, Supervised& result) {
    if (!WIFSIGNALED(status)) {
        result.exit_code = WEXITSTATUS(status);
        return;
    }
    result.signal = WTERMSIG(status);
    result.end = isCrash(result.signal) ? Supervised::End::Crashed : Supervised::End::Killed;
}

}  // namespace

/// Gives the supervisor alone the right to point a board at shared memory.
struct SupervisedProcess {
    static StageBoard stageOn(SharedBoard* board) {
        StageBoard result;
        result.board_ = board;
        return result;
    }
};

void StageBoard::set(const std::string& stage, Reads reads) noexcept {
    if (board_ == nullptr) return;
    board_->reads = reads;
    const std::size_t length = std::min(stage.size(), SharedBoard::kStageBytes - 1);
    std::memcpy(board_->stage, stage.data(), length);
    std::memset(board_->stage + length, 0, SharedBoard::kStageBytes - length);
}

StopSignals::StopSignals() {
    ::sigemptyset(&held_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action {};
        ::sigaction(signal, nullptr, &action);
        if (action.sa_handler != SIG_IGN) ::sigaddset(&held_, signal);
    }
    ::sigprocmask(SIG_BLOCK, &held_, &before_);
}

StopSignals::~StopSignals() {
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
}

void StopSignals::letThrough() const {
    ::sigprocmask(SIG_UNBLOCK, &held_, nullptr);
}

int StopSignals::waitFor(std::chrono::nanoseconds time) const {
    constexpr std::int64_t kSecond = 1000000000;
    const timespec limit{static_cast<time_t>(time.count() / kSecond),
                         static_cast<long>(time.count() % kSecond)};
    const int signal = ::sigtimedwait(&held_, nullptr, &limit);
    return std::max(signal, 0);
}

SupervisedChild::SupervisedChild(const std::function<int(StageBoard&)>& work, const SupervisedLimits& limits,
                                 const StopSignals& stop)
    : board_(newBoard(), unmapBoard), timeout_s_(limits.timeout_s), start_(std::chrono::steady_clock::now()) {
    STEPMILL_CHECK(timeout_s_ > 0, "a time limit is a number");
    if (limits.groups != nullptr && limits.memory_bytes > 0)
        group_ = limits.groups->make(limits.memory_bytes);
    flushStreams();  // else the child would write the parent's unwritten output again
    const pid_t parent = ::getpid();
    child_ = ::fork();
    if (child_ < 0) refuse("further process");
    if (child_ == 0) {
        stop.letThrough();
        std::signal(SIGXFSZ, SIG_IGN);
        // Both: an allocation beyond the first limit fails, which the child can tell; the second counts all.
        limitMemory(limits.memory_bytes);
        if (group_ && !group_->enter()) ::_exit(kExitBug);
        StageBoard stage = SupervisedProcess::stageOn(board_.get());
        childMain(work, stage, board_.get(), parent);
    }
    ::setpgid(child_, child_);  // both sides set it, so that it holds whoever runs first
}

SupervisedChild::~SupervisedChild() {
    if (child_ > 0) finish();
}

double SupervisedChild::elapsed_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

/// Ends what still runs, and tells what the child's own end was.
Supervised SupervisedChild::finish() {
    ::kill(-child_, SIGKILL);  // also what the child may have started and left behind
    const int status = reap(child_);
    child_ = 0;
    Supervised result;
    result.last_stage = board_->text();
    result.reads = board_->reads;
    if (board_->out_of_memory || (group_ && group_->ranOut()))
        result.end = Supervised::End::OutOfMemory;
    else
        describeEnd(status, result);
    return result;
}

std::optional<Supervised> SupervisedChild::ended() {
    if (hasEnded(child_)) return finish();
    if (elapsed_s() < timeout_s_) return std::nullopt;
    Supervised result = finish();
    result.end = Supervised::End::TimedOut;
    return result;
}

Supervised SupervisedChild::endFor(int signal) {
    Supervised result = finish();
    result.end = Supervised::End::Stopped;
    result.signal = signal;
    return result;
}

Supervised runSupervised(const std::function<int(StageBoard&)>& work, double timeout_s,
                         std::uint64_t memory_bytes) {
    const StopSignals stop;
    SupervisedChild child(work, {timeout_s, memory_bytes}, stop);
    auto pause = std::chrono::microseconds(200);
    while (true) {
        if (const std::optional<Supervised> end = child.ended()) return *end;
        const int signal = stop.waitFor(pause);
        if (signal != 0) return child.endFor(signal);
        pause = std::min(pause * 2, std::chrono::microseconds(5000));
    }
}

}  // namespace stepmill
