#pragma once

#include <chrono>
#include <csignal>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <sys/types.h>

#include "stepmill/core/memory_groups.h"

namespace stepmill {

/// What supervisor and child both see; lives in shared memory, so that the parent can read it after the child
/// has died.
struct SharedBoard;

/// Where a supervised run stands.
class StageBoard {
  public:
    /// Whose data the work is on: a crash on input that a foreign library reads is the input's.
    enum class Reads { Own, Input };

    /// Names what is being done now ("importing part.step"). At most 255 bytes are kept.
    void set(const std::string& stage, Reads reads = Reads::Own) noexcept;

  private:
    friend struct SupervisedProcess;
    SharedBoard* board_ = nullptr;
};

/// How a supervised child ended.
struct Supervised {
    enum class End {
        Exited,       ///< by itself, with exit_code
        TimedOut,     ///< the time limit ended it
        OutOfMemory,  ///< it asked for more than its limit, or than the system has
        Stopped,      ///< the caller got a signal that ends it (StopSignals); the child was ended for that
        Killed,       ///< a signal from outside ended the child: the system short of memory, a user, a limit
        Crashed       ///< a signal that its own code raised: a bug
    };
    End end = End::Exited;
    int exit_code = 0;       ///< when Exited
    int signal = 0;          ///< when Stopped, Killed or Crashed
    std::string last_stage;  ///< what the child was doing last; empty when it named nothing
    StageBoard::Reads reads = StageBoard::Reads::Own;  ///< during that stage
};

/// Holds SIGINT, SIGTERM and SIGHUP back while it lives, so that what must be tidied up is tidied up before
/// one of them ends the process. Those that are ignored stay ignored.
class StopSignals {
  public:
    StopSignals();
    /// What is still held back takes effect.
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// Waits for one of them and takes it; 0 when none came in time.
    int waitFor(std::chrono::nanoseconds time) const;
    /// For a child process: they take effect again.
    void letThrough() const;

  private:
    sigset_t held_;
    sigset_t before_;
};

/// What a supervised child may take.
struct SupervisedLimits {
    double timeout_s = 0;            ///< infinite: no limit
    std::uint64_t memory_bytes = 0;  ///< private memory (RLIMIT_DATA: heap and stacks, not what is merely
                                     ///< mapped); 0: no limit but the caller's own
    /// Where the child's group is made, so that all it takes counts; or none.
    MemoryGroups* groups = nullptr;
};

/// A child process that works under supervision, beside others where a caller has several. It is really ended
/// at its limit of time (SIGKILL to its process group), when the caller dies, and with this object.
/// Standard streams are shared with the child. `work`'s return value becomes the exit code. Writing beyond a
/// file size limit fails in the child and does not end it.
class SupervisedChild {
  public:
    /// \param stop  held by the caller; its signals take effect again in the child
    /// \throws Error(SystemLimit) where the system grants no further process or memory
    /// \pre no other thread runs in the calling process (fork); the time limit is a number above 0
    SupervisedChild(const std::function<int(StageBoard&)>& work, const SupervisedLimits& limits,
                    const StopSignals& stop);
    ~SupervisedChild();
    SupervisedChild(const SupervisedChild&) = delete;
    SupervisedChild& operator=(const SupervisedChild&) = delete;

    /// How it ended; nothing while it works. Ends it where its time is over.
    std::optional<Supervised> ended();
    /// Ends it now, for a signal that the caller got.
    Supervised endFor(int signal);
    /// Since its start [s].
    double elapsed_s() const;

  private:
    Supervised finish();

    std::unique_ptr<SharedBoard, void (*)(SharedBoard*)> board_;
    std::unique_ptr<MemoryGroup> group_;  ///< of the child; null without a limit by group
    pid_t child_ = 0;                     ///< 0: reaped
    double timeout_s_;
    std::chrono::steady_clock::time_point start_;
};

/// Runs `work` in a supervised child and waits for its end. SIGINT, SIGTERM and SIGHUP to the caller end the
/// child and are told in the result: the caller may then tidy up, and is to end by that signal.
/// \throws what SupervisedChild does
/// \pre as for SupervisedChild
Supervised runSupervised(const std::function<int(StageBoard&)>& work, double timeout_s,
                         std::uint64_t memory_bytes = 0);

}  // namespace stepmill
