#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace stepmill::test {

/// What a program printed and how it ended.
struct ProgramRun {
    int exit_code = -1;  ///< -1 when it died of a signal
    std::string out;
    std::string err;
    double seconds = 0;  ///< on the clock
    double cpu_s = 0;    ///< of processor time, children included
};

/// Runs a program without a shell and waits for it.
ProgramRun runProgram(const std::vector<std::string>& arguments);

/// Starts a program in silence; who calls awaits its end.
pid_t startProgram(const std::vector<std::string>& arguments);

/// The program under test.
std::string stepmillBinary();

/// A new empty folder under the system's temporary folder, removed with this object.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

/// STEP files of a folder beside the checkout ("../shared/parts/<name>") or of step_parts, sorted; empty
/// when the folder is missing.
std::vector<std::string> sharedParts(const std::string& folder);
std::vector<std::string> sampleParts();

}  // namespace stepmill::test
