#include <gtest/gtest.h>
#include <BRep_Tool.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "stepmill/core/units.h"
#include "support/occt_solids.h"

using namespace stepmill;
using namespace stepmill::test;

namespace {

/// A block of 100 x 80 x 30 with a pocket of 50 x 40 x 12 in its top.
TopoDS_Shape pocketBlock() {
    return cut(box(0, 0, 0, 100, 80, 30), box(20, 10, 18, 50, 40, 12));
}

/// The pocket's edges at that height of the part, each once.
std::vector<TopoDS_Edge> pocketEdgesAt(const TopoDS_Shape& shape, double z) {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    const auto on_pocket = [&](const gp_Pnt& p) {
        return p.X() > 19 && p.X() < 71 && p.Y() > 9 && p.Y() < 51 && std::abs(p.Z() - z) < 1e-6;
    };
    std::vector<TopoDS_Edge> found;
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge edge = TopoDS::Edge(edges(i));
        double first = 0;
        double last = 0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        if (on_pocket(curve->Value(first)) && on_pocket(curve->Value(last))) found.push_back(edge);
    }
    return found;
}

int count(const LayerStack& stack, FaceStand stand) {
    return static_cast<int>(std::count_if(stack.traces.begin(), stack.traces.end(),
                                          [&](const FaceTrace& trace) { return trace.stand == stand; }));
}

int count(const LayerStack& stack, SlopeCause cause) {
    return static_cast<int>(std::count_if(stack.traces.begin(), stack.traces.end(),
                                          [&](const FaceTrace& trace) { return trace.cause == cause; }));
}

double hiddenBy(const LayerStack& stack, SlopeCause cause) {
    double volume = 0;
    for (const Layer& layer : stack.layers)
        for (const HiddenVolume& hidden : layer.hidden)
            if (hidden.cause == cause) volume += hidden.volume_mm3;
    return volume;
}

void expectHiddenAddsUp(const LayerStack& stack) {
    for (const Layer& layer : stack.layers) {
        double sum = 0;
        for (const HiddenVolume& hidden : layer.hidden)
            sum += hidden.volume_mm3;
        EXPECT_NEAR(sum, layer.sloped_volume_mm3, 1e-9 * (1 + sum)) << layer.bottom_z_mm;
    }
}

}  // namespace

TEST(FaceTraces, PocketBlockHasFloorsWallsAndTheirFootprints) {
    const LayerStack stack = sliced(pocketBlock());
    ASSERT_EQ(stack.traces.size(), 11u);
    EXPECT_EQ(count(stack, FaceStand::Floor), 2);
    EXPECT_EQ(count(stack, FaceStand::Ceiling), 1);
    EXPECT_EQ(count(stack, FaceStand::Wall), 8);
    for (const FaceTrace& trace : stack.traces) {
        EXPECT_FALSE(trace.cause.has_value());
        if (trace.stand == FaceStand::Wall) {
            ASSERT_EQ(trace.footprint.segments.size(), 1u);
            // Material on the left: a micrometre beside the middle.
            const Vec2 middle = pointAt(trace.footprint.start, trace.footprint.segments[0], 0.5);
            const Vec2 along = tangentAt(trace.footprint.start, trace.footprint.segments[0], 0.5);
            const Region& part = stack.layers[trace.bottom_z_mm < -20 ? 1 : 0].part;
            EXPECT_TRUE(contains(part, middle + 1e-3 * leftOf(along)));
            EXPECT_FALSE(contains(part, middle - 1e-3 * leftOf(along)));
        }
        if (trace.stand == FaceStand::Ceiling) {
            EXPECT_NEAR(area(trace.region), 8000, 1e-6);
        }
        if (trace.stand == FaceStand::Floor) {
            EXPECT_NEAR(area(trace.region), trace.top_z_mm > -1 ? 6000 : 2000, 1e-6);
        }
    }
}

TEST(FaceTraces, NeighboursKnowInnerFromOuterEdges) {
    const LayerStack stack = sliced(pocketBlock());
    for (const FaceTrace& trace : stack.traces) {
        if (trace.stand != FaceStand::Floor) continue;
        const bool pocket_floor = trace.top_z_mm < -1;
        EXPECT_EQ(trace.neighbours.size(), pocket_floor ? 4u : 8u);
        for (const FaceNeighbour& neighbour : trace.neighbours)
            EXPECT_EQ(neighbour.bend, pocket_floor ? Bend::Concave : Bend::Convex);
    }
}

TEST(FaceTraces, StackNamesTheFacesOfAPocket) {
    const LayerStack stack = sliced(pocketBlock());
    const Region pocket = makeRectangle(Vec2(20, 10), Vec2(70, 50));
    const std::vector<int> walls = stack.wallsAlong(pocket.loops[0], 0, -12, 1e-3);
    ASSERT_EQ(walls.size(), 4u);
    for (const int wall : walls)
        EXPECT_NEAR(stack.traces[wall].bottom_z_mm, -12, 1e-9);
    EXPECT_TRUE(stack.wallsAlong(pocket.loops[0], -12, -30, 1e-3).empty());
    const std::vector<int> floors = stack.floorsUnder(pocket, -12, 1e-3, Tolerances{});
    ASSERT_EQ(floors.size(), 1u);
    EXPECT_NEAR(stack.traces[floors[0]].top_z_mm, -12, 1e-9);
    EXPECT_TRUE(stack.floorsUnder(pocket, -13, 1e-3, Tolerances{}).empty());
}

