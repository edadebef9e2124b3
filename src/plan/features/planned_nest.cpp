#include "plan/features/planned_nest.h"

#include <algorithm>
#include <set>

#include "plan/order/share_tools.h"
#include "stepmill/feature/region_compare.h"

namespace stepmill {
namespace {

double changeWeight(const PlanningShop& shop) {
    return changeWeight(shop.machine, shop.request.sequence.objective);
}

/// Seconds or money of a path without the change to its tool.
double weightOf(const SequenceStep& step, const PlanningShop& shop) {
    const EdgeCost cost = edgeCost(step.path.totals, shop.library.tool(step.tool_id), shop.machine);
    return weightOf(cost, shop.request.sequence.objective) - changeWeight(shop);
}

/// Do tools find the same in both?
bool sameRoom(const Feature& a, const Feature& b) {
    const auto same = [](const Obstacle& one, const Obstacle& other) {
        return one.bottom_z_mm == other.bottom_z_mm && one.top_z_mm == other.top_z_mm &&
               feature::identical(one.section, other.section);
    };
    return a.top_z_mm == b.top_z_mm && a.floor_z_mm == b.floor_z_mm && a.through == b.through &&
           feature::identical(a.target, b.target) && feature::identical(a.obstruction, b.obstruction) &&
           std::equal(a.obstacles.begin(), a.obstacles.end(), b.obstacles.begin(), b.obstacles.end(), same);
}

}  // namespace

void PlannedNest::add(const Feature& feature, SequencedFeature made) {
    features.push_back({feature, std::move(made.sequence)});
    makings.push_back({std::move(made.free), std::move(made.failure), made.hasty});
}

bool PlannedNest::failed() const {
    return std::any_of(makings.begin(), makings.end(),
                       [](const Making& making) { return !making.failure.empty(); });
}

bool PlannedNest::isHasty() const {
    return std::any_of(makings.begin(), makings.end(), [](const Making& making) { return making.hasty; });
}

double PlannedNest::residualMm3() const {
    double sum_mm3 = 0;
    for (const PlannedFeature& planned : features)
        sum_mm3 += residualVolumeMm3(planned.sequence);
    return sum_mm3;
}

const ToolSequence* PlannedNest::sequenceIn(const ReducedFeature& free) const {
    for (std::size_t i = 0; i < features.size(); ++i) {
        const Making& making = makings[i];
        const bool same = features[i].feature.id == free.feature.id && making.failure.empty() &&
                          making.free.blocked.empty() && free.blocked.empty() &&
                          sameRoom(making.free.feature, free.feature);
        if (same) return &features[i].sequence;
    }
    return nullptr;
}

double pathsWeight(const PlannedNest& nest, const PlanningShop& shop) {
    double weight = 0;
    for (const PlannedFeature& planned : nest.features)
        for (const SequenceStep& step : planned.sequence.steps)
            weight += weightOf(step, shop);
    return weight;
}

double weightOf(const PlannedNest& nest, const PlanningShop& shop) {
    const double change = changeWeight(shop);
    std::set<std::string> own;
    std::vector<Precedence> precedences;
    std::vector<std::vector<SequenceChoice>> choices;
    for (const PlannedFeature& planned : nest.features) {
        Precedence precedence;
        precedence.feature_id = planned.feature.id;
        for (const std::string& parent : planned.feature.parents)
            if (own.count(parent) > 0) precedence.parents.push_back(parent);
        own.insert(planned.feature.id);
        precedences.push_back(std::move(precedence));
        choices.push_back(choicesOf(planned.sequence));
    }
    const SharedChoice shared = shareTools(precedences, choices, change, shop.library, 0);
    return pathsWeight(nest, shop) + shared.gain.visits_alone * change - shared.gain.saved;
}

bool isBeyond(const PlannedNest& nest, const NestLimit& limit, const PlanningShop& shop) {
    return nest.residualMm3() > limit.residual_mm3 || pathsWeight(nest, shop) > limit.weight;
}

}  // namespace stepmill
