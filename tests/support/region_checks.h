#pragma once

#include <string>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"
#include "support/random_regions.h"

namespace stepmill::test {

/// Describes a case to GoogleTest while it lives; leaves `<test>_<seed>.svg` in GoogleTest's temporary folder
/// if the test fails in it.
class CaseTrace {
  public:
    explicit CaseTrace(const RandomRegion& which, const std::string& more = {});
    ~CaseTrace();
    CaseTrace(const CaseTrace&) = delete;
    CaseTrace& operator=(const CaseTrace&) = delete;

  private:
    const RandomRegion& which_;
    bool failed_before_;
    struct Scope;
    Scope* scope_;
};

/// Distance to the boundary, negative outside.
double signedClearance(const Region& region, const Vec2& p);

/// From p uphill in clearance until about the medial axis, where offsets have their corners.
Vec2 nearMedialAxis(const Region& region, Vec2 p);

/// A point of the region's box grown by that much: half of them anywhere, half near the medial axis.
Vec2 probePoint(const Region& region, double grown_mm, Random& random);

/// Farthest that points of an offset's edges (ends and between) lie closer to, or farther from, the region's
/// boundary than asked [mm].
struct Deviation {
    double too_close_mm = 0;
    double too_far_mm = 0;
    Vec2 closest_at = Vec2::Zero();
    Vec2 farthest_at = Vec2::Zero();
};
Deviation deviation(const Region& offset, const Region& region, double distance_mm);

/// Is the point swept by discs of that radius with centres in `centres`? Positive if so: by how much [mm].
double sweptBy(const Region& centres, double radius_mm, const Vec2& p);

}  // namespace stepmill::test
