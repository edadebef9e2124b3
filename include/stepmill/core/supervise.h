#pragma once

#include <functional>
#include <string>

namespace stepmill {

/// Where a supervised run stands; shared memory, so that the parent can read it after the child has died.
class StageBoard {
  public:
    /// Names what is being done now ("importing part.step"). At most 255 bytes are kept.
    void set(const std::string& stage) noexcept;

  private:
    friend struct SupervisedProcess;
    char* text_ = nullptr;
};

/// How a supervised child ended.
struct Supervised {
    enum class End { Exited, TimedOut, Crashed };
    End end = End::Exited;
    int exit_code = 0;       ///< when Exited
    int signal = 0;          ///< when Crashed
    std::string last_stage;  ///< what the child was doing last
};

/// Runs `work` in a child process and really ends it after `timeout_s` (SIGKILL to its process group), so
/// that neither an endless loop nor a crash inside a geometry kernel can take the program with it.
/// Standard streams are shared with the child. `work`'s return value becomes the exit code.
/// \pre no other thread runs in the calling process (fork)
Supervised runSupervised(const std::function<int(StageBoard&)>& work, double timeout_s);

}  // namespace stepmill
