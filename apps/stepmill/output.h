#pragma once

#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace stepmill {

// Every text of a command leaves by these: names from part, tool and machine files cannot steer a terminal.

/// Prints words for people on standard output.
/// \throws Error(OutputUnwritable) when that fails
void printOut(std::string_view text);

/// Prints data for programs on standard output as they are.
/// \throws Error(OutputUnwritable) when that fails
void printData(std::string_view text);

/// Hands over what standard output still holds.
/// \throws Error(OutputUnwritable) when it cannot take it: a full disk must not pass for success
void flushOut();

/// Prints on standard error; there is nobody to tell when that fails.
void printErr(std::string_view text);

/// "stepmill: ..." and an end of line on standard error.
template <class... Arguments>
void tell(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    printErr("stepmill: " + fmt::format(format, std::forward<Arguments>(arguments)...) + "\n");
}

}  // namespace stepmill
