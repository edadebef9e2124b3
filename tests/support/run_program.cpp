#include "support/run_program.h"
#include "support/text_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace stepmill::test {

namespace fs = std::filesystem;

namespace {

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void redirect(int stream, const fs::path& path) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, stream);
}

/// In a child: the program takes its place, with its streams in these files.
[[noreturn]] void become(std::vector<std::string> arguments, const fs::path& out, const fs::path& err) {
    redirect(STDOUT_FILENO, out);
    redirect(STDERR_FILENO, err);
    std::vector<char*> argv;
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
}

std::vector<std::string> stepFiles(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".step" || extension == ".stp") files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

ProgramRun runProgram(const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    const fs::path out = fs::path(folder.path()) / "out";
    const fs::path err = fs::path(folder.path()) / "err";
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) become(arguments, out, err);
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    ProgramRun run;
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    run.cpu_s = seconds(used.ru_utime) + seconds(used.ru_stime);
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    run.out = slurp(out);
    run.err = slurp(err);
    return run;
}

pid_t startProgram(const std::vector<std::string>& arguments) {
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) become(arguments, "/dev/null", "/dev/null");
    return child;
}

std::string stepmillBinary() {
    return STEPMILL_BINARY;
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "stepmill-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::vector<std::string> sharedParts(const std::string& folder) {
    return stepFiles(fs::path(STEPMILL_SOURCE_DIR).parent_path() / "shared" / "parts" / folder);
}

std::vector<std::string> sampleParts() {
    return stepFiles(fs::path(STEPMILL_SOURCE_DIR) / "step_parts");
}

}  // namespace stepmill::test
