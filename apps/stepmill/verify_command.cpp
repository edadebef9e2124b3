#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/verify/verify.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
    std::string dir;
    std::string dialect;
    std::string part_file;
    bool json = false;
};

/// The plan is of this part, byte by byte.
void requirePart(const PlanFiles& files, const std::string& part_file, const Tolerances& tol) {
    const PlanRecord record = planRecordFromText(files.plan_json, tol);
    if (sha256(readFile(part_file)) == record.part_sha256) return;
    throw Error(ErrorCode::Usage, "--part " + part_file,
                "is not the file that was planned: its SHA-256 differs from that of " + record.part_file +
                    " in plan.json");
}

int runVerify(const VerifyOptions& options) {
    const Tolerances tol;
    const PlanFiles files = readPlanFiles(options.dir, dialectFrom(options.dialect), tol);
    if (!options.part_file.empty()) requirePart(files, options.part_file, tol);
    const Verification verification = verifyPlan(files, tol);
    fmt::print("{}", options.json ? verificationJson(verification) : verificationText(verification));
    if (!verification.proven()) return kBug;
    return verification.left.empty() ? kComplete : kGaps;
}

}  // namespace

void addVerifyCommand(CLI::App& app, int& exit_code) {
    CLI::App* verify =
        app.add_subcommand("verify", "Read the programs of a plan back and prove every operation");
    auto options = std::make_shared<VerifyOptions>();
    verify->add_option("DIR", options->dir, "folder that plan wrote")->required();
    verify->add_option("--dialect", options->dialect, "programs that post wrote; default: those of plan.json")
        ->check(CLI::IsMember({"linuxcnc", "fanuc", "grbl"}));
    verify->add_option("--part", options->part_file, "STEP file; must be the one that was planned");
    verify->add_flag("--json", options->json, "print the result as JSON");
    verify->footer(
        "Proven: the cutter keeps off what must stay, nothing stays but what the plan names, rapids, shank "
        "and\n"
        "holder meet no material, feeds and tools are the plan's.\n"
        "Exit codes: 0 proven; 1 proven, but the plan itself leaves something; 2 files missing or "
        "unreadable;\n"
        "3 a proof fails (file and line are named).\n"
        "Examples:\n"
        "  stepmill verify bracket-plan\n"
        "  stepmill verify bracket-plan --dialect grbl --json");
    verify->callback([options, &exit_code] { exit_code = runVerify(*options); });
}

}  // namespace stepmill
