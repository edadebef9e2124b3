// Areas of offsets and openings against GEOS' overlay on chords of some nanometres.

#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

#include "stepmill/planar/clearance_diagram.h"
#include "support/diagram_laws.h"
#include "support/geos_oracle.h"

namespace stepmill::test {
namespace {

constexpr double kShare = 1e-6;

class GeosOracle : public DiagramLaws {};

TEST_P(GeosOracle, AgreesOnAreas) {
    forSeeds(10, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        const double chord = 5e-7 * which.size_mm;
        const double d = std::max(which.freeRadius(random), which.size_mm / 200);
        const double slack = kShare * area(which.region) + 2 * kGridMm * perimeter(which.region);
        for (const double distance : {-d, d}) {
            if (ties(diagram, distance)) continue;
            SCOPED_TRACE(fmt::format("offset {:.6f} chord {}", distance, chord));
            EXPECT_NEAR(area(diagram.offset(distance)), geosOffsetArea(which.region, distance, chord), slack);
        }
        const Region centres = diagram.offset(-d);
        if (ties(diagram, -d) || centres.empty()) return;
        SCOPED_TRACE(fmt::format("opening {:.6f} chord {}", d, chord));
        EXPECT_NEAR(area(diagram.opening(d)), geosOffsetArea(centres, d, chord), slack);
    });
}

INSTANTIATE_TEST_SUITE_P(On, GeosOracle, testing::ValuesIn(kRegionKinds), kindName);

}  // namespace
}  // namespace stepmill::test
