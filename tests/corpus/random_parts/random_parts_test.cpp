// Random shop parts are planned and proven: none ends with a proof that fails or books that stay open.
//
// STEPMILL_RANDOM_SEEDS     "from-to", for campaigns; default 1-100
// STEPMILL_RANDOM_TIMEOUT_S of one part; default 15
// STEPMILL_RANDOM_PROGRAM   another build of the program to try
// STEPMILL_RANDOM_KEEP      folder for the files of every seed that fails; default: the temporary folder

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>

#include <fmt/format.h>

#include "support/random_jobs.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

/// Seeds that take longer than the time limit are not judged. How many depends on what else the machine does;
/// a run that judged fewer than this share says too little.
constexpr double kMostTimedOut = 0.5;
constexpr int kBug = 3;

std::string environment(const char* name, const std::string& otherwise) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : otherwise;
}

std::string program() {
    return environment("STEPMILL_RANDOM_PROGRAM", stepmillBinary());
}

struct Seeds {
    std::uint64_t from = 1;
    std::uint64_t to = 100;
};

Seeds seeds() {
    const std::string words = environment("STEPMILL_RANDOM_SEEDS", "1-100");
    const std::size_t dash = words.find('-');
    const std::uint64_t from = std::stoull(words);
    return {from, dash == std::string::npos ? from : std::stoull(words.substr(dash + 1))};
}

enum class Outcome { Complete, Gaps, Refused, TimedOut, Failed, Crashed };

std::string nameOf(Outcome outcome) {
    switch (outcome) {
        case Outcome::Complete:
            return "plan";
        case Outcome::Gaps:
            return "gaps";
        case Outcome::Refused:
            return "refused";
        case Outcome::TimedOut:
            return "timeout";
        case Outcome::Failed:
            return "EXIT 3";
        case Outcome::Crashed:
            break;
    }
    return "CRASHED";
}

Outcome outcomeOf(const ProgramRun& run, double timeout_s) {
    if (run.seconds >= timeout_s) return Outcome::TimedOut;
    switch (run.exit_code) {
        case 0:
            return Outcome::Complete;
        case 1:
            return Outcome::Gaps;
        case 2:
            return Outcome::Refused;
        case kBug:
            return Outcome::Failed;
        default:
            return Outcome::Crashed;
    }
}

/// What was said, each kind once: without ids, places and sizes.
std::string kindsOf(const std::string& said) {
    static const std::regex kNumber("[XYZTS]?-?[0-9]+(\\.[0-9]+)*(\\.O[0-9]+|\\.F[0-9.]+)?");
    std::map<std::string, int> kinds;
    std::size_t from = 0;
    while (from < said.size()) {
        const std::size_t end = std::min(said.find('\n', from), said.size());
        const std::string line = said.substr(from, end - from);
        from = end + 1;
        if (line.find("no program is written") == std::string::npos &&
            line.find("books") == std::string::npos)
            continue;
        const std::string text = line.substr(line.rfind(": ") + 2);
        ++kinds[std::regex_replace(text, kNumber, "#")];
    }
    std::string text;
    for (const auto& [kind, count] : kinds)
        text += fmt::format("{}{} x {}", text.empty() ? "" : "; ", count, kind);
    return text;
}

/// The files of a seed that failed, and the words that run it again.
std::string keep(const RandomJob& job) {
    const fs::path folder = fs::path(environment("STEPMILL_RANDOM_KEEP",
                                                 (fs::temp_directory_path() / "stepmill-random").string())) /
                            job.part.name;
    fs::create_directories(folder);
    std::string command = program();
    for (const std::string& word : writeJob(job, folder.string()))
        command += " " + word;
    return command + " -o " + (folder / "plan").string();
}

struct Totals {
    std::map<Outcome, int> outcomes;
    std::map<std::string, int> kinds;
    int seeds = 0;

    void print() const {
        fmt::print("\n{} seeds:", seeds);
        for (const auto& [outcome, count] : outcomes)
            fmt::print(" {} {}", count, nameOf(outcome));
        fmt::print("\n");
        for (const auto& [kind, count] : kinds)
            fmt::print("{:>5}  {}\n", count, kind);
    }
};

void runSeed(std::uint64_t seed, double timeout_s, Totals& totals) {
    const RandomJob job = randomJob(seed);
    const TemporaryFolder folder;
    std::vector<std::string> words{program()};
    for (const std::string& word : writeJob(job, folder.path()))
        words.push_back(word);
    for (const std::string& word :
         {std::string("-o"), folder.path() + "/plan", std::string("--timeout"), fmt::format("{}", timeout_s)})
        words.push_back(word);
    const ProgramRun run = runProgram(words);
    const Outcome outcome = outcomeOf(run, timeout_s);
    ++totals.seeds;
    ++totals.outcomes[outcome];
    fmt::print("{:>6} {:<8} {:>6.1f} s of processor time  {}\n", seed, nameOf(outcome), run.cpu_s, job.about);
    std::fflush(stdout);
    if (outcome == Outcome::Refused) fmt::print("       {}\n", run.err.substr(0, run.err.find('\n')));
    if (outcome != Outcome::Failed && outcome != Outcome::Crashed) return;
    const std::string kinds = kindsOf(run.err + run.out);
    ++totals.kinds[kinds.empty() ? run.err.substr(0, run.err.find('\n')) : kinds];
    ADD_FAILURE() << "seed " << seed << ":\n" << run.err << "again: " << keep(job);
}

TEST(RandomParts, AreProvenOrSayWhatStays) {
    const Seeds range = seeds();
    const double timeout_s = std::stod(environment("STEPMILL_RANDOM_TIMEOUT_S", "15"));
    Totals totals;
    for (std::uint64_t seed = range.from; seed <= range.to; ++seed)
        runSeed(seed, timeout_s, totals);
    totals.print();
    EXPECT_LE(totals.outcomes[Outcome::TimedOut], std::max(1.0, kMostTimedOut * totals.seeds));
}

TEST(RandomParts, AreTheSameForTheSameSeed) {
    const RandomJob one = randomJob(7);
    const RandomJob other = randomJob(7);
    EXPECT_EQ(one.options, other.options);
    EXPECT_EQ(one.tools_json, other.tools_json);
    EXPECT_EQ(sampleStepText(one.part), sampleStepText(other.part));
}

}  // namespace
}  // namespace stepmill::test
