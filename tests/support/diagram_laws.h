#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/clearance_diagram.h"
#include "support/random_regions.h"
#include "support/region_checks.h"
#include "support/tolerances.h"

namespace stepmill::test {

/// How far a point of a ring may lie from where it belongs. A point rounded to the grid lies up to 0.7 nm
/// off; where edges meet at a shallow angle, or are so short that rounding turns their tangents, joints move
/// more: up to the distance within which curves count as one, a tenth of what counts as a gouge.
inline constexpr double kRoundingMm = Tolerances{}.linear_mm;

/// Points closer to the level than this may lie on either side.
inline constexpr double kTieMm = 2 * kRoundingMm;

/// Do necks open or rooms vanish within the tolerance of ties?
inline bool ties(const ClearanceDiagram& diagram, double distance_mm) {
    return diagram.offset(distance_mm - kTieMm).loops.size() !=
           diagram.offset(distance_mm + kTieMm).loops.size();
}

/// Base of the laws that must hold on random regions of every kind.
class DiagramLaws : public testing::TestWithParam<RegionKind> {
  protected:
    /// Two free radii, then one that ties, on average.
    static double radius(const RandomRegion& which, Random& random) {
        return random.below(3) == 0 ? which.tieRadius(random) : which.freeRadius(random);
    }

    /// As above, and as often one at or just beside an event, where necks have closed and corners unfold.
    static double radius(const RandomRegion& which, const ClearanceDiagram& diagram, Random& random) {
        const std::vector<ClearanceEvent> events = diagram.events();
        if (random.below(2) || events.empty()) return radius(which, random);
        const double beside[] = {1, 1, 1 - 1e-4, 1 + 1e-4, 1.003, 1.02};
        const double at =
            events[static_cast<std::size_t>(random.below(static_cast<int>(events.size())))].radius_mm;
        return std::max(kSmallestRadiusMm, snapToGrid(at * beside[random.below(6)]));
    }

    /// Calls law(which, random) for that many regions, until one fails.
    template <typename Law>
    void forSeeds(int count, Law law) {
        for (int seed = 0; seed < count && !HasFailure(); ++seed) {
            const RandomRegion which = randomRegion(GetParam(), static_cast<std::uint64_t>(seed));
            Random random(static_cast<std::uint64_t>(seed) + 77);
            const CaseTrace trace(which);
            try {
                law(which, random);
            } catch (const std::exception& error) {
                ADD_FAILURE() << error.what();
            }
        }
    }
};

inline std::string kindName(const testing::TestParamInfo<RegionKind>& which) {
    return name(which.param);
}

}  // namespace stepmill::test
