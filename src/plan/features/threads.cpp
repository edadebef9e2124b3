#include "plan/features/threads.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "plan/operations/retract.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/sequence/sizing.h"
#include "stepmill/sequence/tapping.h"

namespace stepmill {
namespace {

/// The word of a machine's dialect that has no motion coupled to the spindle.
constexpr std::string_view kWithoutTapping = "grbl";

class SetupThreads {
  public:
    SetupThreads(PlannedSetup& setup, const PlanningShop& shop, const HoleWishes& wishes,
                 ThreadedSetups& into)
        : setup_(setup),
          shop_(shop),
          wishes_(wishes),
          growth_(growthOf(setup.setup.stock, setup.setup.part_to_setup)),
          into_(into) {
        for (const PlannedFeature& planned : setup.features)
            features_[planned.feature.id] = &planned;
    }

    void cut() {
        for (PlannedFeature& planned : setup_.features) {
            for (SequenceStep& step : planned.sequence.sizing)
                add(std::move(step), planned.sequence);
            planned.sequence.sizing.clear();
            for (const HoleWish& wish : wishes_.of(planned.feature, setup_.setup)) {
                if (wish.entry->fit) tellOfFit(planned, wish);
                if (wish.entry->make != HoleMaking::Tap) continue;
                const std::string trouble = tap(planned, wish);
                if (trouble.empty()) continue;
                into_.missing += static_cast<int>(wish.places.size());
                into_.warnings.push_back(
                    {"thread", planned.feature.id,
                     fmt::format("no thread {} is cut in {} hole{}: {}", wish.entry->thread->name,
                                 wish.places.size(), wish.places.size() == 1 ? "" : "s", trouble)});
            }
        }
    }

  private:
    void tellOfFit(const PlannedFeature& planned, const HoleWish& wish) {
        const std::vector<SequenceStep>& steps = planned.sequence.steps;
        const bool sized = std::any_of(steps.begin(), steps.end(), [&](const SequenceStep& step) {
            return isSizedBy(step.role, step.fit, *wish.entry);
        });
        if (wish.whole && sized) return;
        into_.missing += static_cast<int>(wish.places.size());
        if (!wish.whole) return;  // told with the table's entries
        const std::string& trouble = planned.sequence.not_sized;
        into_.warnings.push_back(
            {"fit", planned.feature.id,
             fmt::format("{} hole{} not brought to {}: {}", wish.places.size(),
                         wish.places.size() == 1 ? " is" : "s are", wish.entry->fit->name,
                         trouble.empty() ? "not all of it is made" : trouble)});
    }

    void add(SequenceStep step, ToolSequence& sequence) const {
        const EdgeCost cost = edgeCost(step.path.totals, shop_.library.tool(step.tool_id), shop_.machine);
        sequence.time_s += cost.time_s;
        sequence.cost += cost.cost;
        sequence.motion_s += cost.motion_s;
        sequence.steps.push_back(std::move(step));
    }

    /// \return  why there is no step; empty where there is one
    std::string tap(PlannedFeature& planned, const HoleWish& wish) const {
        if (shop_.machine.dialect == kWithoutTapping)
            return fmt::format("{} ({}) has no motion coupled to the spindle", shop_.machine.name,
                               shop_.machine.dialect);
        if (planned.feature.band) return "the hole is cut in several bands";
        const ToolLibrary& library = shop_.libraryOf(planned.feature.id);
        const CutById by_id = [this](const std::string& id) { return asCut(*features_.at(id)); };
        const Feature hole = asFound(planned.feature, by_id, setup_.setup.fixtures, growth_, shop_.tol);
        const std::optional<double> bored_to_z = boredToZ(hole, planned.sequence, library);
        if (!bored_to_z) return "no tool makes the hole whole";
        TapTask task{hole,
                     *bored_to_z,
                     planned.feature.top_z_mm,
                     wish.entry->thread_depth_mm,
                     wish.places,
                     retractMm(setup_.setup, shop_.request.sequence.retract_mm, shop_.machine)};
        return tapWithBest(task, *wish.entry->thread, library, planned.sequence);
    }

    std::string tapWithBest(const TapTask& task, const Thread& thread, const ToolLibrary& library,
                            ToolSequence& sequence) const {
        std::optional<SequenceStep> best;
        std::string trouble =
            fmt::format("the library has no tap {} for {}", thread.name, shop_.request.sequence.material);
        for (const ToolAssembly& tool : library.tools) {
            const CuttingData* cutting = tool.cuttingFor(shop_.request.sequence.material);
            if (!tool.isTap() || cutting == nullptr || !sameThread(*tool.thread, thread)) continue;
            const Feature hole = asTapFinds(task.hole, tool, setup_.setup.fixtures, shop_.tol);
            TapStep made = tapStep({hole, task.bored_to_z_mm, task.top_z_mm, task.thread_depth_mm,
                                    task.places, task.retract_z_mm},
                                   tool, *cutting, shop_.machine);
            if (!made.step) {
                trouble = std::move(made.trouble);
                continue;
            }
            const bool quicker =
                !best || made.step->path.totals.motion_time_s < best->path.totals.motion_time_s;
            if (quicker) best = std::move(made.step);
        }
        if (!best) return trouble;
        add(std::move(*best), sequence);
        return {};
    }

    PlannedSetup& setup_;
    const PlanningShop& shop_;
    const HoleWishes& wishes_;
    StockGrowth growth_;
    ThreadedSetups& into_;
    std::map<std::string, const PlannedFeature*> features_;
};

}  // namespace

ThreadedSetups withThreads(std::vector<PlannedSetup> setups, const PlanningShop& shop,
                           const HoleWishes& wishes) {
    ThreadedSetups threaded;
    for (PlannedSetup& setup : setups)
        SetupThreads(setup, shop, wishes, threaded).cut();
    threaded.setups = std::move(setups);
    return threaded;
}

}  // namespace stepmill
