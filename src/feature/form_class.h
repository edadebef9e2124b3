#pragma once

#include <vector>

#include "stepmill/feature/part_form.h"

namespace stepmill::feature {

/// Names a group of faces that inner edges or inner rounds join.
PartForm nameForm(const FaceGraph& graph, const std::vector<bool>& on_stock, std::vector<int> faces);

}  // namespace stepmill::feature
