#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "output.h"
#include "run.h"
#include "stepmill/core/error.h"
#include "stepmill/verify/verify.h"
#include "verify_claim.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
    std::string dir;
    std::string dialect;
    ClaimOptions claim;
    bool json = false;
    RunLimits limits;
};

bool isAmong(const PlanFiles& files, const std::string& name) {
    for (const auto& [setup, programs] : files.programs)
        for (const PostedProgram& program : programs)
            if (program.file == name) return true;
    return false;
}

/// A name that a post gives one of the plan's setups.
bool isOfAPost(const PlanFiles& files, const std::string& name) {
    for (const auto& [setup, programs] : files.programs)
        for (const Dialect dialect : {Dialect::LinuxCnc, Dialect::Fanuc, Dialect::Grbl})
            if (name == programName(setup, dialect)) return true;
    return false;
}

/// What lies in the folder beside what was read: programs that nobody knows are failures, the rest is told.
void addFolder(const JobCheck& check, const std::vector<ManifestFile>& written, const PlanFiles& files,
               Verification& verification) {
    for (const std::string& name : check.programs) {
        if (isAmong(files, name)) continue;
        if (!check.has_manifest && isOfAPost(files, name))
            verification.remarks.push_back({name, FileRemark::Kind::NotRead});
        else
            verification.failures.push_back({name, 0, "", "is a program that is not of this job"});
    }
    for (const std::string& name : check.changed)
        verification.remarks.push_back({name, FileRemark::Kind::Changed});
    for (const std::string& name : check.missing)
        verification.remarks.push_back({name, FileRemark::Kind::Missing});
    for (const ManifestFile& file : written)
        if (!file.dialect.empty() && !isAmong(files, file.name))
            verification.remarks.push_back({file.name, FileRemark::Kind::NotRead});
}

/// Has the plan a setup that its machine is too small for?
bool lacksPrograms(const RecordedPlan& plan) {
    return std::any_of(plan.record.setups.begin(), plan.record.setups.end(), [&](const RecordedSetup& setup) {
        return !setup.within_travel && plan.files.programs.at(setup.id).empty();
    });
}

int verifyFolder(const VerifyOptions& options, Workplace& place) {
    const Tolerances tol;
    place.progress.show("reading the files", 0);
    const JobCheck check = checkJob(options.dir);
    const RecordedPlan plan =
        readPlan(options.dir, dialectFrom(options.dialect), tol, options.limits.maxFileBytes());
    place.progress.show("proving the programs", 0.1);
    Verification verification = verifyRecorded(plan, tol);
    verifyClaim(options.claim, plan, options.limits.maxFileBytes(), tol, verification);
    addFolder(check, readManifest(options.dir).value_or(Manifest{}).files, plan.files, verification);
    if (options.json)
        printData(verificationJson(verification));
    else
        printOut(verificationText(verification));
    if (!verification.proven()) return kUnproven;
    if (lacksPrograms(plan) || plan.record.threads_missing > 0) return kGaps;
    return leavesUnasked(plan.record, tol) ? kGaps : kComplete;
}

int runVerify(const VerifyOptions& options) {
    return runInChild({options.dir, options.limits},
                      [&](Workplace& place) { return verifyFolder(options, place); });
}

}  // namespace

void addVerifyCommand(CLI::App& app, int& exit_code) {
    CLI::App* verify =
        app.add_subcommand("verify", "Read the programs of a plan back and prove every operation");
    auto options = std::make_shared<VerifyOptions>();
    verify->add_option("DIR", options->dir, "folder that plan wrote")->required();
    verify->add_option("--dialect", options->dialect, "programs that post wrote; default: those of plan.json")
        ->check(CLI::IsMember({"linuxcnc", "fanuc", "grbl"}));
    addClaimOptions(*verify, options->claim);
    verify->add_flag("--json", options->json, "print the result as JSON");
    addLimitOptions(*verify, options->limits);
    verify->footer(
        "Proven: the cutter keeps off what must stay, nothing stays but what the plan names, rapids, shank "
        "and\n"
        "holder meet no material, feeds and tools are the plan's.\n"
        "Programs in the folder that are not of the job fail; files that are not as they were written are "
        "named.\n"
        "Exit codes: 0 proven; 1 proven, but the plan itself leaves something, of roughing more than it is "
        "meant to;\n"
        "2 a proof fails (file and line are named), or files are missing or unreadable.\n"
        "Examples:\n"
        "  stepmill verify bracket-plan\n"
        "  stepmill verify bracket-plan --part bracket.step --tools my_tools.json --machine my_mill.json\n"
        "  stepmill verify bracket-plan --dialect grbl --json");
    verify->callback([options, &exit_code] { exit_code = runVerify(*options); });
}

}  // namespace stepmill
