#include "plan/assignment/propose_reserve.h"

#include <algorithm>
#include <exception>
#include <map>
#include <set>
#include <tuple>

#include "plan/assignment/best_closure.h"
#include "plan/assignment/shared_cells.h"
#include "plan/operations/retract.h"
#include "stepmill/core/parallel.h"
#include "stepmill/plan/deep_bands.h"
#include "stepmill/plan/stages.h"

namespace stepmill {
namespace {

/// Bands that are less of all that is to be removed are not worth a look.
constexpr double kLeastBandShare = 2e-3;
/// A later band that leaves more than this share of its volume does not take the place of one that may not.
constexpr double kMostLeftShare = 0.01;

/// Weights of cells are shares by volume, and what is left makes other features: a cell must promise to take
/// a fifth less in the later setup.
constexpr double kLateMargin = 1.25;

/// Of the sequence's paths, without tool changes [s].
double pathSeconds(const ToolSequence& sequence, const Machine& machine) {
    int changes = 0;
    for (std::size_t i = 0; i < sequence.steps.size(); ++i)
        changes += i == 0 || sequence.steps[i].tool_id != sequence.steps[i - 1].tool_id ? 1 : 0;
    return sequence.motion_s - changes * machine.tool_change_s;
}

bool isDrilled(const ToolSequence& sequence) {
    return std::any_of(sequence.steps.begin(), sequence.steps.end(),
                       [](const SequenceStep& step) { return step.role == Role::Drill; });
}

/// The later setups, as they would find the stock if it came to them as it arrives at an earlier one.
std::vector<LateBand> lateBands(const Stock& arrives, const std::vector<Setup>& setups,
                                const std::vector<std::size_t>& later, const PlanningShop& shop) {
    std::vector<Setup> walked;
    for (const std::size_t place : later)
        walked.push_back(setups[place]);
    walked.front() = onStock(walked.front(), arrives);
    SetupWalk walk(std::move(walked), shop.request.slicing, shop.tol);
    std::vector<LateBand> bands;
    while (const std::optional<Stage> stage = walk.next()) {
        shop.request.patience.all_tools.check(stage->setup.id);
        const double least_mm3 = kLeastBandShare * stage->setup.removable_mm3;
        for (Feature& band : inBands(stage->found.features, shop.library, shop.request.sequence.material))
            if (band.volume_mm3 >= least_mm3)
                bands.push_back({later[stage->place], stage->setup.part_to_setup, std::move(band), 0});
        walk.cut(*stage, featurePrisms(stage->found));
    }
    return bands;
}

/// Whether tools clear the band, and its weight.
bool weigh(LateBand& band, const Setup& setup, const PlanningShop& shop) {
    SequenceOptions options = asPlanned(shop.request.sequence);
    options.surrogates = SurrogateRule::Single;
    options.deadline = shop.request.patience.allToolsOfOne();
    options.retract_mm = retractMm(setup, options.retract_mm, shop.machine);
    try {
        const ToolSequence sequence =
            sequenceTools(band.feature, shop.library, shop.machine, options, shop.tol);
        band.weight = pathSeconds(sequence, shop.machine);
        return !sequence.steps.empty() && !isDrilled(sequence) &&
               residualVolumeMm3(sequence) <= kMostLeftShare * band.feature.volume_mm3;
    } catch (const std::exception&) {
        return false;  // a setup that cannot is not asked to
    }
}

std::vector<LateBand> weighed(std::vector<LateBand> bands, const std::vector<Setup>& setups,
                              const PlanningShop& shop) {
    std::vector<char> able(bands.size(), 0);
    parallelFor(bands.size(),
                [&](std::size_t i) { able[i] = weigh(bands[i], setups[bands[i].setup], shop) ? 1 : 0; });
    std::vector<LateBand> clear;
    for (std::size_t i = 0; i < bands.size(); ++i)
        if (able[i] != 0) clear.push_back(std::move(bands[i]));
    return clear;
}

/// Which cells to leave if some later setups are to be left nothing.
std::vector<bool> cheapest(const std::vector<SharedCell>& cells, const std::vector<LateBand>& late,
                           const std::set<std::size_t>& without) {
    double all = 0;
    for (const SharedCell& cell : cells)
        all += cell.early_weight;
    std::vector<Takeable> takeable;
    for (const SharedCell& cell : cells) {
        const bool barred = without.count(late[cell.late].setup) > 0;
        const double margin = cell.early_weight - kLateMargin * cell.late_weight;
        takeable.push_back({barred ? -all : margin, cell.below});
    }
    return bestClosure(takeable);
}

double gainOf(const std::vector<SharedCell>& cells, const std::vector<bool>& left) {
    double gain = 0;
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (left[i]) gain += cells[i].early_weight - cells[i].late_weight;
    return gain;
}

/// The same, and a setup that would save less than is worth a trial is left nothing at all.
std::vector<bool> worthLeaving(const std::vector<SharedCell>& cells, const std::vector<LateBand>& late) {
    std::set<std::size_t> without;
    for (;;) {
        std::vector<bool> left = cheapest(cells, late, without);
        std::map<std::size_t, double> gains;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (left[i]) gains[late[cells[i].late].setup] += cells[i].early_weight - cells[i].late_weight;
        const std::size_t before = without.size();
        for (const auto& [setup, gain] : gains)
            if (gain < kLeastGainS) without.insert(setup);
        if (without.size() == before) return left;
    }
}

std::vector<WeighedWork> workOf(const std::vector<SharedCell>& cells, const std::vector<bool>& left,
                                const std::vector<EarlyBand>& early, const std::vector<LateBand>& late,
                                const std::vector<Setup>& setups) {
    std::map<std::tuple<std::size_t, std::size_t, bool>, WeighedWork> work;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const SharedCell& cell = cells[i];
        WeighedWork& one = work[{cell.early, late[cell.late].setup, left[i]}];
        one.feature = early[cell.early].feature->id;
        one.setup = axisName(setups[late[cell.late].setup].axis);
        one.volume_mm3 += cell.prism.volume_mm3();
        one.early_s += cell.early_weight;
        one.late_s += cell.late_weight;
        one.left = left[i];
    }
    std::vector<WeighedWork> list;
    for (auto& [key, one] : work)
        list.push_back(std::move(one));
    return list;
}

}  // namespace

