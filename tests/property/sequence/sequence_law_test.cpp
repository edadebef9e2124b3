#include <random>

#include <gtest/gtest.h>

#include "sequence/dag/sequence_choices.h"
#include "support/clearing_tasks.h"
#include "support/random_numbers.h"
#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;

Feature randomPocket(std::mt19937& random) {
    const double width = uniform(random, 30, 100);
    const double height = uniform(random, 30, 80);
    Region target = makeRoundedRectangle(Vec2(0, 0), Vec2(width, height), uniform(random, 1.5, 8));
    if (std::bernoulli_distribution(0.6)(random)) {
        const Vec2 centre(width * uniform(random, 0.35, 0.65), height * uniform(random, 0.35, 0.65));
        target = subtract(target, makeCircle(centre, uniform(random, 3, 8)), kTol);
    }
    return makePocket(target, uniform(random, 2, 25));
}

ToolLibrary randomTools(std::mt19937& random) {
    std::vector<ToolAssembly> tools;
    const int count = std::uniform_int_distribution(1, 6)(random);
    std::set<int> diameters;
    while (static_cast<int>(diameters.size()) < count)
        diameters.insert(std::uniform_int_distribution(3, 25)(random));
    for (const int diameter : diameters) {
        ToolAssembly tool = makeMill(diameter, uniform(random, 300, 3000), uniform(random, 1, 8));
        tool.price = uniform(random, 0, 200);
        tool.life_min = uniform(random, 5, 100);
        tools.push_back(tool);
    }
    return makeLibrary(tools);
}

/// The weights of all edges by areas and paths made here, one by one, with nothing left out.
class EveryEdge {
  public:
    EveryEdge(const Feature& feature, const ToolLibrary& library, const Machine& machine,
              const SequenceOptions& options)
        : feature_(feature), library_(library), machine_(machine), options_(options), ground_(feature, kTol) {
        for (const ToolAssembly& tool : library.tools)
            order_.push_back(&tool);
        std::sort(order_.begin(), order_.end(), [](const ToolAssembly* a, const ToolAssembly* b) {
            return a->diameter_mm > b->diameter_mm;
        });
        for (const ToolAssembly* tool : order_)
            reaches_.push_back(toolReach(ground_, *tool, options.material));
    }

    /// The least weight over all subsets, each used in falling diameter; infinite when none finishes.
    double cheapest() const {
        double best_mm2 = 0;
        for (const ToolReach& tool : reaches_)
            if (tool.exclusion() == nullptr) best_mm2 = std::max(best_mm2, tool.cutter.coverable_area_mm2);
        const double same_mm2 = std::max(kTol.area_mm2, 1e-5 * feature_.area_mm2);
        double least = std::numeric_limits<double>::infinity();
        for (unsigned subset = 1; subset < (1U << order_.size()); ++subset) {
            double sum = 0;
            int last = -1;
            for (int k = 0; k < static_cast<int>(order_.size()); ++k) {
                if ((subset >> k & 1U) == 0) continue;
                sum += weight(last, k);
                last = k;
            }
            if (reaches_[last].cutter.coverable_area_mm2 < best_mm2 - same_mm2) continue;
            least = std::min(least, sum);
        }
        return least;
    }

  private:
    double weight(int m, int n) const {
        const auto [found, is_new] = known_.emplace(std::pair(m, n), std::numeric_limits<double>::infinity());
        if (!is_new || reaches_[n].exclusion() || (m >= 0 && reaches_[m].exclusion())) return found->second;
        const CutterArea& now = reaches_[n].cutter;
        const DecomposedArea area = decomposedArea(ground_, m < 0 ? nullptr : &reaches_[m].cutter, now);
        // Patterns as edges are weighed.
        const ClearingTask task = taskOf(feature_, now, area, machine_, Pattern::ContourInsideOut);
        const Toolpath path =
            clearArea(task, *order_[n], *order_[n]->cuttingFor(options_.material), machine_, kTol);
        if (path.moves.empty()) return found->second;
        const EdgeCost cost = edgeCost(path.totals, *order_[n], machine_);
        return found->second = options_.objective == Objective::Time ? cost.time_s : cost.cost;
    }

