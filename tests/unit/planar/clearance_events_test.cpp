// Events, medial axis, widest disc and distances on shapes one can work out by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/core/units.h"
#include "stepmill/planar/clearance_diagram.h"
#include "support/tolerances.h"
#include "unit/planar/clearance_shapes.h"

namespace stepmill {
namespace {

using test::addHole;
using Kind = ClearanceEvent::Kind;

using test::kTol;

std::string text(const std::vector<ClearanceEvent>& events) {
    std::string result;
    for (const ClearanceEvent& e : events)
        result += fmt::format("kind {} radius {:.9f} at {:.6f} {:.6f}\n", static_cast<int>(e.kind),
                              e.radius_mm, e.at.x(), e.at.y());
    return result;
}

std::vector<ClearanceEvent> ofKind(const std::vector<ClearanceEvent>& events, Kind kind) {
    std::vector<ClearanceEvent> result;
    std::copy_if(events.begin(), events.end(), std::back_inserter(result),
                 [&](const ClearanceEvent& event) { return event.kind == kind; });
    return result;
}

bool has(const std::vector<ClearanceEvent>& events, const ClearanceEvent& wanted) {
    return std::any_of(events.begin(), events.end(), [&](const ClearanceEvent& e) {
        return e.kind == wanted.kind && std::abs(e.radius_mm - wanted.radius_mm) < 1e-9 &&
               (e.at - wanted.at).norm() < 1e-5;
    });
}

TEST(ClearanceEvents, OfAPocketWithIslandAreCornersNecksAndRooms) {
    const auto events = ClearanceDiagram(test::pocketWithIsland(), kTol).events();
    SCOPED_TRACE(text(events));
    EXPECT_EQ(ofKind(events, Kind::CornerRadius).size(), 4u);
    EXPECT_EQ(ofKind(events, Kind::Neck).size(), 4u);
    EXPECT_EQ(ofKind(events, Kind::Room).size(), 4u);
    // The widest discs touch two walls and the island: (35 - r)^2 + (25 - r)^2 = (8 + r)^2.
    const double r = 68 - std::sqrt(68.0 * 68 - 1786);
    for (const double x : {-1.0, 1.0}) {
        EXPECT_TRUE(has(events, {Kind::Neck, 8.5, {0, x * 16.5}}));
        EXPECT_TRUE(has(events, {Kind::Neck, 13.5, {x * 21.5, 0}}));
        for (const double y : {-1.0, 1.0}) {
            EXPECT_TRUE(has(events, {Kind::CornerRadius, 6, {x * 29, y * 19}}));
            EXPECT_TRUE(has(events, {Kind::Room, r, {x * (35 - r), y * (25 - r)}}));
        }
    }
}

TEST(ClearanceEvents, OfADogBoneAreItsNeckAndItsRooms) {
    const auto events = ClearanceDiagram(test::dogBone(), kTol).events();
    SCOPED_TRACE(text(events));
    EXPECT_FALSE(ofKind(events, Kind::Neck).empty());
    for (const ClearanceEvent& neck : ofKind(events, Kind::Neck)) {
        EXPECT_NEAR(neck.radius_mm, 3, 1e-9);
        EXPECT_NEAR(neck.at.y(), 0, 1e-6);
        EXPECT_TRUE(neck.at.x() > 20 - 1e-6 && neck.at.x() < 30 + 1e-6);
    }
    EXPECT_EQ(ofKind(events, Kind::Room).size(), 2u);
    // Towards the neck the widest disc can move a little.
    const double slide = 10 - std::sqrt(100.0 - 9);
    for (const ClearanceEvent& room : ofKind(events, Kind::Room)) {
        EXPECT_NEAR(room.radius_mm, 10, 1e-9);
        EXPECT_NEAR(room.at.y(), 0, 1e-6);
        EXPECT_LT(std::abs(std::abs(room.at.x() - 25) - 15 + slide / 2), slide / 2 + 1e-6);
    }
}

TEST(ClearanceEvents, OfAnEccentricRingAreItsTwoSides) {
    const auto events = ClearanceDiagram(test::eccentricRing(), kTol).events();
    SCOPED_TRACE(text(events));
    EXPECT_TRUE(has(events, {Kind::Neck, 1, {16, 0}}));
    EXPECT_TRUE(has(events, {Kind::Room, 5, {-12, 0}}));
}

TEST(ClearanceEvents, AreSortedByRadius) {
    for (const Region& region :
         {test::pocketWithIsland(), test::dogBone(), test::cross(), test::eccentricRing()}) {
        const auto events = ClearanceDiagram(region, kTol).events();
        EXPECT_TRUE(std::is_sorted(events.begin(), events.end(),
                                   [](const auto& a, const auto& b) { return a.radius_mm < b.radius_mm; }));
    }
}

TEST(ClearanceEvents, TheCurveBendsAtACornerRadius) {
    const ClearanceDiagram diagram(test::pocketWithIsland(), kTol);
    const auto slope = [&](double r) {
        return (diagram.accessibleArea(r + 0.01) - diagram.accessibleArea(r)) / 0.01;
    };
    EXPECT_NEAR(slope(5.9), 0, 1e-6);
    EXPECT_NEAR(slope(6.0), -(4 - kPi) * 12, 0.1);
}

TEST(ClearanceEvents, TheCurveJumpsWhereARoomEnds) {
    const ClearanceDiagram diagram(test::dogBone(), kTol);
    const double before = diagram.accessibleArea(9.999);
    EXPECT_GT(before, 2 * kPi * 99);
    EXPECT_EQ(diagram.accessibleArea(10.001), 0);
    const double above_neck = diagram.accessibleArea(3.001);
    EXPECT_GT(diagram.accessibleArea(2.999) - above_neck, 25) << "the straight neck goes all at once";
}

TEST(MedialAxis, OfARectangleIsItsRoof) {
    const MedialAxis axis = ClearanceDiagram(makeRectangle({0, 0}, {20, 10}), kTol).medialAxis();
    const auto hasNode = [&](const Vec2& at, double clearance) {
        return std::any_of(axis.nodes.begin(), axis.nodes.end(), [&](const MedialAxis::Node& node) {
            return (node.point - at).norm() < 1e-6 && std::abs(node.clearance_mm - clearance) < 1e-9;
        });
    };
    EXPECT_TRUE(hasNode({5, 5}, 5));
    EXPECT_TRUE(hasNode({15, 5}, 5));
    for (const Vec2& corner : {Vec2(0, 0), Vec2(20, 0), Vec2(20, 10), Vec2(0, 10)})
        EXPECT_TRUE(hasNode(corner, 0));
    EXPECT_EQ(axis.edges.size() + 1, axis.nodes.size());
}

TEST(MedialAxis, OfADiscIsItsCentre) {
    const MedialAxis axis = ClearanceDiagram(makeCircle({3, -2}, 7), kTol).medialAxis();
    ASSERT_FALSE(axis.nodes.empty());
    for (const MedialAxis::Node& node : axis.nodes) {
        EXPECT_LT((node.point - Vec2(3, -2)).norm(), 1e-6);
        EXPECT_NEAR(node.clearance_mm, 7, 1e-9);
    }
}

TEST(MedialAxis, OfARingIsACycle) {
    for (const double shift : {0.0, 0.5}) {
        Region ring = makeCircle({shift, 0}, 5);
        addHole(ring, makeCircle({0, 0}, 2));
        const MedialAxis axis = ClearanceDiagram(ring, kTol).medialAxis();
        EXPECT_FALSE(axis.edges.empty());
        EXPECT_EQ(axis.edges.size(), axis.nodes.size()) << shift;
    }
}

TEST(MedialAxis, OfNothingIsEmpty) {
    const ClearanceDiagram diagram(Region{}, kTol);
    EXPECT_TRUE(diagram.medialAxis().nodes.empty());
    EXPECT_TRUE(diagram.events().empty());
    EXPECT_EQ(diagram.accessibleArea(1), 0);
    EXPECT_TRUE(diagram.restCentres(2, 1).empty());
    EXPECT_TRUE(std::isinf(diagram.distanceToBoundary({0, 0})));
}

TEST(WidestDisc, TouchesThreePlaces) {
    const auto disc = ClearanceDiagram(makePolygon({{0, 0}, {4, 0}, {0, 3}}), kTol).largestInscribedDisc();
    ASSERT_TRUE(disc);
    EXPECT_NEAR(disc->radius_mm, 1, 1e-9);
    EXPECT_LT((disc->centre - Vec2(1, 1)).norm(), 1e-6);
}

TEST(Distance, IsTheOneToTheNearestEdgeInsideAndOutside) {
    const ClearanceDiagram diagram(test::pocketWithIsland(), kTol);
    EXPECT_NEAR(diagram.distanceToBoundary({0, 0}), 8, 1e-9);
    EXPECT_NEAR(diagram.distanceToBoundary({0, 10}), 2, 1e-9);
    EXPECT_NEAR(diagram.distanceToBoundary({0, 20}), 5, 1e-9);
    EXPECT_NEAR(diagram.distanceToBoundary({40, 30}), std::hypot(11, 11) - 6, 1e-9);
    EXPECT_NEAR(diagram.distanceToBoundary({35, 0}), 0, 1e-9);
    EXPECT_NEAR(diagram.distanceToBoundary({1000, 25}), std::hypot(971, 6) - 6, 1e-9);
}

}  // namespace
}  // namespace stepmill
