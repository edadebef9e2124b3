#pragma once

#include <vector>

#include "stepmill/catalog/filled_field.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/catalog/usual_values.h"

namespace stepmill {

/// Puts usual values where the tool says nothing and says which. What it says stays.
/// Cutting data come for every material of the table that the tool has none for; a mill's data without
/// step-over or step-down get the table's. A feed per tooth needs the number of flutes.
std::vector<FilledField> fillFrom(const UsualValues& usual, ToolAssembly& tool);

}  // namespace stepmill
