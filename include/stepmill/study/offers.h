#pragma once

#include <string>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// What a tool that can be bought is worth to one piece of a part.
struct OfferWorth {
    std::string tool_id;
    double diameter_mm = 0;
    double price = 0;
    int features = 0;       ///< that it helps
    double saves_s = 0;     ///< of their time; negative where it machines more than the library does
    double saves_cost = 0;  ///< of their cost, its own wear counted
    double more_mm3 = 0;    ///< volume it machines that stays without it
};

/// What each offered tool alone, beside the plan's library, would save over all features of the plan: those
/// that help none are left out; by id. Features count one by one: changes they share are not merged.
/// Offers stand in the plan's machine; those that have no cutting data for its material help nobody.
/// \note  Costs up to kPurchaseTrials times what sequencing the features did.
std::vector<OfferWorth> worthOfOffers(const Plan& plan, const ToolLibrary& offers, const Tolerances& tol);

}  // namespace stepmill
