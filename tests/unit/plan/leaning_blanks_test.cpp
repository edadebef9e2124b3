// Blanks from files whose sides are not upright: bars that lie, castings with draft, tubes.

#include <gtest/gtest.h>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepOffsetAPI_DraftAngle.hxx>
#include <gp_Pln.hxx>
#include <TopExp_Explorer.hxx>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/units.h"
#include "stepmill/plan/plan.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

Plan planFrom(const TopoDS_Shape& blank, const TopoDS_Shape& shape) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.setup.stock_part = test::part(blank);
    return planPart(test::part(shape), request, defaultToolLibrary(), defaultMachine(), kTol);
}

/// \param most_left  of what is to be removed, in corners and on walls
void expectClosedBooks(const Plan& plan, double most_left) {
    EXPECT_LT(plan.balance.gapShare(), 0.2 * kTol.volume_share);
    EXPECT_LT(plan.balance.leftMm3(), most_left * plan.balance.stock_minus_part_mm3);
    for (const PlannedSetup& setup : plan.setups)
        EXPECT_LT(std::abs(setup.balance.gapMm3()), kTol.volume_share * plan.balance.stock_minus_part_mm3)
            << setup.setup.id;
}

TopoDS_Shape block() {
    return test::box(0, 0, 0, 80, 60, 20);
}

/// 3 mm larger than the block at its foot, its sides leaning in by some degrees.
TopoDS_Shape drafted(double degrees) {
    const TopoDS_Shape rough = test::box(-3, -3, -2, 86, 66, 24);
    BRepOffsetAPI_DraftAngle draft(rough);
    for (TopExp_Explorer face(rough, TopAbs_FACE); face.More(); face.Next()) {
        const BRepAdaptor_Surface surface(TopoDS::Face(face.Current()));
        if (std::abs(surface.Plane().Axis().Direction().Z()) > 0.5) continue;
        draft.Add(TopoDS::Face(face.Current()), gp::DZ(), degToRad(degrees),
                  gp_Pln(gp_Pnt(0, 0, -2), gp::DZ()));
    }
    draft.Build();
    return draft.Shape();
}

TEST(LeaningBlanks, ABlockComesOutOfARoundBarThatLies) {
    const gp_Ax2 axis(gp_Pnt(-2, 30, 10), gp::DX());
    expectClosedBooks(planFrom(BRepPrimAPI_MakeCylinder(axis, 35, 84).Shape(), block()), 1e-3);
}

TEST(LeaningBlanks, ABlockComesOutOfADraftedCasting) {
    for (const double degrees : {0.5, 2.0, 5.0})
        expectClosedBooks(planFrom(drafted(degrees), block()), 0.02);
}

TEST(LeaningBlanks, BoresMayBeAtSizeAlready) {
    const TopoDS_Shape ring = test::cut(test::cylinder(0, 0, 0, 40, 20), test::cylinder(0, 0, -1, 10, 22));
    const TopoDS_Shape tube = test::cut(test::cylinder(0, 0, 0, 42, 20), test::cylinder(0, 0, -1, 10, 22));
    expectClosedBooks(planFrom(tube, ring), 1e-3);
}

}  // namespace
}  // namespace stepmill
