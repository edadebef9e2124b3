#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "output.h"
#include "run.h"
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
    bool optional_stops = false;
    RunLimits limits;
};

/// Proves the plan's programs; says on stderr what fails.
bool isProven(const RecordedPlan& plan, const Tolerances& tol) {
    const Verification verification = verifyRecorded(plan, tol);
    for (const ProofFailure& failure : verification.failures)
        tell("{}, line {}: {}: {}", failure.file, failure.line, failure.operation, failure.text);
    return verification.proven();
}

/// The same plan with programs in another dialect.
RecordedPlan postAll(const RecordedPlan& planned, const PostOptions& request) {
    RecordedPlan posted{{planned.files.plan_json, request.dialect, {}}, planned.record};
    for (const RecordedSetup& setup : planned.record.setups)
        if (planned.files.programs.at(setup.id).empty() && !setup.hasProgram())
            posted.files.programs[setup.id];  // its machine is too small, or nothing is cut: nothing to post
        else
            posted.files.programs[setup.id] =
                post(jobOf(planned.record, setup, readPrograms(planned.files, setup)), request);
    return posted;
}

/// A plan that was edited is not the one that its folder's other files belong to.
void requireUnchangedPlan(const fs::path& dir, const std::string& plan_json) {
    const std::optional<Manifest> manifest = readManifest(dir);
    const ManifestFile* plan = manifest ? findFile(*manifest, "plan.json") : nullptr;
    if (plan != nullptr && plan->sha256 != sha256(plan_json))
        throw Error(ErrorCode::InvalidCatalog, (dir / "plan.json").string(),
                    "has been changed since it was written; plan again before posting");
}

void writePrograms(const RecordedPlan& posted, const fs::path& shown_folder, JobFolder& folder) {
    const PlanRecord& record = posted.record;
    const PlanFiles& files = posted.files;
    NewJob job{JobWriter::Post, record.part_file, record.part_sha256, sha256(files.plan_json), {}, {}};
    std::string names;
    for (const auto& [setup, programs] : files.programs) {
        for (const PostedProgram& program : programs) {
            job.files.push_back({program.file, toString(files.dialect), program.text});
            names += (shown_folder / program.file).string() + "\n";
        }
    }
    folder.write(job);
    tellReplacedEdits(folder);
    printOut(names);
}

fs::path folderOf(const PostCommandOptions& options) {
    return options.out_dir.empty() ? options.dir : options.out_dir;
}

/// From the proven programs of the plan to programs in another dialect, which are proven before any is
/// written.
int postPlan(const PostCommandOptions& options, Workplace& place) {
    const Tolerances tol;
    place.progress.show("reading the files", 0);
    const RecordedPlan planned = readPlan(options.dir, std::nullopt, tol, options.limits.maxFileBytes());
    requireUnchangedPlan(options.dir, planned.files.plan_json);
    place.progress.show("proving the plan's programs", 0.1);
    if (!isProven(planned, tol)) return kUnproven;
    const PostOptions request{*dialectFrom(options.dialect), options.units == "inch", options.per == "tool",
                              options.optional_stops};
    const RecordedPlan posted = postAll(planned, request);
    place.progress.show("proving the new programs", 0.5);
    if (!isProven(posted, tol)) return kBug;
    place.progress.show("writing the programs", 1);
    writePrograms(posted, folderOf(options), *place.folder);
    return kComplete;
}

int runPost(const PostCommandOptions& options) {
    return runInChild({options.dir, options.limits, 0, folderOf(options)},
                      [&](Workplace& place) { return postPlan(options, place); });
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
    post->add_flag("--optional-stop", options->optional_stops,
                   "M1 before every operation but the first, with the spindle home");
    addLimitOptions(*post, options->limits);
    post->footer(
        "The plan's own programs are proven first, and the new ones before they are written (stepmill "
        "verify):\n"
        "exit code 2 and no program where a proof fails. Programs that an earlier post of the dialect left "
        "are\n"
        "replaced.\n"
        "Examples:\n"
        "  stepmill post bracket-plan --dialect fanuc --units inch\n"
        "  stepmill post bracket-plan --dialect grbl --per tool -o for-the-router");
    post->callback([options, &exit_code] { exit_code = runPost(*options); });
}

}  // namespace stepmill
