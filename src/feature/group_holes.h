#pragma once

#include <vector>

#include "stepmill/feature/feature.h"

namespace stepmill::feature {

/// Joins equal holes to one feature each: of one diameter, from one height to another, below the same
/// features, with the same room for holders beside them. Their targets become the components of one. Such
/// holes keep nothing clear of each other, since closed ground counts as cut, so obstruction and obstacles
/// are those of each. Features keep their order, a group that of its first hole.
/// \pre parents before children
void groupEqualHoles(std::vector<Feature>& features, const Tolerances& tol);

}  // namespace stepmill::feature
