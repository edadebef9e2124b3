#pragma once

#include <string>

namespace stepmill::test {

/// What a person reads on an HTML page: no styles, no drawings, a line a paragraph or table row, cells parted
/// by bars.
std::string pageText(const std::string& html);

}  // namespace stepmill::test
