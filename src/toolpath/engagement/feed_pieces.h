#pragma once

#include <vector>

namespace stepmill::toolpath {

/// Where a move is parted so that it may go as fast as each of its pieces allows: shares of its length at
/// which pieces end, rising, the last one 1. Neighbours stay one piece, at the lesser feed, where parting
/// them saves less than a fifth of a second.
/// \param feeds      that each of the stretches allows [mm/min], at least one
/// \param step_mm    the length of a stretch; the last one is as long as what is left
/// \param length_mm  of the whole move
std::vector<double> feedPieces(const std::vector<double>& feeds, double step_mm, double length_mm);

}  // namespace stepmill::toolpath
