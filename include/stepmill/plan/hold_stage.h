#pragma once

#include <optional>
#include <vector>

#include "stepmill/catalog/fixture.h"
#include "stepmill/plan/stages.h"

namespace stepmill {

/// How the stage is to be held: as the shop's file says of its setup, else as suggestClamping() finds.
/// \param kind  asked for; nothing: the first that will do
Clamping clampingOf(const Stage& stage, const FixtureFile& shop, std::optional<HoldKind> kind,
                    const Tolerances& tol);

/// Holds the stage: its clamping; its fixtures as the file says of its setup, grown, or the vise's jaws and
/// the stock they hold; its features without what is held (withHeldStock()). Fixtures stand beside and on the
/// stock as it is said to be and as large as it may be. \throws Error(Usage) for a fixture that stands in the
/// stock.
void holdStage(Stage& stage, const FixtureFile& shop, std::optional<HoldKind> kind, const Tolerances& tol);

/// Height of the highest over the stock's top; 0 where none stands over it [mm].
double highestFixtureMm(const std::vector<Fixture>& fixtures);

}  // namespace stepmill
