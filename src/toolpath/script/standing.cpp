#include "toolpath/script/standing.h"

#include <algorithm>

namespace stepmill::toolpath {

Standing::Standing(const ClearingTask& task, double radius_mm, const Tolerances& tol)
    : obstruction_{IndexedRegion(task.obstruction), radius_mm + tol.guard_mm / 2} {
    for (const KeptOff& kept : task.kept_off)
        holder_.push_back({IndexedRegion(kept.section), kept.distance_mm});
}

bool Standing::keeps(const Kept& kept, const Vec2& from, const Vec2& to) {
    return !kept.section.isNear(makeLine(from, to), kept.distance_mm);
}

bool Standing::isClear(const Vec2& from, const Vec2& to) const {
    return keeps(obstruction_, from, to);
}

bool Standing::isClearForAll(const Vec2& from, const Vec2& to) const {
    return isClear(from, to) && std::all_of(holder_.begin(), holder_.end(),
                                            [&](const Kept& kept) { return keeps(kept, from, to); });
}

}  // namespace stepmill::toolpath
