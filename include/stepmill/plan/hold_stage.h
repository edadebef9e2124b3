#pragma once

#include <optional>
#include <vector>

#include "stepmill/catalog/fixture.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/plan/stages.h"
#include "stepmill/setup/stock_growth.h"

namespace stepmill {

/// What is asked for of how setups are held that the shop's file does not name.
struct HoldRequest {
    std::optional<HoldKind> kind;  ///< nothing: the first that will do
    double break_edges_mm = 0;     ///< edges that are broken want room above the jaws; 0: they stay sharp
    double growth_mm = 0;          ///< fixtures are planned with larger by so much [fixtureGrowthMm()]
};

/// By how much fixtures are planned with larger, on each side and upwards: the shop's share of the radius of
/// the library's widest cutter, shank or holder [Tripathi2005]. The spindle's nose does not count.
double fixtureGrowthMm(const FixtureFile& shop, const ToolLibrary& library);

/// How the stage is to be held: as the shop's file says of its setup, else as suggestClamping() finds.
Clamping clampingOf(const Stage& stage, const FixtureFile& shop, const HoldRequest& asked,
                    const Tolerances& tol);

/// Holds the stage: its clamping; its fixtures as the file says of its setup, grown, or the vise's jaws and
/// the stock they hold; its features without what is held (withHeldStock()). Fixtures stand beside and on the
/// stock as it is said to be and as large as it may be.
/// \throws Error(Usage) for a fixture that stands in the stock
void holdStage(Stage& stage, const FixtureFile& shop, const HoldRequest& asked, const Tolerances& tol);

/// Height of the highest over the stock's top; 0 where none stands over it [mm].
double highestFixtureMm(const std::vector<Fixture>& fixtures);
/// How far back, towards +Y, the stock, as wide as it may be, and the fixtures reach [mm].
/// \param stock_mm  of the stock as it is said to be
double farthestBackMm(double stock_mm, const StockGrowth& growth, const std::vector<Fixture>& fixtures);

}  // namespace stepmill
