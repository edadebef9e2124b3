#include <limits>
#include <map>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "bossed_tasks.h"
#include "sequence/dag/candidate.h"
#include "sequence/dag/sequence_choices.h"
#include "sequence/surrogates/surrogates.h"
#include "support/clearing_tasks.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Every sequence of tools, alone or with every choice of surrogates for every lump, weighed one by one.
///
/// Shares with the planner what a tool reaches, which lumps it has and what one surrogate's path in a lump
/// costs; the sums, the changes and the choice are its own.
class EverySequence {
  public:
    EverySequence(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                  const SequenceOptions& options, const std::vector<ToolReach>& reaches)
        : machine_(machine),
          options_(options),
          job_(std::make_shared<const SequenceJob>(feature, library, machine, options, kTol)),
          tools_(usableTools(feature, reaches, job_->library, options, machine, kTol)),
          ends_(endTools(feature, tools_, kTol)),
          finder_(job_, reaches) {}

    double cheapest() {
        double least = kInfinite;
        const int n = static_cast<int>(tools_.size());
        for (unsigned subset = 1; subset < (1U << n); ++subset) {
            std::vector<int> sequence;
            for (int k = 0; k < n; ++k)
                if ((subset >> k & 1U) != 0) sequence.push_back(k);
            if (ends_[sequence.back()]) least = std::min(least, weightOf(sequence));
        }
        return least;
    }

  private:
    double weigh(const EdgeCost& cost) const {
        return options_.objective == Objective::Time ? cost.time_s : cost.cost;
    }
    double change() const { return weigh(edgeCost({}, *tools_.front().tool, machine_)); }

    double weightOf(const std::vector<int>& sequence) {
        double sum = 0;
        for (std::size_t i = 0; i < sequence.size() && sum < kInfinite; ++i) {
            const int m = i == 0 ? -1 : sequence[i - 1];
            const int next = i + 1 < sequence.size() ? sequence[i + 1] : -1;
            sum += own(m, sequence[i]);
            if (sum < kInfinite) sum += lumps(m, sequence[i], next);
        }
        return sum;
    }

    /// Of n's own path and the change to it.
    double own(int m, int n) {
        const auto [found, is_new] = own_.emplace(std::pair(m, n), kInfinite);
        if (!is_new) return found->second;
        const CutterArea& n_own = *tools_[n].own;
        const DecomposedArea area = decomposedArea(job_->ground, m < 0 ? nullptr : tools_[m].cleared, n_own);
        if (area.new_area_mm2 <= sameArea(job_->feature(), kTol) && !tools_[n].hasSurrogates())
            return kInfinite;
        // Patterns as edges are weighed.
        const ClearingTask task = taskOf(job_->feature(), n_own, area, machine_, Pattern::ContourInsideOut);
        const Toolpath path = clearArea(task, *tools_[n].tool, tools_[n].cutting, machine_, kTol);
        if (path.moves.empty()) return kInfinite;
        return found->second = weigh(edgeCost(path.totals, *tools_[n].tool, machine_));
    }

    const Lumps& lumpsOf(int m, int n) {
        const auto found = lumps_.find({m, n});
        if (found != lumps_.end()) return found->second;
        const CutterArea* from = m < 0 ? nullptr : tools_[m].cleared;
        return lumps_[{m, n}] = tools_[n].hasSurrogates() ? finder_.lumpsOf(from, *tools_[n].reach) : Lumps{};
    }

    /// Surrogates' paths and changes, the least over all combinations.
    double lumps(int m, int n, int next) {
        const Lumps& all = lumpsOf(m, n);
        const int joining = next < 0 ? kNoTool : finder_.numberOf(*tools_[next].tool);
        double least = all.empty() ? 0 : kInfinite;
        for (const auto& lump : all)
            if (lump->ways().empty()) return kInfinite;
        std::vector<std::size_t> choice(all.size(), 0);
        while (!all.empty()) {
            double sum = 0;
            std::set<int> called;
            bool joins = true;
            for (std::size_t i = 0; i < all.size(); ++i) {
                const LumpWay& way = all[i]->ways()[choice[i]];
                const auto& totals = all[i]->totals(static_cast<int>(choice[i]));
                for (std::size_t k = 0; k < way.tools.size(); ++k) {
                    const ToolAssembly& tool = all[i]->tool(way.tools[k]);
                    sum += weigh(edgeCost(totals[k], tool, machine_)) - change();
                    called.insert(way.tools[k]);
                    joins = joins && (way.tools[k] != joining || k + 1 == way.tools.size());
                }
            }
            const bool joined = joins && called.count(joining) > 0;
            least = std::min(least, sum + change() * static_cast<double>(called.size() - (joined ? 1 : 0)));
            std::size_t i = 0;
            while (i < all.size() && ++choice[i] == all[i]->ways().size())
                choice[i++] = 0;
            if (i == all.size()) break;
        }
        return least;
    }

