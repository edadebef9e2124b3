#include <gtest/gtest.h>

#include "graph_maker.h"
#include "stepmill/feature/part_form.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::GraphMaker;

using test::kTol;

/// The six sides of a block 10 mm wide come first.
class PartForms : public ::testing::Test {
  protected:
    PartForms() {
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0})
                maker_.plane(Vec3::Constant(sign < 0 ? 0 : 10), sign * Vec3::Unit(axis), true);
    }

    PartForm only() const {
        const std::vector<PartForm> forms = partForms(maker_.graph, maker_.on_stock, kTol);
        EXPECT_EQ(forms.size(), 1U);
        return forms.empty() ? PartForm{} : forms.front();
    }

    // 0 and 1 are left and right.
    static constexpr int kFront = 2, kBack = 3, kBottom = 4, kTop = 5;
    GraphMaker maker_;
};

/// Walls of a prism along z round a centre, each meeting the next.
std::vector<int> ring(GraphMaker& maker, int sides, const Vec3& centre) {
    std::vector<int> walls;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * kPi * i / sides;
        const Vec3 out(std::cos(angle), std::sin(angle), 0);
        walls.push_back(maker.plane(centre + 2 * out, -out));
    }
    for (int i = 0; i < sides; ++i)
        maker.meet(walls[i], walls[(i + 1) % sides], Bend::Concave);
    return walls;
}

TEST_F(PartForms, WallsAllRoundAreAPassageNamedByItsSides) {
    for (const auto& [sides, name] : {std::pair<int, std::string>{3, "triangular_passage"},
                                      {4, "rectangular_passage"},
                                      {6, "6sides_passage"}}) {
        GraphMaker maker = maker_;
        ring(maker, sides, {5, 5, 5});
        const std::vector<PartForm> forms = partForms(maker.graph, maker.on_stock, kTol);
        ASSERT_EQ(forms.size(), 1U);
        EXPECT_EQ(forms[0].form_class, FormClass::Passage);
        EXPECT_EQ(forms[0].sides, sides);
        EXPECT_EQ(mfcadClass(forms[0]), name);
    }
}

TEST_F(PartForms, NoNameFitsAPassageOfFiveSides) {
    ring(maker_, 5, {5, 5, 5});
    EXPECT_EQ(only().form_class, FormClass::Passage);
    EXPECT_EQ(mfcadClass(only()), std::nullopt);
}

TEST_F(PartForms, WallsAllRoundOnAFloorAreAPocket) {
    const std::vector<int> walls = ring(maker_, 6, {5, 5, 5});
    const int floor = maker_.plane({5, 5, 2}, {0, 0, 1});
    for (const int wall : walls)
        maker_.meet(wall, floor, Bend::Concave);
    const PartForm form = only();
    EXPECT_EQ(form.form_class, FormClass::Pocket);
    EXPECT_EQ(form.floor, floor);
    EXPECT_EQ(mfcadClass(form), "6sides_pocket");
}

TEST_F(PartForms, ASideThatAnotherCutSplitsCountsOnce) {
    const std::vector<int> walls = ring(maker_, 4, {5, 5, 5});
    const int other_half = maker_.plane({7, 5, 9}, {-1, 0, 0});
    maker_.meet(other_half, walls[1], Bend::Concave);
    maker_.meet(other_half, walls[3], Bend::Concave);
    EXPECT_EQ(only().faces.size(), 5U);
    EXPECT_EQ(mfcadClass(only()), "rectangular_passage");
}

TEST_F(PartForms, CutsThatCrossInOuterEdgesStayApart) {
    const std::vector<int> walls = ring(maker_, 3, {5, 5, 5});
    const std::vector<int> others = ring(maker_, 4, {8, 8, 5});
    maker_.meet(walls[0], others[0], Bend::Convex);
    EXPECT_EQ(partForms(maker_.graph, maker_.on_stock, kTol).size(), 2U);
}

TEST_F(PartForms, FloorBetweenFacingWallsIsAThroughSlot) {
    const int left = maker_.plane({3, 0, 5}, {1, 0, 0});
    const int right = maker_.plane({6, 0, 5}, {-1, 0, 0});
    const int floor = maker_.plane({5, 5, 4}, {0, 0, 1});
    maker_.inner({{left, floor}, {right, floor}});
    EXPECT_EQ(only().form_class, FormClass::ThroughSlot);
    EXPECT_EQ(only().floor, floor);
    EXPECT_EQ(mfcadClass(only()), "rectangular_through_slot");
}

