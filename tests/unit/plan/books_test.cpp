#include "stepmill/plan/books.h"

#include <gtest/gtest.h>

#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;

/// Two setups from the same side. The first leaves 60 mm3 of 100, of which its form cutters take 30; the
/// second has a feature of 20 mm3 that no tool of its own fits, and no name for the rest.
class BooksWithForms : public testing::Test {
  protected:
    BooksWithForms() {
        first_.setup.id = "S1";
        first_.setup.stock.volume_mm3 = 1000;
        first_.setup.part.volume_mm3 = 900;
        first_.features.emplace_back().feature.volume_mm3 = 40;
        first_.unplanned.push_back({{Reason::FreeForm, {}}, 60, 0, -1, {}});
        first_.operations.emplace_back().takes = {{{Reason::FreeForm, {}}, 30}};
        first_.form.emplace().stairs.push_back({-1, 0, makeRectangle({0, 0}, {10, 10})});
        last_.setup.id = "S2";
        last_.setup.stock.volume_mm3 = 960;
        last_.setup.stock.cuts.emplace_back();
        last_.setup.part.volume_mm3 = 900;
        last_.unplanned.push_back({{Reason::LeftByEarlierSetups, {}}, 40, 0, -1, {}});
    }

    VolumeBalance booksWithResidualAt(const Vec2& corner) {
        PlannedFeature planned;
        planned.feature = makePocket(makeRectangle(corner, corner + Vec2(10, 2)), 1);
        planned.feature.volume_mm3 = 20;
        Residual residual;
        residual.region = planned.feature.target;
        residual.area_mm2 = residual.volume_mm3 = 20;
        residual.reason = {Reason::CornerRadius, {}};
        planned.sequence.residual.push_back(residual);
        last_.features.push_back(planned);
        const LayerStack none;
        return booksOf({{&first_, &none, {"S1", 1000, 40, 40, 960}, {}, {}},
                        {&last_, &none, {"S2", 960, 0, 0, 960}, {}, {}}},
                       100, kTol)
            .part;
    }

    PlannedSetup first_;
    PlannedSetup last_;
};

TEST_F(BooksWithForms, ResidualsInTheStairsAreGoneFirst) {
    const VolumeBalance books = booksWithResidualAt({0, 0});
    EXPECT_DOUBLE_EQ(books.planned_mm3, 70);
    EXPECT_DOUBLE_EQ(books.residual_mm3, 0);
    EXPECT_DOUBLE_EQ(books.unreachable_mm3, 30);
    EXPECT_NEAR(books.gapMm3(), 0, 1e-9);
}

TEST_F(BooksWithForms, ResidualsElsewhereStay) {
    const VolumeBalance books = booksWithResidualAt({50, 0});
    EXPECT_DOUBLE_EQ(books.residual_mm3, 20);
    EXPECT_DOUBLE_EQ(books.unreachable_mm3, 10);
    EXPECT_NEAR(books.gapMm3(), 0, 1e-9);
}

TEST_F(BooksWithForms, MoreThanThereIsDoesNotClose) {
    first_.operations.back().takes.front().volume_mm3 = 61;
    EXPECT_LT(booksWithResidualAt({50, 0}).gapMm3(), -0.5);
}

TEST(LeavesNothing, AsksForResidualsToRoundingAndForTheRestToTolerance) {
    VolumeBalance books;
    books.stock_minus_part_mm3 = 1e5;
    EXPECT_TRUE(leavesNothing(books, false, kTol));
    books.unreachable_by_reason = {{{Reason::FreeForm, {}}, 99}};
    EXPECT_TRUE(leavesNothing(books, false, kTol));
    books.residual_by_reason = {{{Reason::CornerRadius, {}}, 0.5}};
    EXPECT_FALSE(leavesNothing(books, false, kTol));
    books.residual_by_reason = {{{Reason::Allowance, {}}, 0.5}};
    EXPECT_FALSE(leavesNothing(books, false, kTol));
    EXPECT_TRUE(leavesNothing(books, true, kTol));
}

}  // namespace

TEST(Books, OverhangsAreNamedAsTheSetupThatFacesThemNamesThem) {
    PlannedSetup from_above;
    from_above.setup.id = "S1";
    from_above.setup.stock.volume_mm3 = 1000;
    from_above.setup.part.volume_mm3 = 900;
    from_above.features.emplace_back().feature.volume_mm3 = 65;
    from_above.unplanned.push_back({{Reason::EdgeFillet, {}}, 35, 0, -1, {}});
    PlannedSetup from_below;
    from_below.setup.id = "S2";
    from_below.setup.stock.volume_mm3 = 935;
    from_below.setup.stock.cuts.emplace_back();
    from_below.setup.part.volume_mm3 = 900;
    from_below.unplanned.push_back({{Reason::Overhang, {}}, 35, 0, -1, {}});
    const LayerStack none;
    const VolumeBalance books = booksOf({{&from_above, &none, {"S1", 1000, 65, 65, 935}, {}, {}},
                                         {&from_below, &none, {"S2", 935, 0, 0, 935}, {}, {}}},
                                        100, kTol)
                                    .part;
    ASSERT_EQ(books.unreachable_by_reason.size(), 1U);
    EXPECT_EQ(books.unreachable_by_reason.front().reason, (StayReason{Reason::EdgeFillet, {}}));
    EXPECT_DOUBLE_EQ(books.unreachable_mm3, 35);
    EXPECT_NEAR(books.gapMm3(), 0, 1e-9);
}

}  // namespace stepmill::test
