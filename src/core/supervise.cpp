#include "stepmill/core/supervise.h"

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <thread>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "stepmill/core/error.h"

namespace stepmill {
namespace {

constexpr std::size_t kStageBytes = 256;
constexpr int kExitBug = 3;

/// Anonymous memory that parent and child both see.
class SharedText {
  public:
    SharedText() {
        void* memory =
            ::mmap(nullptr, kStageBytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) throw Error(ErrorCode::Internal, "supervisor", std::strerror(errno));
        text_ = static_cast<char*>(memory);
    }
    SharedText(const SharedText&) = delete;
    SharedText& operator=(const SharedText&) = delete;
    ~SharedText() { ::munmap(text_, kStageBytes); }

    char* data() { return text_; }
    std::string read() const { return {text_, ::strnlen(text_, kStageBytes)}; }

  private:
    char* text_ = nullptr;
};

int runGuarded(const std::function<int(StageBoard&)>& work, StageBoard& board) {
    try {
        return work(board);
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

/// The child's whole life. Ends with _exit so that neither static destructors nor a test framework's
/// exit handlers run a second time.
[[noreturn]] void childMain(const std::function<int(StageBoard&)>& work, StageBoard& board, pid_t parent) {
    ::setpgid(0, 0);
    // A parent that is killed takes the child with it: its own group does not get the terminal's Ctrl-C.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(kExitBug);
    const int code = runGuarded(work, board);
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

/// False when time ran out first.
bool waitUntil(pid_t child, double timeout_s) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    auto pause = std::chrono::microseconds(200);
    while (!hasEnded(child)) {
        const std::chrono::duration<double> elapsed = Clock::now() - start;
        if (std::isfinite(timeout_s) && elapsed.count() >= timeout_s) return false;
        std::this_thread::sleep_for(pause);
        pause = std::min(pause * 2, std::chrono::microseconds(5000));
    }
    return true;
}

int reap(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

}  // namespace

/// Gives the supervisor alone the right to point a board at shared memory.
struct SupervisedProcess {
    static StageBoard board(char* text) {
        StageBoard result;
        result.text_ = text;
        return result;
    }
};

void StageBoard::set(const std::string& stage) noexcept {
    if (text_ == nullptr) return;
    const std::size_t length = std::min(stage.size(), kStageBytes - 1);
    std::memcpy(text_, stage.data(), length);
    std::memset(text_ + length, 0, kStageBytes - length);
}

Supervised runSupervised(const std::function<int(StageBoard&)>& work, double timeout_s) {
    SharedText stage;
    flushStreams();  // else the child would write the parent's unwritten output again
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child < 0) throw Error(ErrorCode::Internal, "supervisor", std::strerror(errno));
    if (child == 0) {
        StageBoard board = SupervisedProcess::board(stage.data());
        childMain(work, board, parent);
    }
    ::setpgid(child, child);  // both sides set it, so that it holds whoever runs first

    Supervised result;
    const bool in_time = waitUntil(child, timeout_s);
    ::kill(-child, SIGKILL);  // also what the child may have started and left behind
    const int status = reap(child);
    result.last_stage = stage.read();
    if (!in_time) {
        result.end = Supervised::End::TimedOut;
    } else if (WIFSIGNALED(status)) {
        result.end = Supervised::End::Crashed;
        result.signal = WTERMSIG(status);
    } else {
        result.exit_code = WEXITSTATUS(status);
    }
    return result;
}

}  // namespace stepmill
