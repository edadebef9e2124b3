#include <exception>

#include "commands.h"
#include "stepmill/core/error.h"

#include <fmt/core.h>

namespace stepmill {

int reportError(const std::exception& error) {
    fmt::print(stderr, "stepmill: {}\n", error.what());
    const auto* known = dynamic_cast<const Error*>(&error);
    return known != nullptr && isInputError(known->code()) ? kBadInput : kBug;
}

}  // namespace stepmill

int main(int argc, char** argv) {
    CLI::App app{"Plans 2.5D milling of a STEP part: setups, features, cutters, paths, times and money."};
    app.set_version_flag("--version", std::string("stepmill ") + STEPMILL_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 complete, 1 plan with gaps, 2 bad input or usage, 3 a proof fails or a bug in "
        "Stepmill.");

    int exit_code = stepmill::kComplete;
    stepmill::addPlanCommand(app, exit_code);
    stepmill::addInspectCommand(app, exit_code);
    stepmill::addRankCommand(app, exit_code);
    stepmill::addVerifyCommand(app, exit_code);
    stepmill::addPostCommand(app, exit_code);
    stepmill::addToolsCommand(app, exit_code);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& stop) {
        return app.exit(stop) == 0 ? stepmill::kComplete : stepmill::kBadInput;
    } catch (const std::exception& error) {
        return stepmill::reportError(error);
    }
    return exit_code;
}
