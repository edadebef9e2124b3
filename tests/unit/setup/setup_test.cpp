#include <cmath>

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakePrism.hxx>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "support/occt_solids.h"

using namespace stepmill;
using namespace stepmill::test;

TEST(ParseAxis, ReadsNamesAndNumbers) {
    EXPECT_EQ(*parseAxis("+z"), Vec3::UnitZ());
    EXPECT_EQ(*parseAxis("-x"), Vec3(-1, 0, 0));
    EXPECT_EQ(*parseAxis("0,0,-2"), Vec3(0, 0, -1));
    EXPECT_NEAR((*parseAxis("1,1,0") - Vec3(1, 1, 0).normalized()).norm(), 0, 1e-15);
}

TEST(ParseAxis, RefusesWhatIsNoDirection) {
    for (const char* text : {"", "z", "+w", "1,2", "0,0,0", "1e308,1e308,1e308", "0,0,1e300", "1,2,3,4",
                             "a,b,c", "nan,0,0", "1,2,3 "})
        EXPECT_FALSE(parseAxis(text).has_value()) << text;
}

TEST(AxisName, IsShortForBoxDirections) {
    EXPECT_EQ(axisName(Vec3(0, -1, 0)), "-y");
    EXPECT_EQ(axisName(Vec3(0, 3, 4)), "0.0000,0.6000,0.8000");
}

TEST(ChooseSetups, PutsTheOriginOnTheStocksTopLowerLeft) {
    const Part block = part(box(10, 20, 30, 40, 50, 60));
    for (const char* name : {"+z", "-z", "+x", "-x", "+y", "-y"}) {
        const auto setup = setupOf(block, *parseAxis(name));
        Box3 moved;
        for (int corner = 0; corner < 8; ++corner)
            moved.extend(Vec3(setup.part_to_setup *
                              setup.stock.bbox_mm.corner(static_cast<Box3::CornerType>(corner))));
        EXPECT_NEAR(moved.min().x(), 0, 1e-12) << name;
        EXPECT_NEAR(moved.min().y(), 0, 1e-12) << name;
        EXPECT_NEAR(moved.max().z(), 0, 1e-12) << name;
        EXPECT_EQ(setup.part_to_setup.linear().determinant(), 1) << name;
        EXPECT_EQ(Vec3(setup.part_to_setup.linear() * setup.axis), Vec3::UnitZ()) << name;
    }
}

TEST(ChooseSetups, AddsMarginsAsSeenFromTheSpindle) {
    const auto setup = setupOf(part(box(0, 0, 0, 40, 50, 60)), -Vec3::UnitX(), StockMargin{2, 3, 5});
    EXPECT_NEAR(setup.stock.bbox_mm.min().x(), -3, 1e-6);
    EXPECT_NEAR(setup.stock.bbox_mm.max().x(), 45, 1e-6);
    EXPECT_NEAR(setup.stock.bbox_mm.min().y(), -2, 1e-6);
    EXPECT_NEAR(setup.stock_bbox_mm.sizes().z(), 48, 1e-6);
}

TEST(ChooseSetups, AutoTakesTheSideThePocketOpensTo) {
    const Part pocketed = part(cut(box(0, 0, 0, 60, 50, 30), box(20, -1, 10, 20, 31, 10)));
    const auto setups = chooseSetups(pocketed, SetupRequest{});
    ASSERT_EQ(setups.size(), 1u);
    EXPECT_EQ(axisName(setups[0].axis), "-y");
    EXPECT_EQ(setups[0].id, "S1");
}

TEST(ChooseSetups, AutoBreaksTiesInFavourOfTheTop) {
    const Part slotted = part(cut(box(0, 0, 0, 60, 50, 30), cylinder(30, 25, -1, 8, 40)));
    EXPECT_EQ(axisName(chooseSetups(slotted, SetupRequest{})[0].axis), "+z");
}

