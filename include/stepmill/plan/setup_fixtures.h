#pragma once

#include <vector>

#include "stepmill/catalog/fixture.h"
#include "stepmill/plan/stages.h"

namespace stepmill {

/// The setup's fixtures as the file says, grown, instead of the vise, which stays where the file does not
/// name the setup; all of them where they stand beside and on the stock as it is said to be and as large as
/// it may be. \throws Error(Usage) for a fixture that stands in the stock.
void setFixtures(Stage& stage, const FixtureFile& given, const Tolerances& tol);

/// Height of the highest over the stock's top; 0 where none stands over it [mm].
double highestFixtureMm(const std::vector<Fixture>& fixtures);

}  // namespace stepmill
