#pragma once

#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::toolpath {

/// A place that is entered at one point and left at another.
struct Stop {
    Vec2 in = Vec2::Zero();
    Vec2 out = Vec2::Zero();
};

/// Order of the stops for short straight ways between them, first and last free: the nearest next from
/// several firsts, then 2-opt and moving of stretches until neither makes the ways shorter. Deterministic;
/// never longer than the order given.
std::vector<std::size_t> visitOrder(const std::vector<Stop>& stops);

}  // namespace stepmill::toolpath