    const Machine& machine_;
    const SequenceOptions& options_;
    std::shared_ptr<const SequenceJob> job_;
    std::vector<Candidate> tools_;
    std::vector<bool> ends_;
    SurrogateFinder finder_;
    std::map<std::pair<int, int>, double> own_;
    std::map<std::pair<int, int>, Lumps> lumps_;
};

struct Planned {
    Feature feature;
    ToolLibrary library;
    SequenceOptions options;
    ToolSequence sequence;

    bool toItsFloor() const { return sequence.floor_z_mm == feature.floor_z_mm; }
    bool hasSurrogates() const {
        return std::any_of(sequence.tools.begin(), sequence.tools.end(),
                           [](const ToolReach& tool) { return tool.surrogates() != nullptr; });
    }
};

Planned planRandom(unsigned seed) {
    std::mt19937 random(seed);
    Planned planned;
    planned.feature = randomBossedPocket(random);
    planned.library = randomHeldTools(random);
    planned.options = randomOptions(seed);
    planned.sequence = sequenceTools(planned.feature, planned.library, makeMachine(), planned.options, kTol);
    return planned;
}

TEST(SurrogateLaw, IsAsCheapAsTheBestOfAllSequences) {
    int with_surrogates = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        const Planned planned = planRandom(seed);
        const ToolSequence& sequence = planned.sequence;
        if (sequence.steps.empty() || !planned.toItsFloor()) continue;
        with_surrogates += planned.hasSurrogates() ? 1 : 0;
        const Machine machine = makeMachine();
        EverySequence every(planned.feature, planned.library, machine, planned.options, sequence.tools);
        const double expected = every.cheapest();
        const Objective objective = planned.options.objective;
        const double found = sequence.choices->dag().weight;
        EXPECT_NEAR(found, expected, 1e-9 * expected) << "seed " << seed;
        // The steps themselves take the quickest patterns.
        EXPECT_LE(objective == Objective::Time ? sequence.time_s : sequence.cost, found * (1 + 1e-9))
            << "seed " << seed;
    }
    EXPECT_GE(with_surrogates, 15) << "the shapes should need surrogates";
}

TEST(SurrogateLaw, EvaluatesNoMoreEdgesThanPairsOfNodes) {
    for (unsigned seed = 100; seed < 115; ++seed) {
        const Planned planned = planRandom(seed);
        std::size_t evaluated = 0;
        for (const DagEdge& edge : planned.sequence.edges)
            evaluated += edge.to.empty() ? 0 : 1;
        const std::size_t n = planned.sequence.choices->tools().size();
        EXPECT_LE(evaluated + static_cast<std::size_t>(planned.sequence.pruned_edges), n * (n + 1) / 2)
            << "seed " << seed;
    }
}

TEST(SurrogateLaw, DoesNotDependOnTheNumberOfThreads) {
    const auto run = [](unsigned seed, int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return planRandom(seed);
    };
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Planned one = run(seed, 1);
        const Planned four = run(seed, 4);
        EXPECT_EQ(one.sequence.time_s, four.sequence.time_s) << "seed " << seed;
        EXPECT_EQ(one.sequence.pruned_edges, four.sequence.pruned_edges) << "seed " << seed;
        EXPECT_EQ(one.sequence.edges.size(), four.sequence.edges.size()) << "seed " << seed;
    }
}

TEST(SurrogateLaw, NeverBeatsItsLowerBound) {
    for (unsigned seed = 100; seed < 120; ++seed) {
        const Planned planned = planRandom(seed);
        EXPECT_LE(planned.sequence.lower_bound_s, planned.sequence.time_s) << "seed " << seed;
    }
}

/// D' and K cover what D covers [DSouza2006, eq. 18 and 19]: swept by the steps and left as residual make the
/// target.
TEST(SurrogateLaw, WhatIsSweptAndWhatStaysMakeTheFeature) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        const Planned planned = planRandom(seed);
        if (planned.sequence.steps.empty() || !planned.toItsFloor()) continue;
        std::vector<Region> done;
        for (const SequenceStep& step : planned.sequence.steps)
            done.push_back(step.area.area);
        for (const Residual& residual : planned.sequence.residual)
            done.push_back(residual.region);
        const Region missing = subtract(planned.feature.target, unite(done, kTol), kTol);
        EXPECT_LE(area(missing), 1e-4 * planned.feature.area_mm2) << "seed " << seed;
    }
}