std::optional<ReserveProposal> proposeReserve(const PlannedSetup& planned, const LayerStack& layers,
                                              const std::vector<Setup>& setups,
                                              const std::vector<std::size_t>& later,
                                              const PlanningShop& shop) {
    if (later.empty()) return std::nullopt;
    std::vector<EarlyBand> early;
    double most_s = 0;
    for (const PlannedFeature& feature : planned.features) {
        if (feature.sequence.steps.empty()) continue;
        early.push_back(
            {&feature.feature, pathSeconds(feature.sequence, shop.machine), isDrilled(feature.sequence)});
        if (!early.back().drilled) most_s += early.back().weight;
    }
    if (most_s < kLeastGainS) return std::nullopt;
    const std::vector<LateBand> late =
        weighed(lateBands(planned.setup.stock, setups, later, shop), setups, shop);
    const std::vector<SharedCell> cells =
        sharedCells(planned.setup, layers, early, late, shop.request.patience.all_tools, shop.tol);
    const std::vector<bool> left = worthLeaving(cells, late);
    ReserveProposal proposal;
    proposal.gain_s = gainOf(cells, left);
    if (proposal.gain_s < kLeastGainS) return std::nullopt;
    proposal.work = workOf(cells, left, early, late, setups);
    proposal.reserve = {planned.setup.part_to_setup, prismsOf(cells, left, shop.tol)};
    return proposal;
}

}  // namespace stepmill