TEST(ChooseSetups, RefusesStockThatDoesNotHoldThePart) {
    SetupRequest request;
    request.stock_part = part(box(0, 0, 0, 30, 30, 9));
    try {
        chooseSetups(part(box(0, 0, 0, 30, 30, 10)), request);
        FAIL() << "no refusal";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
        EXPECT_NE(std::string(error.what()).find("1.000 mm on the +z side"), std::string::npos)
            << error.what();
    }
}

TEST(ChooseSetups, RefusesStockThatIsHollowWhereThePartIs) {
    SetupRequest request;
    request.stock_part = part(cut(box(0, 0, 0, 30, 30, 10), box(10, 10, 5, 10, 10, 5)));
    try {
        chooseSetups(part(box(0, 0, 0, 30, 30, 10)), request);
        FAIL() << "no refusal";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
    }
}

TEST(ChooseSetups, TakesATiltedAxis) {
    const auto setup = setupOf(part(box(0, 0, 0, 10, 10, 10)), Vec3(0, 1, 1));
    EXPECT_NEAR(setup.stock_bbox_mm.sizes().z(), 10 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(setup.stock_bbox_mm.sizes().x(), 10, 1e-6);
}

namespace {

std::vector<std::string> axesOf(const std::vector<stepmill::Setup>& setups) {
    std::vector<std::string> names;
    for (const stepmill::Setup& setup : setups)
        names.push_back(axisName(setup.axis));
    return names;
}

using Names = std::vector<std::string>;

Part samplePart(const std::string& name) {
    return readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name).front();
}

}  // namespace

TEST(ChooseSetups, TakesOneSetupForWhatOneReaches) {
    for (const char* name : {"rounded_pocket.step", "nested_pockets.step", "open_slots.step",
                             "plate_with_holes.step", "shoulder_block.step", "butterfly_pocket.step"})
        EXPECT_EQ(axesOf(chooseSetups(samplePart(name), {})), Names{"+z"}) << name;
}

TEST(ChooseSetups, TakesFourSetupsMostVolumeFirst) {
    const std::vector<stepmill::Setup> setups = chooseSetups(samplePart("four_setups.step"), {});
    EXPECT_EQ(axesOf(setups).front(), "+z");
    Names sorted = axesOf(setups);
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, (Names{"+x", "+y", "+z", "-z"}));
}

TEST(ChooseSetups, TurnsAShaftWithRoundEndsFromBothOfThem) {
    // Its shoulders end where the journals' facets begin: what is asked there must not lie on the edge.
    for (const double radius_mm : {10.0, 14.0, 15.0, 16.0}) {
        TopoDS_Shape shaft = box(0, 0, 0, 100, 40, 40);
        for (const double from_mm : {-1.0, 70.0}) {
            const gp_Ax2 axis(gp_Pnt(from_mm, 20, 20), gp::DX());
            shaft = cut(shaft, cut(box(from_mm, -1, -1, 31, 42, 42),
                                   BRepPrimAPI_MakeCylinder(axis, radius_mm, 31).Shape()));
        }
        Names axes = axesOf(chooseSetups(part(shaft), {}));
        std::sort(axes.begin(), axes.end());
        EXPECT_EQ(axes, (Names{"+x", "-x"})) << radius_mm;
    }
}

TEST(ChooseSetups, CutsAnOpenSlotAcrossItsSharpCorners) {
    // Along y its walls and floor are upright as well, and the side is larger; but its corners would stay
    // round.
    struct Slot {
        double wide_mm, deep_mm;
    };
    for (const auto& [wide_mm, deep_mm] : {Slot{26, 63}, Slot{12, 30}, Slot{20, 18}}) {
        const Part slotted = part(
            cut(box(0, 0, 0, 80, 60, 70), box(40 - wide_mm / 2, -1, 70 - deep_mm, wide_mm, 62, deep_mm + 1)));
        EXPECT_EQ(axesOf(chooseSetups(slotted, {})), Names{"+z"}) << wide_mm;
    }
}