/// Points on a path with the tip's height.
std::vector<Vec3> samplesOf(const Toolpath& path, double every_mm) {
    std::vector<Vec3> points{path.start};
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const Segment segment{move.to.head<2>(), move.arc};
        const double run_mm = length(from.head<2>(), segment);
        const int count = 1 + static_cast<int>(std::max(run_mm, std::abs(move.to.z() - from.z())) / every_mm);
        for (int i = 1; i <= count; ++i) {
            const double t = static_cast<double>(i) / count;
            Vec3 point;
            point << (run_mm > 0 ? pointAt(from.head<2>(), segment, t) : Vec2(move.to.head<2>())),
                from.z() + t * (move.to.z() - from.z());
            points.push_back(point);
        }
        from = move.to;
    }
    return points;
}

double distanceTo(const Region& region, const Vec2& p) {
    return contains(region, p) ? 0 : distanceToBoundary(region, p);
}

TEST(SurrogateLaw, HoldersAndCuttersNeverMeetWhatStands) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        const Planned planned = planRandom(seed);
        for (const SequenceStep& step : planned.sequence.steps) {
            const ToolAssembly& tool = planned.library.tool(step.tool_id);
            EXPECT_GE(step.proof.least_clearance_mm, -kTol.gouge_mm);
            EXPECT_TRUE(step.proof.rapids_clear);
            double worst_mm = kInfinite;
            for (const Vec3& tip : samplesOf(step.path, 0.7)) {
                for (const Obstacle& obstacle : planned.feature.obstacles) {
                    if (tip.z() < obstacle.top_z_mm)
                        worst_mm = std::min(worst_mm,
                                            distanceTo(obstacle.section, tip.head<2>()) - tool.radius_mm());
                    for (const HolderCylinder& cylinder : tool.holder) {
                        if (tip.z() + cylinder.bottom_mm >= obstacle.top_z_mm) continue;
                        worst_mm = std::min(
                            worst_mm, distanceTo(obstacle.section, tip.head<2>()) - cylinder.diameter_mm / 2);
                    }
                }
            }
            EXPECT_GE(worst_mm, -kTol.gouge_mm) << "seed " << seed << ", " << step.tool_id;
        }
    }
}

TEST(SurrogateLaw, OneMoreToolNeverMakesAPlanWorse) {
    for (unsigned seed = 200; seed < 225; ++seed) {
        std::mt19937 random(seed);
        const Feature feature = randomBossedPocket(random);
        const ToolLibrary more = randomHeldTools(random);
        ToolLibrary fewer = more;
        fewer.tools.erase(fewer.tools.begin() + static_cast<int>(seed % more.tools.size()));
        const SequenceOptions options = inAluminium();
        const ToolSequence with = sequenceTools(feature, more, makeMachine(), options, kTol);
        const ToolSequence without = sequenceTools(feature, fewer, makeMachine(), options, kTol);
        const double slack_mm3 = 1e-6 * feature.volume_mm3;
        ASSERT_LE(residualVolumeMm3(with), residualVolumeMm3(without) + slack_mm3) << "seed " << seed;
        if (residualVolumeMm3(with) < residualVolumeMm3(without) - slack_mm3) continue;
        EXPECT_LE(with.time_s, without.time_s * (1 + 1e-9)) << "seed " << seed;
    }
}

TEST(SurrogateLaw, AFatterOrLowerHolderNeverReachesMore) {
    for (unsigned seed = 300; seed < 320; ++seed) {
        std::mt19937 random(seed);
        const FeatureGround ground(randomBossedPocket(random), kTol);
        ToolAssembly tool = makeMill(std::uniform_int_distribution(3, 16)(random));
        tool.stick_out_mm = uniform(random, 11, 35);
        tool.holder.push_back(
            {tool.diameter_mm + uniform(random, 4, 30), tool.stick_out_mm, tool.stick_out_mm + 20});
        const double free_mm2 = toolReach(ground, tool, "aluminium").collision_free_area_mm2;
        ToolAssembly fatter = tool;
        fatter.holder[0].diameter_mm += uniform(random, 0, 10);
        ToolAssembly lower = tool;
        lower.stick_out_mm -= uniform(random, 0, 8);
        lower.holder[0].bottom_mm = lower.stick_out_mm;
        const double slack_mm2 = 1e-5 * ground.feature().area_mm2;
        for (const ToolAssembly& worse : {fatter, lower})
            EXPECT_LE(toolReach(ground, worse, "aluminium").collision_free_area_mm2, free_mm2 + slack_mm2)
                << "seed " << seed;
    }
}

}  // namespace
}  // namespace stepmill::test
