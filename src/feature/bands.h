#pragma once

#include "stepmill/feature/feature.h"

namespace stepmill::feature {

/// Makes bands of one feature of features that only go on below one another, where nobody would see two:
/// walls that lean or bend make one at every level of the stack [Li2001, hunt layers of one cavity].
///
/// A feature goes on in its child where no horizontal face of the part ends it there; where it splits, in the
/// child with most area. A hole with upright walls is a feature of its own, since a drill makes it. Ids
/// become S1.F2.1, S1.F2.2 and so on; numbers of features stay without gaps.
/// \note  O(features x faces of the part).
void joinBands(std::vector<Feature>& features, const LayerStack& layers, const Tolerances& tol);

}  // namespace stepmill::feature
