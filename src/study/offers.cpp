#include "stepmill/study/offers.h"

#include <map>

#include "stepmill/core/parallel.h"
#include "stepmill/plan/deep_bands.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/plan/usable_library.h"
#include "stepmill/sequence/advice/purchase.h"

namespace stepmill {
namespace {

/// The plan's features as their tools found them: on the grown stock.
std::vector<Feature> sequencedFeatures(const Plan& plan, const Tolerances& tol) {
    std::vector<Feature> features;
    for (const PlannedSetup& planned : plan.setups) {
        const StockGrowth growth = growthOf(planned.setup.stock, planned.setup.part_to_setup);
        for (const PlannedFeature& feature : planned.features)
            features.push_back(onGrownStock(feature.feature, growth, tol));
    }
    return features;
}

void add(const Purchase& purchase, OfferWorth& to) {
    to.tool_id = purchase.tool.id;
    to.diameter_mm = purchase.tool.diameter_mm;
    to.price = purchase.tool.price;
    ++to.features;
    to.saves_s += purchase.saved_s;
    to.saves_cost += purchase.saved_cost;
    to.more_mm3 += purchase.more_mm3;
}

}  // namespace

std::vector<OfferWorth> worthOfOffers(const Plan& plan, const ToolLibrary& offers, const Tolerances& tol) {
    const SequenceOptions options = asPlanned(plan.request.sequence);
    const std::vector<ToolAssembly> tools =
        usableLibrary(offers, options, plan.machine, plan.part.bbox_mm.sizes().maxCoeff()).library.tools;
    const std::vector<Feature> features = sequencedFeatures(plan, tol);
    std::vector<std::vector<Purchase>> found(features.size());
    parallelFor(features.size(), [&](std::size_t i) {
        found[i] = purchasesFrom(tools, features[i], plan.library, plan.machine, options, tol);
    });
    std::map<std::string, OfferWorth> worth;
    for (const std::vector<Purchase>& purchases : found)
        for (const Purchase& purchase : purchases)
            add(purchase, worth[purchase.tool.id]);
    std::vector<OfferWorth> offered;
    for (auto& [id, offer] : worth)
        offered.push_back(std::move(offer));
    return offered;
}

}  // namespace stepmill
