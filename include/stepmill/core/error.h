#pragma once

#include <stdexcept>
#include <string>

namespace stepmill {

/// Why a run cannot go on. Callers and tests look at the code, never at the text.
enum class ErrorCode {
    Usage,             ///< an argument or option value makes no sense
    FileUnreadable,    ///< missing, a folder, no permission
    NotStep,           ///< the file is something else than STEP
    StepDamaged,       ///< STEP, but truncated or with tokens no reader can take
    NoSolid,           ///< nothing closed to machine: surfaces, wires, references only
    OpenShell,         ///< a shell with free edges where a solid is expected
    InvalidSolid,      ///< the solid stays invalid after healing
    ImplausibleSize,   ///< dimensions no mill can take or no cutter can follow
    InvalidCatalog,    ///< tool library, machine or plan file breaks its schema
    OutputUnwritable,  ///< the output folder or file cannot be written
    TimedOut,          ///< the time for it was over
    SystemLimit,       ///< the system grants no further process or memory
    InvalidRegion,     ///< a planar region breaks the rules of region.h
    GeometryKernel,    ///< OpenCASCADE or GEOS failed on good input
    Internal           ///< a Stepmill invariant does not hold: a bug
};

/// The one exception that crosses module boundaries.
///
/// `subject` names what the trouble is about ("part.step", "face 17", "tools.json#/tools/3/diameter");
/// `what()` is "subject: message", ready to print.
class Error : public std::runtime_error {
  public:
    Error(ErrorCode code, std::string subject, const std::string& message);

    ErrorCode code() const noexcept { return code_; }
    const std::string& subject() const noexcept { return subject_; }

  private:
    ErrorCode code_;
    std::string subject_;
};

/// True for errors the user can mend by changing input or arguments (exit code 2); the others are
/// bugs or kernel failures (exit code 3).
bool isInputError(ErrorCode code) noexcept;

namespace detail {
[[noreturn]] void checkFailed(const char* condition, const char* file, int line, const std::string& why);
}

/// Throws Error(Internal) when a programmer's assumption does not hold; stays on in release builds.
#define STEPMILL_CHECK(condition, why)                                                          \
    do {                                                                                        \
        if (!(condition)) ::stepmill::detail::checkFailed(#condition, __FILE__, __LINE__, why); \
    } while (false)

}  // namespace stepmill
