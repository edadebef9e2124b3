#include "toolpath/script/linker.h"

#include <algorithm>

#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

namespace {

/// Links are tried to this many of the nearest passes before the cutter is lifted.
constexpr std::size_t kLinkTrials = 8;

}  // namespace

Linker::Linker(const DepthTask& task, const RingFamily::Component& component, const SweptGround& before,
               DepthProgress& progress)
    : task_(task), component_(component), before_(before), progress_(progress) {}

bool Linker::linkOn() {
    if (progress_.last() < 0) return false;
    const std::vector<Joint> joints = progress_.waiting(true);
    for (std::size_t i = 0; i < std::min(joints.size(), kLinkTrials); ++i)
        if (tryLink(joints[i])) return true;
    return false;
}

bool Linker::isNeighbour(const Joint& joint) const {
    const std::vector<int>& neighbours = progress_.pass(joint.pass).neighbours;
    return std::count(neighbours.begin(), neighbours.end(), progress_.last()) > 0 &&
           joint.distance_mm <= kNeighbourLink * task_.step_over_mm;
}

bool Linker::tryLink(const Joint& joint) {
    const bool neighbour = isNeighbour(joint);
    const Vec2& to = joint.at.point;
    if (!neighbour && !isShorter(joint)) return false;
    if (!isFreeWay(component_, progress_.at(), to, task_.tol)) return false;
    const bool cleared = progress_.swept().isClear(progress_.at(), to);
    if (!neighbour && !cleared) return false;
    if (!neighbour) progress_.needOthers();
    progress_.link(to, cleared);
    progress_.cut(joint);
    return true;
}

/// Is the way at depth quicker than up, across and down again?
bool Linker::isShorter(const Joint& joint) const {
    const LinkRates& rates = task_.rates;
    const Vec2& to = joint.at.point;
    const double approach_mm = before_.isClear(to, to) ? rates.deep_approach_mm : rates.approach_mm;
    const double over = (2 * rates.lift_mm + joint.distance_mm) / rates.rapid_mm_per_min +
                        approach_mm / rates.plunge_feed_mm_per_min;
    return joint.distance_mm / rates.feed_mm_per_min <= over;
}

}  // namespace stepmill::toolpath
