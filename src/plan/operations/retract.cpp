#include "plan/operations/retract.h"

#include <algorithm>

#include "stepmill/plan/hold_stage.h"
#include "stepmill/setup/stock_growth.h"

namespace stepmill {

double retractMm(const Setup& setup, double asked_mm, const Machine& machine) {
    const StockGrowth growth = growthOf(setup.stock, setup.part_to_setup);
    const double safe_mm = asked_mm > 0 ? asked_mm : machine.safe_height_mm;
    const double over_stock_mm = std::max(safe_mm, growth.top_mm + machine.top_clearance_mm);
    const double fixture_mm = highestFixtureMm(setup.fixtures);
    return fixture_mm > 0 ? std::max(over_stock_mm, fixture_mm + machine.safe_height_mm) : over_stock_mm;
}

}  // namespace stepmill
