#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/verify/verify.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

struct PostCommandOptions {
    std::string dir;
    std::string out_dir;
    std::string dialect = "linuxcnc";
    std::string units = "mm";
    std::string per = "setup";
};

/// Proves the programs of `files`; says on stderr what fails.
bool isProven(const PlanFiles& files, const Tolerances& tol) {
    const Verification verification = verifyPlan(files, tol);
    for (const ProofFailure& failure : verification.failures)
        fmt::print(stderr, "stepmill: {}, line {}: {}: {}\n", failure.file, failure.line, failure.operation,
                   failure.text);
    return verification.proven();
}

/// From the proven programs of the plan to programs in another dialect, which are proven before any is
/// written.
int runPost(const PostCommandOptions& options) {
    const Tolerances tol;
    const PlanFiles planned = readPlanFiles(options.dir, std::nullopt, tol);
    if (!isProven(planned, tol)) return kBug;
    const PlanRecord record = planRecordFromText(planned.plan_json, tol);
    const PostOptions request{*dialectFrom(options.dialect), options.units == "inch", options.per == "tool"};
    PlanFiles posted{planned.plan_json, request.dialect, {}};
    for (const RecordedSetup& setup : record.setups)
        posted.programs[setup.id] = post(jobOf(record, setup, readPrograms(planned, setup)), request);
    if (!isProven(posted, tol)) return kBug;

    const fs::path folder = options.out_dir.empty() ? options.dir : options.out_dir;
    std::error_code why;
    fs::create_directories(folder, why);
    if (why) throw Error(ErrorCode::OutputUnwritable, folder.string(), "cannot be made: " + why.message());
    for (const auto& [setup, programs] : posted.programs) {
        for (const PostedProgram& program : programs) {
            writeFile(folder / program.file, program.text);
            fmt::print("{}\n", (folder / program.file).string());
        }
    }
    return kComplete;
}

}  // namespace

void addPostCommand(CLI::App& app, int& exit_code) {
    CLI::App* post = app.add_subcommand("post", "Write the programs of a plan for another controller");
    auto options = std::make_shared<PostCommandOptions>();
    post->add_option("DIR", options->dir, "folder that plan wrote")->required();
    post->add_option("-o,--output", options->out_dir, "folder to write to; default: DIR");
    post->add_option("--dialect", options->dialect, "controller")
        ->check(CLI::IsMember({"linuxcnc", "fanuc", "grbl"}))
        ->capture_default_str();
    post->add_option("--units", options->units, "of the program")
        ->check(CLI::IsMember({"mm", "inch"}))
        ->capture_default_str();
    post->add_option("--per", options->per, "one program for every setup, or for every visit of a tool")
        ->check(CLI::IsMember({"setup", "tool"}))
        ->capture_default_str();
    post->footer(
        "The plan's own programs are proven first, and the new ones before they are written (stepmill "
        "verify):\n"
        "exit code 3 and no program where a proof fails.\n"
        "Examples:\n"
        "  stepmill post bracket-plan --dialect fanuc --units inch\n"
        "  stepmill post bracket-plan --dialect grbl --per tool -o for-the-router");
    post->callback([options, &exit_code] { exit_code = runPost(*options); });
}

}  // namespace stepmill
