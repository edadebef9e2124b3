#pragma once

#include "setup/facets.h"

namespace stepmill::setup {

/// \throws Error(Usage) unless the stock solid contains the part, with where it sticks out and by how much.
void checkContained(const Part& part, const Facets& part_facets, const Part& stock);

}  // namespace stepmill::setup