TEST(OtherSetups, AreOtherSidesAndOrdersThatTakeNoLongerToSetUp) {
    const Part block = samplePart("four_setups.step");
    const std::vector<stepmill::Setup> chosen = chooseSetups(block, {});
    const std::vector<std::vector<stepmill::Setup>> others = otherSetups(block, {}, chosen).further;
    Names turned = axesOf(chosen);
    std::iter_swap(std::find(turned.begin(), turned.end(), "+z"),
                   std::find(turned.begin(), turned.end(), "-z"));
    bool found = false;
    for (const std::vector<stepmill::Setup>& other : others) {
        EXPECT_LE(other.size(), chosen.size());
        EXPECT_NE(axesOf(other), axesOf(chosen));
        EXPECT_EQ(other.front().id, "S1");
        for (const stepmill::Setup& setup : other)
            EXPECT_TRUE(setup.chosen && !setup.indexed);
        found |= axesOf(other) == turned;
    }
    EXPECT_TRUE(found);
}

TEST(OtherSetups, TakeTheOtherSideOfAWindowAndNoneThatMissesAPocket) {
    const auto others = [](const Part& window) {
        const std::vector<stepmill::Setup> chosen = chooseSetups(window, {});
        std::vector<Names> names;
        for (const std::vector<stepmill::Setup>& other : otherSetups(window, {}, chosen).further)
            names.push_back(axesOf(other));
        return names;
    };
    const TopoDS_Shape window = cut(box(0, 0, 0, 60, 50, 10), box(20, 10, -1, 20, 30, 12));
    EXPECT_EQ(others(part(window)), std::vector<Names>{{"-z"}});
    EXPECT_EQ(others(part(cut(window, box(45, 10, 5, 10, 30, 6)))), std::vector<Names>{});
}

TEST(OtherSetups, BeginOnTheSameStock) {
    SetupRequest request;
    request.margin = {2, 1, 10};
    const Part block = part(box(0, 0, 0, 60, 50, 30));
    const std::vector<stepmill::Setup> chosen = chooseSetups(block, request);
    for (const std::vector<stepmill::Setup>& other : otherSetups(block, request, chosen).further)
        EXPECT_EQ(other.front().axis, chosen.front().axis);
}

TEST(WithOneMore, AddsTheFreeSidesOfWhatStaysTheMostVolumeFirst) {
    const Part drilled =
        part(cut(cut(box(0, 0, 0, 60, 50, 30), cylinder(10, 25, -1, 4, 40)), box(20, 20, 10, 41, 10, 10)));
    const std::vector<stepmill::Setup> from_above{setupOf(drilled)};
    const UnreachedPlace in_hole{{10, 25, 5}, Vec3::UnitZ(), 100};
    const UnreachedPlace in_slot{{50, 25, 15}, Vec3::UnitZ(), 200};
    const std::vector<AddedSetup> sets = withOneMore(drilled, {}, from_above, {in_hole, in_slot});
    ASSERT_EQ(sets.size(), 2U);
    for (const AddedSetup& added : sets) {
        ASSERT_EQ(added.setups.size(), 2U);
        EXPECT_EQ(added.setups.front().axis, Vec3::UnitZ());
        EXPECT_EQ(added.setups.back().id, "S2");
    }
    EXPECT_EQ(sets[0].setups.back().axis, Vec3::UnitX());
    EXPECT_EQ(sets[0].free_mm3, 200);
    EXPECT_EQ(sets[1].setups.back().axis, -Vec3::UnitZ());
    EXPECT_EQ(sets[1].free_mm3, 100);
    SetupRequest no_x;
    no_x.forbidden = {Vec3::UnitX()};
    EXPECT_EQ(withOneMore(drilled, no_x, from_above, {in_hole, in_slot}).size(), 1U);
    EXPECT_TRUE(withOneMore(drilled, {}, from_above, {}).empty());
    // From below it is as far.
    EXPECT_TRUE(withOneMore(drilled, {}, from_above, {{{10, 25, 15}, Vec3::UnitZ(), 100}}).empty());
}