TEST(FaceTraces, RoundHoleIsAHollowCylinderWithAWholeCircle) {
    const LayerStack stack = sliced(cut(box(0, 0, 0, 40, 30, 10), cylinder(15, 12, -1, 4.25, 20)));
    const auto hole = std::find_if(stack.traces.begin(), stack.traces.end(), [](const FaceTrace& trace) {
        return trace.surface == SurfaceKind::Cylinder;
    });
    ASSERT_NE(hole, stack.traces.end());
    EXPECT_TRUE(hole->hollow);
    EXPECT_EQ(hole->stand, FaceStand::Wall);
    EXPECT_NEAR(hole->radius_mm, 4.25, 1e-9);
    ASSERT_TRUE(hole->axis_point.has_value());
    EXPECT_EQ(*hole->axis_point, Vec2(15, 12));
    ASSERT_TRUE(hole->footprint.closed());
    EXPECT_NEAR(signedArea(hole->footprint), -kPi * 4.25 * 4.25, 1e-6);
}

TEST(SlopeCauses, DraftedWallIsNotVertical) {
    const TopoDS_Shape frustum = BRepPrimAPI_MakeWedge(60, 20, 60, 3, 3, 57, 57).Shape();
    const LayerStack stack = sliced(frustum, Vec3::UnitY());
    EXPECT_EQ(count(stack, SlopeCause::Draft), 4);
    expectHiddenAddsUp(stack);
    EXPECT_GT(hiddenBy(stack, SlopeCause::Draft), 0);
}

TEST(SlopeCauses, FilletsChamfersAndDrillPointsAreToldApart) {
    TopoDS_Shape shape = pocketBlock();
    BRepFilletAPI_MakeFillet fillet(shape);
    for (const TopoDS_Edge& edge : pocketEdgesAt(shape, 18))
        fillet.Add(2, edge);
    shape = fillet.Shape();
    BRepFilletAPI_MakeChamfer chamfer(shape);
    for (const TopoDS_Edge& edge : pocketEdgesAt(shape, 30))
        chamfer.Add(1, edge);
    shape = cut(chamfer.Shape(), cylinder(85, 40, 15, 4, 20));
    shape = cut(shape, BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(85, 40, 12.6), gp::DZ()), 0, 4, 2.4).Shape());
    shape = cut(shape, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-1, 65, 15), gp::DX()), 3, 30).Shape());
    const LayerStack stack = sliced(shape);
    EXPECT_GE(count(stack, SlopeCause::FloorFillet), 4);
    EXPECT_EQ(count(stack, SlopeCause::Chamfer), 4);
    EXPECT_EQ(count(stack, SlopeCause::DrillPoint), 1);
    EXPECT_EQ(count(stack, SlopeCause::AcrossAxis), 1);
    EXPECT_EQ(count(stack, SlopeCause::FreeForm), 0);
    expectHiddenAddsUp(stack);
    // A chamfer of 1 mm on 180 mm of edge, outside of which half a square millimetre is removed.
    EXPECT_NEAR(hiddenBy(stack, SlopeCause::Chamfer), 0.5 * 180, 6);
    EXPECT_NEAR(hiddenBy(stack, SlopeCause::DrillPoint), kPi * 16 * 2.4 / 3, 3);
    EXPECT_NEAR(hiddenBy(stack, SlopeCause::AcrossAxis), kPi * 9 * 29, 10);
    // Seen from above the cross hole is no reason for a level.
    for (const Layer& layer : stack.layers) {
        EXPECT_GT(std::abs(layer.bottom_z_mm + 12 + 6), 1e-3);
    }
}

TEST(SlopeCauses, ADrillPointIsOneWhereverItsConeIsToldFrom) {
    // At the apex derivatives vanish but for rounding, which must not say where the cone looks.
    for (const double z : {12.0, 12.3, 11.7}) {
        const gp_Ax2 down(gp_Pnt(15, 15, z), gp_Dir(0, 0, -1));
        const TopoDS_Shape point = BRepPrimAPI_MakeCone(down, 2.5, 0, 2.5 / std::tan(degToRad(59))).Shape();
        const TopoDS_Shape drilled = cut(cut(box(0, 0, 0, 30, 30, 30), cylinder(15, 15, z, 2.5, 30)), point);
        const LayerStack stack = sliced(drilled);
        EXPECT_EQ(count(stack, SlopeCause::DrillPoint), 1) << z;
        EXPECT_EQ(count(stack, SlopeCause::FreeForm), 0) << z;
    }
}

TEST(SlopeCauses, RoundedTopEdgeIsAnEdgeFillet) {
    TopoDS_Shape shape = box(0, 0, 0, 40, 30, 20);
    BRepFilletAPI_MakeFillet fillet(shape);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        double first = 0;
        double last = 0;
        const TopoDS_Edge edge = TopoDS::Edge(edges(i));
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        if (curve->Value(first).Z() > 19 && curve->Value(last).Z() > 19) fillet.Add(3, edge);
    }
    const LayerStack stack = sliced(fillet.Shape());
    EXPECT_GE(count(stack, SlopeCause::EdgeFillet), 4);
    EXPECT_EQ(count(stack, SlopeCause::FreeForm), 0);
    expectHiddenAddsUp(stack);
}
