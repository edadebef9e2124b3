#pragma once

#include <CLI/CLI.hpp>

namespace stepmill {

/// Exit codes every command keeps.
enum ExitCode : int {
    kComplete = 0,  ///< all done
    kGaps = 1,      ///< plan written, but something could not be machined as asked
    kBadInput = 2,  ///< bad input or usage, or a run that was stopped
    kBug = 3        ///< a bug in Stepmill and nothing else
};

/// Programs that were read from files do not do what their plan says: whoever edited them can mend that. Of
/// programs of our own making it would be a bug.
inline constexpr ExitCode kUnproven = kBadInput;

/// Each adds one subcommand; what it does runs from CLI11's callback and sets `exit_code`.
void addPlanCommand(CLI::App& app, int& exit_code);
void addRoughCommand(CLI::App& app, int& exit_code);
void addReplanCommand(CLI::App& app, int& exit_code);
void addInspectCommand(CLI::App& app, int& exit_code);
void addBatchCommand(CLI::App& app, int& exit_code);
void addQuoteCommand(CLI::App& app, int& exit_code);
void addRankCommand(CLI::App& app, int& exit_code);
void addToolsCommand(CLI::App& app, int& exit_code);
void addVerifyCommand(CLI::App& app, int& exit_code);
void addPostCommand(CLI::App& app, int& exit_code);

/// Prints an error on stderr as "stepmill: ..." and says which exit code it means.
int reportError(const std::exception& error);

}  // namespace stepmill
