#pragma once

#include <vector>

#include "stepmill/feature/feature.h"

namespace stepmill {

/// Features nested one in another straight below, from above, as indices: those that may share ground. A
/// feature that shares with nobody is a nest of its own.
using Nest = std::vector<std::size_t>;

/// Every feature in one nest. A feature goes on in the widest of its children that waits for it alone; holes
/// stay alone, for drills.
/// \param features  parents before children
std::vector<Nest> nestsOf(const std::vector<Feature>& features);

/// The nests by how many lie above each: those of a generation need only what earlier ones know.
std::vector<std::vector<std::size_t>> generationsOf(const std::vector<Nest>& nests,
                                                    const std::vector<Feature>& features);

}  // namespace stepmill
