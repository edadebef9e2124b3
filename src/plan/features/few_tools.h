#pragma once

#include <string>

#include "stepmill/catalog/tool.h"

namespace stepmill {

/// The tools for holes of a library and at most kFewMills of its end and face mills for the material: the
/// widest, the narrowest and others evenly between, of each diameter the one that is set out farthest. No
/// form cutters. In the library's order.
ToolLibrary fewTools(ToolLibrary library, const std::string& material);

/// Their tool DAG has a tenth of the edges that a library of twenty has.
inline constexpr std::size_t kFewMills = 6;

}  // namespace stepmill