    const Feature& feature_;
    const ToolLibrary& library_;
    const Machine& machine_;
    const SequenceOptions& options_;
    FeatureGround ground_;
    std::vector<const ToolAssembly*> order_;
    std::vector<ToolReach> reaches_;
    mutable std::map<std::pair<int, int>, double> known_;
};

TEST(SequenceLaw, IsAsCheapAsTheBestOfAllSequences) {
    for (unsigned seed = 0; seed < 25; ++seed) {
        std::mt19937 random(seed);
        const Feature pocket = randomPocket(random);
        const ToolLibrary library = randomTools(random);
        const SequenceOptions options = inAluminium(seed % 2 == 0 ? Objective::Time : Objective::Cost);
        const Machine machine = makeMachine();
        const ToolSequence sequence = sequenceTools(pocket, library, machine, options, kTol);
        const double expected = EveryEdge(pocket, library, machine, options).cheapest();
        if (sequence.steps.empty()) {
            EXPECT_EQ(expected, std::numeric_limits<double>::infinity()) << "seed " << seed;
            continue;
        }
        const double found = sequence.choices->dag().weight;
        EXPECT_NEAR(found, expected, 1e-9 * expected) << "seed " << seed;
        // The steps themselves take the quickest patterns.
        EXPECT_LE(options.objective == Objective::Time ? sequence.time_s : sequence.cost, found * (1 + 1e-9))
            << "seed " << seed;
    }
}

TEST(SequenceLaw, NeverBeatsItsLowerBound) {
    for (unsigned seed = 100; seed < 130; ++seed) {
        std::mt19937 random(seed);
        const Feature pocket = randomPocket(random);
        const ToolLibrary library = randomTools(random);
        const ToolSequence sequence = sequenceTools(pocket, library, makeMachine(), inAluminium(), kTol);
        EXPECT_LE(sequence.lower_bound_s, sequence.time_s) << "seed " << seed;
        EXPECT_EQ(sequence.lower_bound_s > 0, !sequence.steps.empty()) << "seed " << seed;
    }
}

TEST(SequenceLaw, EvaluatesNoMoreEdgesThanPairsOfTools) {
    for (unsigned seed = 200; seed < 215; ++seed) {
        std::mt19937 random(seed);
        const Feature pocket = randomPocket(random);
        const ToolLibrary library = randomTools(random);
        const ToolSequence sequence = sequenceTools(pocket, library, makeMachine(), inAluminium(), kTol);
        std::size_t evaluated = 0;
        for (const DagEdge& edge : sequence.edges)
            evaluated += edge.to.empty() ? 0 : 1;
        const std::size_t n = library.tools.size();
        EXPECT_LE(evaluated + static_cast<std::size_t>(sequence.pruned_edges), n * (n + 1) / 2)
            << "seed " << seed;
    }
}

TEST(SequenceLaw, WhatIsClearedAndWhatStaysMakeTheFeature) {
    for (unsigned seed = 300; seed < 320; ++seed) {
        std::mt19937 random(seed);
        const Feature pocket = randomPocket(random);
        const ToolSequence sequence =
            sequenceTools(pocket, randomTools(random), makeMachine(), inAluminium(), kTol);
        double left_mm2 = 0;
        for (const Residual& residual : sequence.residual)
            left_mm2 += residual.area_mm2;
        double cleared_mm2 = 0;
        for (const ToolReach& tool : sequence.tools)
            if (!tool.exclusion()) cleared_mm2 = std::max(cleared_mm2, tool.cleared().coverable_area_mm2);
        EXPECT_NEAR(left_mm2 + cleared_mm2, pocket.area_mm2, 1e-3 * pocket.area_mm2) << "seed " << seed;
    }
}

}  // namespace
}  // namespace stepmill::test
