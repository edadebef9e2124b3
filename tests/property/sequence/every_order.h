#pragma once

#include <limits>
#include <map>
#include <vector>

#include "sequence/dag/candidate.h"
#include "sequence/holder/tool_areas.h"
#include "stepmill/access/swept.h"
#include "stepmill/sequence/machine_limits.h"
#include "support/clearing_tasks.h"
#include "support/sample_feature.h"

namespace stepmill::test {

/// The cheapest way to clear a feature with its tools in any order: the oracle for the tool DAG's rule
/// that diameters fall.
///
/// Each tool sweeps all it can reach itself, less what the tools before it have swept, on a real path.
/// What is still material depends on the set of tools used, not on their order, so the cheapest order
/// over all ordered subsets is a cheapest path over the 2^n sets. A step may also take what one wider
/// tool of the set has swept for all that is gone, as an edge of the DAG does: so every path through a
/// DAG without surrogates is among those looked at, at the same cost.
class EveryOrder {
  public:
    /// The tools as the DAG's areas have them, or where their holder is in the way the part that it
    /// allows.
    EveryOrder(const Feature& feature, const ToolLibrary& library, const Machine& machine,
               const SequenceOptions& options)
        : machine_(machine), options_(options), ground_(feature, tol_) {
        for (const ToolAssembly* tool : byFallingDiameter(library)) {
            const ToolReach reach = toolReach(ground_, *tool, options.material);
            const auto clear = reach.exclusion() ? collisionFreeArea(ground_, *tool, reach) : reach.cutter;
            if (!clear) continue;
            tools_.push_back(tool);
            areas_.push_back(*clear);
        }
        cleared_.resize(std::size_t{1} << tools_.size());
        for (std::size_t set = 1; set < cleared_.size(); ++set)
            cleared_[set] = clearedBy(set);
    }

    /// What all tools reach together [mm2].
    double reach_mm2() const { return cleared_.back().coverable_area_mm2; }

    /// The least seconds or money, as the objective asks, to clear that much; infinite if that is too
    /// much.
    /// \param falling  only orders in which no tool is wider than one before it
    double cheapest(double enough_mm2, bool falling = false) {
        std::vector<double> best(cleared_.size(), kInfinite);
        best[0] = 0;
        double least = kInfinite;
        for (std::size_t set = 0; set < best.size(); ++set) {
            if (best[set] >= least) continue;
            if (set > 0 && cleared_[set].coverable_area_mm2 >= enough_mm2) least = best[set];
            for (std::size_t n = 0; n < tools_.size(); ++n) {
                const std::size_t with = set | std::size_t{1} << n;
                const bool in_order = !falling || set >> n == 0;
                if (with != set && in_order) best[with] = std::min(best[with], best[set] + step(set, n));
            }
        }
        return least;
    }

  private:
    static constexpr double kInfinite = std::numeric_limits<double>::infinity();

    /// The set's areas as those of one tool; the tool's own where it reaches all that the set does.
    CutterArea clearedBy(std::size_t set) const {
        CutterArea all;
        std::vector<Region> swept;
        for (std::size_t n = 0; n < tools_.size(); ++n) {
            if ((set >> n & 1U) == 0) continue;
            all.accessible = all.accessible.empty() ? areas_[n].accessible
                                                    : unite(all.accessible, areas_[n].accessible, tol_);
            swept.push_back(areas_[n].swept.region());
            all.coverable =
                all.coverable.empty() ? areas_[n].coverable : unite(all.coverable, areas_[n].coverable, tol_);
        }
        all.coverable_area_mm2 = area(all.coverable);
        for (std::size_t n = 0; n < tools_.size(); ++n)
            if ((set >> n & 1U) != 0 && areas_[n].coverable_area_mm2 >= all.coverable_area_mm2 - same())
                return areas_[n];
        if (!swept.empty()) all.swept = SureSweep(unite(swept, tol_), tol_);
        return all;
    }

    double same() const { return sameArea(ground_.feature(), tol_); }

    /// Tool n after all of the set, its change included.
    double step(std::size_t set, std::size_t n) {
        const auto [found, is_new] = steps_.emplace(std::pair(set, n), kInfinite);
        if (!is_new) return found->second;
        double least = sweep(cleared_[set], n);
        // Small sets that stand for the whole set leave more to sweep, but maybe on a shorter path.
        for (std::size_t m = 0; m < tools_.size() && set != 0; ++m) {
            const std::size_t alone = std::size_t{1} << m;
            if ((set & alone) != 0 && set != alone && m < n) least = std::min(least, step(alone, n));
        }
        return steps_[{set, n}] = least;
    }

    double sweep(CutterArea before, std::size_t n) const {
        if (before.radius_mm < areas_[n].radius_mm) {
            // A wider tool, or one after several: only what is swept counts.
            before.radius_mm = areas_[n].radius_mm;
            before.opens_target = false;
        }
        const bool first = before.accessible.empty();
        const DecomposedArea left = decomposedArea(ground_, first ? nullptr : &before, areas_[n]);
        if (left.centres.empty() || left.new_area_mm2 <= same()) return kInfinite;
        const ToolAssembly& tool = *tools_[n];
        const CuttingData cutting = limitedBy(machine_, *tool.cuttingFor(options_.material));
        ClearingTask task = taskOf(ground_.feature(), areas_[n], left, machine_, Pattern::ContourInsideOut);
        addHolder(ground_.feature(), tool, task);
        const Toolpath path = clearArea(task, tool, cutting, machine_, tol_);
        if (path.moves.empty()) return kInfinite;
        const EdgeCost cost = edgeCost(path.totals, tool, machine_);
        return options_.objective == Objective::Time ? cost.time_s : cost.cost;
    }

    const Tolerances tol_;
    const Machine& machine_;
    const SequenceOptions& options_;
    FeatureGround ground_;
    std::vector<const ToolAssembly*> tools_;
    std::vector<CutterArea> areas_;
    std::vector<CutterArea> cleared_;  ///< by each set of tools
    std::map<std::pair<std::size_t, std::size_t>, double> steps_;
};

}  // namespace stepmill::test
