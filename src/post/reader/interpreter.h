#pragma once

#include <string>
#include <string_view>

#include "post/reader/action.h"
#include "stepmill/post/post.h"

namespace stepmill::reader {

/// Runs a program: what the machine does, in order.
/// \throws as readProgram() does, but for comments and operations, of which it knows nothing.
Run runProgram(std::string_view text, const std::string& file, Dialect dialect);

}  // namespace stepmill::reader