TEST_F(PartForms, ThreeWallsOnAFloorAreABlindSlot) {
    const int left = maker_.plane({3, 0, 5}, {1, 0, 0});
    const int right = maker_.plane({6, 0, 5}, {-1, 0, 0});
    const int end = maker_.plane({5, 7, 5}, {0, -1, 0});
    const int floor = maker_.plane({5, 5, 4}, {0, 0, 1});
    maker_.inner({{left, floor}, {right, floor}, {end, floor}, {left, end}, {right, end}});
    EXPECT_EQ(only().form_class, FormClass::BlindSlot);
    EXPECT_EQ(mfcadClass(only()), "rectangular_blind_slot");
}

TEST_F(PartForms, TwoSquareFacesAreAThroughStep) {
    const int wall = maker_.plane({5, 3, 5}, {0, -1, 0});
    const int floor = maker_.plane({5, 1, 4}, {0, 0, 1});
    maker_.inner({{wall, floor}});
    EXPECT_EQ(mfcadClass(only()), "rectangular_through_step");
}

TEST_F(PartForms, AStepWithALeaningWallIsSlantedWhenItsFloorRunsOutOnThreeSides) {
    const int wall = maker_.plane({5, 8, 5}, {0, 1, 0.1});
    const int floor = maker_.plane({4, 9, 5}, {1, 0, 0});
    maker_.inner({{wall, floor}});
    for (const int side : {kBack, kTop, kBottom})
        maker_.meet(floor, side, Bend::Convex);
    EXPECT_EQ(mfcadClass(only()), "slanted_through_step");
}

TEST_F(PartForms, AStepAcrossACornerIsBlind) {
    const int wall = maker_.plane({5, 2, 1}, {0, -1, -1});
    const int floor = maker_.plane({1, 0, 0}, {1, 0, 0});
    maker_.inner({{wall, floor}});
    for (const int side : {kFront, kBottom})
        maker_.meet(floor, side, Bend::Convex);
    EXPECT_EQ(mfcadClass(only()), "triangular_blind_step");
}

TEST_F(PartForms, ThreeSquareFacesRoundACornerAreABlindStep) {
    const int a = maker_.plane({0, 2, 5}, {0, -1, 0});
    const int b = maker_.plane({4, 0, 5}, {-1, 0, 0});
    const int floor = maker_.plane({0, 0, 4}, {0, 0, 1});
    maker_.inner({{a, b}, {a, floor}, {b, floor}});
    EXPECT_EQ(mfcadClass(only()), "rectangular_blind_step");
}

TEST_F(PartForms, OneFaceAcrossAnEdgeIsAChamfer) {
    maker_.plane({1, 0, 1}, {-1, 0, 1});
    EXPECT_EQ(only().form_class, FormClass::Chamfer);
    EXPECT_EQ(mfcadClass(only()), "chamfer");
}

TEST_F(PartForms, RoundedCornersDoNotSplitAPocket) {
    const int floor = maker_.plane({5, 5, 2}, {0, 0, 1});
    const std::vector<Vec3> normals{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    std::vector<int> walls;
    for (const Vec3& normal : normals) {
        walls.push_back(maker_.plane(Vec3(5, 5, 5) - 3 * normal, normal));
        maker_.meet(walls.back(), floor, Bend::Concave);
    }
    for (int i = 0; i < 4; ++i) {
        const int corner = maker_.bore({i, i}, 1, 2, 10, kPi / 2);
        maker_.meet(walls[i], corner, Bend::Smooth);
        maker_.meet(walls[(i + 1) % 4], corner, Bend::Smooth);
    }
    const std::vector<PartForm> forms = partForms(maker_.graph, maker_.on_stock, kTol);
    const auto pocket = std::find_if(forms.begin(), forms.end(), [](const PartForm& form) {
        return form.form_class == FormClass::Pocket;
    });
    ASSERT_NE(pocket, forms.end());
    EXPECT_EQ(pocket->sides, 4);
    EXPECT_EQ(forms.size(), 5U) << "and four inner fillets";
}

}  // namespace
}  // namespace stepmill
