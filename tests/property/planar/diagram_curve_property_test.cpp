// The accessible area as a function of the radius: falling, and steady but where events say it is not.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/planar/clearance_diagram.h"
#include "support/diagram_laws.h"

namespace stepmill::test {
namespace {

class CurveLaws : public DiagramLaws {};

/// Where in (low, high) the curve falls most steeply, to within `width_mm`.
std::pair<double, double> steepest(const ClearanceDiagram& diagram, double low, double high,
                                   double width_mm) {
    double at_low = diagram.accessibleArea(low);
    double at_high = diagram.accessibleArea(high);
    while (high - low > width_mm) {
        const double middle = (low + high) / 2;
        const double at_middle = diagram.accessibleArea(middle);
        if (at_low - at_middle > at_middle - at_high) {
            high = middle;
            at_high = at_middle;
        } else {
            low = middle;
            at_low = at_middle;
        }
    }
    return {low, high};
}

bool eventNear(const std::vector<ClearanceEvent>& events, double low, double high) {
    return std::any_of(events.begin(), events.end(), [&](const ClearanceEvent& event) {
        return event.radius_mm > low - kTieMm && event.radius_mm < high + kTieMm;
    });
}

TEST_P(CurveLaws, NeverRisesAndEndsAtTheWidestDisc) {
    forSeeds(100, [](const RandomRegion& which, Random&) {
        const ClearanceDiagram diagram(which.region, kTol);
        const double widest = diagram.largestInscribedDisc()->radius_mm;
        const double slack = kRoundingMm * perimeter(which.region);
        EXPECT_NEAR(diagram.accessibleArea(0), area(which.region), slack);
        double last = area(which.region);
        for (int i = 1; i <= 40; ++i) {
            const double r = widest * i / 40;
            const double now = diagram.accessibleArea(r);
            EXPECT_LE(now, last + slack) << r;
            last = now;
        }
        EXPECT_EQ(diagram.accessibleArea(widest + kTieMm), 0);
    });
}

TEST_P(CurveLaws, JumpsOnlyAtEvents) {
    forSeeds(100, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        const std::vector<ClearanceEvent> events = diagram.events();
        const double widest = diagram.largestInscribedDisc()->radius_mm;
        const double whole = area(which.region);
        const double width_mm = kTieMm / 10;
        for (int i = 0; i < 6; ++i) {
            const double from = random.real(0, widest);
            const double to = std::min(widest * 1.01, from + widest / 6);
            const auto [low, high] = steepest(diagram, from, to, width_mm);
            // A disc's radius changes what it reaches in corners by less than ten times the walls' length.
            const double drop = diagram.accessibleArea(low) - diagram.accessibleArea(high);
            if (drop < 1e-4 * whole + 10 * width_mm * perimeter(which.region)) continue;
            EXPECT_TRUE(eventNear(events, low, high))
                << fmt::format("{} mm2 between {:.6f} and {:.6f}", drop, low, high);
        }
    });
}

TEST_P(CurveLaws, BetweenEventsItIsSmooth) {
    forSeeds(100, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        const std::vector<ClearanceEvent> events = diagram.events();
        const double widest = diagram.largestInscribedDisc()->radius_mm;
        const double whole = area(which.region);
        for (int i = 0; i < 10; ++i) {
            const double r = random.real(0.02, 0.98) * widest;
            const double step = widest / 1000;
            // Beyond a neck the curve falls like a root, which calms down slowly; discs on both sides of it
            // go on overlapping until a bend that is not listed.
            if (eventNear(events, std::min(r / 1.06, r - 15 * step), r + 15 * step)) continue;
            // The fourth difference of a smooth function is far smaller than that of a kinked one.
            const double weights[5] = {1, -4, 6, -4, 1};
            double difference = 0;
            for (int k = 0; k < 5; ++k)
                difference += weights[k] * diagram.accessibleArea(r + (k - 2) * step);
            EXPECT_LT(std::abs(difference), 1e-5 * whole + 16 * kRoundingMm * perimeter(which.region))
                << fmt::format("radius {:.6f}", r);
        }
    });
}

TEST_P(CurveLaws, EventsAreDiscsThatTouchTheBoundary) {
    forSeeds(150, [](const RandomRegion& which, Random&) {
        const ClearanceDiagram diagram(which.region, kTol);
        const std::vector<ClearanceEvent> events = diagram.events();
        if (diagram.largestInscribedDisc()->radius_mm < kRoundingMm) return;  // all needles
        ASSERT_FALSE(events.empty()) << "a region has a room at least";
        double last = 0;
        for (const ClearanceEvent& event : events) {
            SCOPED_TRACE(fmt::format("event at {:.6f} {:.6f} radius {:.6f} kind {}", event.at.x(),
                                     event.at.y(), event.radius_mm, static_cast<int>(event.kind)));
            EXPECT_GE(event.radius_mm, last);
            last = event.radius_mm;
            EXPECT_GT(event.radius_mm, 0);
            EXPECT_TRUE(contains(which.region, event.at));
            EXPECT_NEAR(distanceToBoundary(which.region, event.at), event.radius_mm, kRoundingMm);
        }
        EXPECT_NEAR(last, diagram.largestInscribedDisc()->radius_mm, kRoundingMm)
            << "the widest disc is an event";
        EXPECT_TRUE(std::any_of(events.begin(), events.end(), [&](const ClearanceEvent& event) {
            return event.kind == ClearanceEvent::Kind::Room && event.radius_mm > last - kRoundingMm;
        }));
    });
}

INSTANTIATE_TEST_SUITE_P(On, CurveLaws, testing::ValuesIn(kRegionKinds), kindName);

}  // namespace
}  // namespace stepmill::test
