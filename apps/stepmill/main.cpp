#include <malloc.h>

#include <csignal>
#include <exception>
#include <new>
#include <sstream>

#include "commands.h"
#include "output.h"
#include "stepmill/core/error.h"

namespace stepmill {

int reportError(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
        tell("ran out of memory");
        return kBadInput;
    }
    tell("{}", error.what());
    const auto* known = dynamic_cast<const Error*>(&error);
    return known != nullptr && isInputError(known->code()) ? kBadInput : kBug;
}

namespace {

/// The heap keeps what is freed, up to this [bytes]: giving pages back and asking for them anew takes a third
/// of the time of a small plan.
constexpr int kKeptHeapBytes = 1 << 30;
/// Blocks up to this come from that heap [bytes]; the C library allows no more.
constexpr int kLargestHeapBlock = 32 << 20;

void keepFreedHeap() {
    mallopt(M_MMAP_THRESHOLD, kLargestHeapBlock);
    mallopt(M_TRIM_THRESHOLD, kKeptHeapBytes);
}

/// Help that was asked for, or what is wrong with the arguments.
int tellParsing(const CLI::App& app, const CLI::ParseError& stop) {
    std::ostringstream help;
    std::ostringstream trouble;
    const int code = app.exit(stop, help, trouble);
    printOut(help.str());
    printErr(trouble.str());
    return code == 0 ? kComplete : kBadInput;
}

}  // namespace

}  // namespace stepmill

int main(int argc, char** argv) {
    stepmill::keepFreedHeap();
    CLI::App app{"Plans 2.5D milling of a STEP part: setups, features, cutters, paths, times and money."};
    app.set_version_flag("--version", std::string("stepmill ") + STEPMILL_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 complete; 1 plan with gaps; 2 bad input or usage, a limit reached, or programs that "
        "fail\n"
        "their proof; 3 a bug in Stepmill and nothing else.");

    int exit_code = stepmill::kComplete;
    stepmill::addPlanCommand(app, exit_code);
    stepmill::addRoughCommand(app, exit_code);
    stepmill::addReplanCommand(app, exit_code);
    stepmill::addBatchCommand(app, exit_code);
    stepmill::addQuoteCommand(app, exit_code);
    stepmill::addInspectCommand(app, exit_code);
    stepmill::addRankCommand(app, exit_code);
    stepmill::addVerifyCommand(app, exit_code);
    stepmill::addPostCommand(app, exit_code);
    stepmill::addToolsCommand(app, exit_code);
    try {
        std::signal(SIGXFSZ, SIG_IGN);  // a write that fails can be told
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& stop) {
            exit_code = stepmill::tellParsing(app, stop);
        }
        stepmill::flushOut();
    } catch (const std::exception& error) {
        return stepmill::reportError(error);
    }
    return exit_code;
}
