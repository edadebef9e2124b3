#pragma once

#include <vector>

#include "stepmill/planar/indexed_region.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill::toolpath {

/// The material that must stay. It answers whether a way over it is clear.
class Standing {
  public:
    Standing(const ClearingTask& task, double radius_mm, const Tolerances& tol);

    /// Is the straight way clear for the cutter at every height over the floor?
    bool isClear(const Vec2& from, const Vec2& to) const;
    /// And for shank and holder?
    bool isClearForAll(const Vec2& from, const Vec2& to) const;

  private:
    struct Kept {
        IndexedRegion section;
        double distance_mm;
    };
    static bool keeps(const Kept& kept, const Vec2& from, const Vec2& to);

    Kept obstruction_;
    std::vector<Kept> holder_;
};

}  // namespace stepmill::toolpath
