// Arcs of real features come through the planar kernel as the arcs they are.

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "stepmill/plan/stages.h"
#include "stepmill/planar/clearance_diagram.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;
constexpr double kOffsetMm = 0.1;

/// Circles by centre, side and radius; an arc cut in two is one circle.
using Circles = std::set<std::tuple<double, double, bool, double>>;

/// The circles of a region's arcs, grown or shrunk as an offset to the inside by `distance_mm` leaves them.
Circles circlesAfter(const Region& region, double distance_mm) {
    Circles circles;
    for (const Loop& loop : region.loops)
        for (const Segment& segment : loop.segments) {
            if (!segment.arc) continue;
            const Arc& arc = *segment.arc;
            const double radius = snapToGrid(arc.radius_mm + (arc.ccw ? -distance_mm : distance_mm));
            if (radius > 0) circles.insert({arc.centre.x(), arc.centre.y(), arc.ccw, radius});
        }
    return circles;
}

TEST(SampleParts, EveryArcOfAFeatureComesOutAsAnArcOfTheSameCircle) {
    int arcs = 0;
    for (const char* name : {"rounded_pocket", "bossed_pocket", "butterfly_pocket", "nested_pockets",
                             "open_slots", "plate_with_holes", "four_setups"}) {
        SCOPED_TRACE(name);
        const Part part = readStep(std::string(STEPMILL_SOURCE_DIR "/step_parts/") + name + ".step").front();
        SetupWalk walk(chooseSetups(part, {}), {}, kTol);
        while (const std::optional<Stage> stage = walk.next()) {
            for (const Feature& feature : stage->found.features) {
                SCOPED_TRACE(feature.id);
                const ClearanceDiagram diagram(feature.target, kTol);
                const Circles in = circlesAfter(feature.target, kOffsetMm);
                const Circles shrunk = circlesAfter(diagram.offset(-kOffsetMm), 0);
                const Circles opened = circlesAfter(diagram.opening(kOffsetMm), kOffsetMm);
                for (const auto& circle : in) {
                    EXPECT_TRUE(shrunk.contains(circle));
                    EXPECT_TRUE(opened.contains(circle));
                }
                arcs += static_cast<int>(in.size());
            }
            walk.cut(*stage, featurePrisms(stage->found));
        }
    }
    EXPECT_GT(arcs, 50);
}

}  // namespace
}  // namespace stepmill
