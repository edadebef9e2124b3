#include "slurm.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <sstream>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "stepmill/core/error.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

/// What a program printed, on both streams, and how it ended.
struct Answer {
    int exit_code = 0;
    std::string text;
};

std::string readAll(int file) {
    std::string text;
    std::array<char, 4096> piece{};
    while (true) {
        const ssize_t got = ::read(file, piece.data(), piece.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return text;
        text.append(piece.data(), static_cast<std::size_t>(got));
    }
}

/// Starts a program whose streams go to `out`.
/// \return why it did not start, 0 where it did
int start(const Words& words, int out, pid_t& child) {
    std::vector<char*> argv;
    for (const std::string& word : words)
        argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions{};
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, out, STDERR_FILENO);
    const int why = ::posix_spawnp(&child, argv.front(), &actions, nullptr, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    return why;
}

/// Runs one of Slurm's programs, without a shell.
Answer ask(const Words& words) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
        throw Error(ErrorCode::SystemLimit, words.front(), std::strerror(errno));
    pid_t child = 0;
    const int why = start(words, pipe[1], child);
    ::close(pipe[1]);
    Answer answer;
    if (why == 0) answer.text = readAll(pipe[0]);
    ::close(pipe[0]);
    if (why != 0)
        throw Error(ErrorCode::Usage, words.front(),
                    fmt::format("cannot be run ({}); is Slurm's client installed here?", std::strerror(why)));
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    answer.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return answer;
}

/// sbatch puts numbers in the place of "%j".
std::string withoutPatterns(const fs::path& path) {
    std::string text;
    for (const char c : path.string())
        text += c == '%' ? std::string("%%") : std::string(1, c);
    return text;
}

Words sbatchWords(const SlurmJob& job) {
    Words words{"sbatch", "--parsable", "--ntasks=1"};
    words.push_back("--job-name=" + job.name);
    words.push_back("--chdir=" + fs::current_path().string());
    words.push_back(fmt::format("--cpus-per-task={}", job.cpus));
    words.push_back(fmt::format("--mem={}M", job.memory_mb));
    words.push_back(
        fmt::format("--output={}/{}.txt", withoutPatterns(job.told), job.tasks.empty() ? "%j" : "%A_%a"));
    words.push_back(job.again_where_lost ? "--requeue" : "--no-requeue");
    if (!job.options.partition.empty()) words.push_back("--partition=" + job.options.partition);
    if (!job.tasks.empty()) words.push_back("--array=" + job.tasks);
    if (!job.after.empty())
        words.push_back(fmt::format("--dependency=afterany:{}", fmt::join(job.after, ":")));
    if (!job.without.empty()) words.push_back("--exclude=" + job.without);
    words.insert(words.end(), job.options.more.begin(), job.options.more.end());
    words.push_back(job.script.string());
    words.insert(words.end(), job.words.begin(), job.words.end());
    return words;
}

Words linesOf(const std::string& text) {
    Words lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        if (!line.empty()) lines.push_back(line);
    return lines;
}

std::string lastLine(const Answer& answer) {
    const Words lines = linesOf(answer.text);
    return lines.empty() ? fmt::format("exit code {}", answer.exit_code) : lines.back();
}

}  // namespace

std::string submitToSlurm(const SlurmJob& job) {
    const Answer answer = ask(sbatchWords(job));
    if (answer.exit_code != 0) throw Error(ErrorCode::Usage, "sbatch", lastLine(answer));
    // "17", or "17;cluster" where there are several; warnings stand before it.
    const std::string number = lastLine(answer);
    return number.substr(0, number.find(';'));
}

std::vector<std::string> slurmJobsNamed(const std::string& name) {
    const Answer answer = ask({"squeue", "--noheader", "--me", "--name=" + name, "--format=%A"});
    if (answer.exit_code != 0) throw Error(ErrorCode::Usage, "squeue", lastLine(answer));
    Words jobs = linesOf(answer.text);
    std::sort(jobs.begin(), jobs.end());
    jobs.erase(std::unique(jobs.begin(), jobs.end()), jobs.end());
    return jobs;
}

}  // namespace stepmill
