#include "stepmill/study/quote.h"

#include <cmath>

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

/// A block with one pocket of 50 x 30 mm in its middle.
Part pocketed(double depth_mm, double corner_radius_mm) {
    const double r = corner_radius_mm;
    const double floor_z = 20 - depth_mm;
    TopoDS_Shape block = test::box(0, 0, 0, 80, 60, 20);
    block = test::cut(block, test::box(15 + r, 15, floor_z, 50 - 2 * r, 30, depth_mm));
    block = test::cut(block, test::box(15, 15 + r, floor_z, 50, 30 - 2 * r, depth_mm));
    for (const double x : {15 + r, 65 - r})
        for (const double y : {15 + r, 45 - r})
            block = test::cut(block, test::cylinder(x, y, floor_z, r, depth_mm));
    return test::part(block);
}

PlanRequest request() {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.retract_mm = defaultMachine().safe_height_mm;
    request.setup.axes = {Vec3::UnitZ()};
    return request;
}

Plan planOf(const Part& part, const Machine& machine = defaultMachine()) {
    return planPart(part, request(), defaultToolLibrary(), machine, kTol);
}

Quote quoteOf(const Part& part, const QuoteTerms& terms = {}, const Machine& machine = defaultMachine()) {
    return quotePlan(planOf(part, machine), terms, kTol);
}

TEST(Quote, ALotCostsWhatIsPaidOnceAndItsPieces) {
    QuoteTerms terms;
    terms.quantities = {1, 10, 100};
    const Quote quote = quoteOf(pocketed(10, 4.2), terms);
    ASSERT_EQ(quote.lots.size(), 3U);
    for (const QuotedLot& lot : quote.lots) {
        EXPECT_NEAR(lot.price.low, quote.once + lot.quantity * quote.running.low, 1e-9);
        EXPECT_NEAR(lot.price.high, quote.once + lot.quantity * quote.running.high, 1e-9);
        EXPECT_LT(lot.price.low, lot.price.high) << "the machine's acceleration takes time";
        EXPECT_NEAR(lot.piece_price.high * lot.quantity, lot.price.high, 1e-9);
    }
    EXPECT_GT(quote.lots[0].piece_price.high, quote.lots[1].piece_price.high);
    EXPECT_NEAR(quote.once, (20 + 30) / 60.0 * quote.hourly_rate, 1e-9) << "one clamping, and programming";
    EXPECT_EQ(quote.load_s, 60);
    EXPECT_GT(quote.wear, 0);
}

TEST(Quote, TakesTheMachinesTimesWhereTheTermsSayNone) {
    Machine machine = defaultMachine();
    machine.setup_time_min = 45;
    machine.load_time_s = 90;
    const Quote quote = quoteOf(pocketed(10, 4.2), {}, machine);
    EXPECT_EQ(quote.setup_min, 45);
    EXPECT_EQ(quote.load_s, 90);
    QuoteTerms terms;
    terms.setup_min = 5;
    terms.load_s = 0;
    const Quote said = quoteOf(pocketed(10, 4.2), terms, machine);
    EXPECT_EQ(said.setup_min, 5);
    EXPECT_EQ(said.load_s, 0);
}

TEST(Quote, PaysOffWhereWhatIsPaidOnceIsNoMoreThanThePieces) {
    const Quote quote = quoteOf(pocketed(10, 4.2));
    ASSERT_TRUE(quote.pays_off_at.has_value());
    EXPECT_LE(quote.once, *quote.pays_off_at * quote.running.high);
    EXPECT_GT(quote.once, (*quote.pays_off_at - 1) * quote.running.high);
}

TEST(Quote, WithoutTheMachinesAccelerationTheRangeIsOneNumber) {
    Machine machine = defaultMachine();
    machine.acceleration_mm_per_s2 = 0;
    const Quote quote = quoteOf(pocketed(10, 4.2), {}, machine);
    EXPECT_FALSE(quote.acceleration);
    EXPECT_EQ(quote.machining_s.low, quote.machining_s.high);
}

TEST(Quote, AMachineThatCostsNothingHasNoBreakEven) {
    Machine machine = defaultMachine();
    machine.hourly_rate = 0;
    QuoteTerms terms;
    terms.programming_rate = 0;
    const Quote quote = quoteOf(pocketed(10, 4.2), terms, machine);
    EXPECT_EQ(quote.once, 0);
    EXPECT_NEAR(quote.running.low, quote.wear, 1e-9);
}

/// The change of that kind of the part's one costly feature.
std::optional<CheaperChange> changeOf(const Quote& quote, CheaperChange::Kind kind) {
    for (const CheaperChange& change : quote.costly.front().changes)
        if (change.kind == kind) return change;
    return std::nullopt;
}

/// A tenth of what is saved, and what rounding the changed corner may take.
void expectSaved(const CheaperChange& promised, double seconds) {
    EXPECT_NEAR(promised.saves_s, seconds, 0.1 * seconds + 0.5);
}

TEST(Quote, CornersItAsksForSaveWhatItSays) {
    const Quote quote = quoteOf(pocketed(10, 2.1));
    const auto change = changeOf(quote, CheaperChange::Kind::LargerCorners);
    ASSERT_TRUE(change.has_value());
    EXPECT_LE(change->from_mm, 2.1);
    EXPECT_GT(change->to_mm, 2.1);
    const Plan changed = planOf(pocketed(10, change->to_mm + 0.1));
    expectSaved(*change, quote.machining_s.low - changed.totals.time_s);
    EXPECT_TRUE(changed.complete(kTol));
}

TEST(Quote, ADepthItAsksForSavesWhatItSays) {
    const Quote quote = quoteOf(pocketed(15, 4.2));
    const auto change = changeOf(quote, CheaperChange::Kind::LessDepth);
    ASSERT_TRUE(change.has_value());
    EXPECT_NEAR(change->from_mm, 15, 1e-9);
    const Plan changed = planOf(pocketed(change->to_mm, 4.2));
    expectSaved(*change, quote.machining_s.low - changed.totals.time_s);
}

TEST(Quote, AsksForNothingCheaperWhenTheTimeIsOver) {
    Plan plan = planOf(pocketed(10, 2.1));
    plan.request.patience.end = Deadline::in(-1);
    const Quote quote = quotePlan(plan, {}, kTol);
    EXPECT_TRUE(quote.costly.empty());
    EXPECT_TRUE(quote.complete);
}

TEST(Quote, BreakEvensLieOnTheirSideOfTheValueNow) {
    const Quote quote = quoteOf(pocketed(10, 2.1));
    ASSERT_EQ(quote.costly.size(), 1U);
    ASSERT_EQ(quote.costly.front().break_evens.size(), 2U);
    for (const FeatureBreakEven& found : quote.costly.front().break_evens) {
        EXPECT_LE(found.below.value_or(found.now), found.now);
        EXPECT_GE(found.above.value_or(found.now), found.now);
    }
    EXPECT_TRUE(quote.costly.front().break_evens.front().above.has_value())
        << "one tool is cheapest where a tool change takes long";
}

}  // namespace
}  // namespace stepmill