TEST(ChooseSetups, IndexesToATiltedHoleLast) {
    const gp_Ax2 tilted(gp_Pnt(15, 25, 32), gp_Dir(1, 0, -1));
    const TopoDS_Shape pocket = box(30, 10, 20, 20, 30, 11);
    const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(tilted, 4, 14).Shape();
    const std::vector<stepmill::Setup> setups =
        chooseSetups(part(cut(cut(box(0, 0, 0, 60, 50, 30), pocket), hole)), {});
    ASSERT_EQ(axesOf(setups), (Names{"+z", "-0.7071,0.0000,0.7071"}));
    EXPECT_FALSE(setups[0].indexed);
    EXPECT_TRUE(setups[1].indexed);
}

TEST(ChooseSetups, KeepsToTheAxesAndOrderAskedFor) {
    SetupRequest request;
    request.axes = {-Vec3::UnitZ(), Vec3::UnitX()};
    const std::vector<stepmill::Setup> setups = chooseSetups(samplePart("rounded_pocket.step"), request);
    EXPECT_EQ(axesOf(setups), (Names{"-z", "+x"}));
    EXPECT_FALSE(setups[0].chosen);
}

TEST(ChooseSetups, NeverTakesAForbiddenAxis) {
    // A through window can be cut from above and from below.
    const Part window = part(cut(box(0, 0, 0, 60, 50, 10), box(20, 10, -1, 20, 30, 12)));
    SetupRequest request;
    request.forbidden = {Vec3::UnitZ()};
    EXPECT_EQ(axesOf(chooseSetups(window, request)), Names{"-z"});
}

TEST(ChooseSetups, RefusesWhenEveryAxisIsForbidden) {
    SetupRequest request;
    for (const char* name : {"+z", "-z", "+x", "-x", "+y", "-y"})
        request.forbidden.push_back(*parseAxis(name));
    EXPECT_THROW(chooseSetups(part(box(0, 0, 0, 10, 10, 10)), request), Error);
}

TEST(ChooseSetups, MachinesAllRoundAStockWithMargins) {
    SetupRequest request;
    request.margin = {2, 2, 2};
    const std::vector<stepmill::Setup> setups = chooseSetups(part(box(0, 0, 0, 60, 50, 30)), request);
    EXPECT_EQ(axesOf(setups), (Names{"+z", "-z"}));
}

TEST(ChooseSetups, GivesTheTopMarginToTheFirstSetup) {
    SetupRequest request;
    request.margin = {2, 1, 10};  // there is more to cut from below
    const Part block = part(box(0, 0, 0, 60, 50, 30));
    const std::vector<stepmill::Setup> setups = chooseSetups(block, request);
    ASSERT_EQ(setups.size(), 2U);
    const auto& to_setup = setups.front().part_to_setup;
    const double top_mm = std::max((to_setup * Vec3(30, 25, 0)).z(), (to_setup * Vec3(30, 25, 30)).z());
    EXPECT_NEAR(top_mm, -1, 1e-6);
}

/// A regular prism, its first side square to x.
static Part prismOf(int sides) {
    BRepBuilderAPI_MakePolygon outline;
    for (int i = 0; i < sides; ++i) {
        const double angle_rad = (2 * i + 1) * kPi / sides;
        outline.Add(gp_Pnt(50 * std::cos(angle_rad), 50 * std::sin(angle_rad), 0));
    }
    outline.Close();
    return part(
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 20)).Shape());
}

TEST(AxesNotWeighed, AreThoseOfSmallerFacesThanThereIsRoomFor) {
    EXPECT_EQ(axesNotWeighed(prismOf(26)), 0U);
    EXPECT_EQ(axesNotWeighed(prismOf(40)), 10U);  // four are along x and y
}
