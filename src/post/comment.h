#pragma once

#include <string>
#include <string_view>

namespace stepmill {

/// A G-code comment that every controller can read: one line in brackets, printable ASCII, no brackets
/// within, cut to a length LinuxCNC takes.
std::string comment(std::string_view text);

}  // namespace stepmill
