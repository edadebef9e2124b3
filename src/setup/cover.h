#pragma once

#include "setup/reach_samples.h"

namespace stepmill::setup {

/// A further setup pays when it alone reaches this share of all that is to be removed, ... Asking more leaves
/// what cutters are too short for from the other side: reach knows sight only.
inline constexpr double kSetupPaysShare = 1e-3;
/// ... or this much of a face that no other setup reaches (a small hole is worth its setup), ...
inline constexpr double kSetupPaysFace = 0.5;
/// ... or when it alone finishes plane, cylinder or cone faces in front of this share, which the others could
/// only leave in steps or reach deep down a gap. Also the parts of all three together.
inline constexpr double kFinishPaysShare = 0.05;

/// The set of axes worth most: what they reach, in units of what pays for a setup, less the number of axes.
/// Branch and bound over the axes: the worth of a further axis only falls as the set grows. Exact where no
/// axis is indexed or steps are finished; else sets that an indexed axis could follow are given up sooner:
/// the exact set by sight takes parts from sides that tools reach less well (of mold_core +x and -x instead
/// of +z, of aagnet_partC three axes that leave six times as much). After 20000 sets it ends with the best so
/// far, as it does on sculpted parts with dozens of axes. Then indexed axes that the others make needless are
/// left out, and others give way to axes along the box, as long as that is worth more.
///
/// \param bonus  by axis, in the same unit: far below 1 to decide between sets that reach the same, negative
///               for axes that cost more than one setup
/// \param steps_finished  faces on which flat cutters leave steps are finished from there all the same
/// \return indices of axes, ascending; empty when nothing is to be removed
std::vector<int> bestAxes(const std::vector<SampleGroup>& groups, const std::vector<double>& bonus,
                          bool steps_finished = false);

/// What the axes see together, however well, in units of what pays for a setup.
double worthSeen(const std::vector<int>& axes, const std::vector<SampleGroup>& groups);

}  // namespace stepmill::setup
