#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bossed_tasks.h"
#include "every_order.h"
#include "sequence/dag/sequence_choices.h"
#include "support/random_grounds.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;
constexpr double kRounding = 1e-9;

/// How often and by how much some numbers are less than the DAG's.
struct Gains {
    int cheaper = 0;
    double sum = 0;  ///< of (DAG - other) / DAG where that is cheaper
    double largest = 0;

    void add(double dag, double other) {
        if (other >= dag * (1 - kRounding)) return;
        ++cheaper;
        sum += 1 - other / dag;
        largest = std::max(largest, 1 - other / dag);
    }
    std::string text() const {
        return fmt::format("{} cheaper, by {:.1f} % (mean) to {:.1f} %", cheaper,
                           cheaper > 0 ? 100 * sum / cheaper : 0.0, 100 * largest);
    }
};

struct Comparison {
    int compared = 0;
    Gains any_order;
    Gains falling;       ///< the same steps, widest first
    int reach_more = 0;  ///< where all tools together reach more than a plan of the DAG

    void print(const char* name) const {
        fmt::print("{}: {} features; any order: {}; falling order: {}; {} reach more\n", name, compared,
                   any_order.text(), falling.text(), reach_more);
    }
};

bool hasSurrogates(const ToolSequence& sequence) {
    return std::any_of(sequence.choices->tools().begin(), sequence.choices->tools().end(),
                       [](const Candidate& tool) { return tool.hasSurrogates(); });
}

double mostCoveredMm2(const ToolSequence& sequence) {
    double most_mm2 = 0;
    for (const Candidate& tool : sequence.choices->tools())
        most_mm2 = std::max(most_mm2, tool.coverable_mm2);
    return most_mm2;
}

/// Compares a feature's DAG with all orders; nothing where the DAG has no plan down to the floor.
void compare(const Feature& feature, const ToolLibrary& library, unsigned seed, Comparison& found) {
    const Machine machine = makeMachine();
    const SequenceOptions options = randomOptions(seed);
    const ToolSequence sequence = sequenceTools(feature, library, machine, options, kTol);
    if (sequence.steps.empty() || sequence.floor_z_mm != feature.floor_z_mm) return;
    EveryOrder every(feature, library, machine, options);
    const double dag = sequence.choices->dag().weight;
    const double covered_mm2 = mostCoveredMm2(sequence);
    const double enough_mm2 = covered_mm2 - sameArea(feature, kTol);
    const double any_order = every.cheapest(enough_mm2);
    const double falling = every.cheapest(enough_mm2, true);
    EXPECT_LE(any_order, falling * (1 + kRounding)) << "seed " << seed;
    // Without surrogates the oracle looks at every path of the DAG.
    if (!hasSurrogates(sequence)) {
        EXPECT_LE(falling, dag * (1 + kRounding)) << "seed " << seed;
    }
    ++found.compared;
    found.any_order.add(dag, any_order);
    found.falling.add(dag, falling);
    if (every.reach_mm2() > covered_mm2 + 1e-4 * feature.area_mm2) ++found.reach_more;
}

/// Two to four end mills without holders, also of equal diameters: feeds, depths of cut and lengths at
/// random.
ToolLibrary randomMills(std::mt19937& random, bool centre_cutting) {
    std::vector<ToolAssembly> tools;
    const int count = std::uniform_int_distribution(2, 4)(random);
    for (int i = 0; i < count; ++i) {
        const bool twin = i > 0 && std::bernoulli_distribution(0.25)(random);
        const double diameter =
            twin ? tools.back().diameter_mm : std::uniform_int_distribution(3, 20)(random);
        ToolAssembly tool = makeMill(diameter, uniform(random, 300, 3000), uniform(random, 1, 8));
        tool.id = fmt::format("EM{:.0f}#{}", diameter, i);
        tool.stick_out_mm = uniform(random, 8, 40);
        tool.price = uniform(random, 0, 200);
        tool.life_min = uniform(random, 5, 100);
        tool.centre_cutting = centre_cutting || std::bernoulli_distribution(0.5)(random);
        tools.push_back(tool);
    }
    return makeLibrary(tools);
}

Feature randomFeature(unsigned seed) {
    RandomGround ground(seed);
    return seed % 2 == 0 ? ground.closed() : ground.open();
}

Comparison compareWithoutHolders(bool centre_cutting) {
    Comparison found;
    for (unsigned seed = 0; seed < 120; ++seed) {
        std::mt19937 random(seed);
        compare(randomFeature(seed), randomMills(random, centre_cutting), seed, found);
    }
    EXPECT_GE(found.compared, 100);
    // Widest first the oracle's steps are the DAG's.
    EXPECT_EQ(found.falling.cheaper, 0);
    return found;
}

/// Without holders a narrower cutter reaches all that a wider one does, so nothing is left to a wider one
/// after it, however slow or fast they are.
TEST(OrderLaw, FallingDiametersAreBestWithoutHolders) {
    const Comparison found = compareWithoutHolders(true);
    found.print("centre cutting, no holders");
    EXPECT_EQ(found.any_order.cheaper, 0);
    EXPECT_EQ(found.reach_more, 0);
}

/// But a narrower one that does not cut to its centre may not get down where a wider one does.
TEST(OrderLaw, OtherOrdersSeldomMatterForMillsThatCannotPlunge) {
    const Comparison found = compareWithoutHolders(false);
    found.print("half of them not centre cutting, no holders");
    EXPECT_LE(found.any_order.cheaper, found.compared / 20);
    EXPECT_LE(found.reach_more, found.compared / 20);
}

/// One of the tools again, set out farther and slower.
ToolAssembly longerTwin(ToolAssembly tool) {
    constexpr double kFarther_mm = 15;
    tool.id += "-long";
    tool.stick_out_mm += kFarther_mm;
    for (HolderCylinder& cylinder : tool.holder) {
        cylinder.bottom_mm += kFarther_mm;
        cylinder.top_mm += kFarther_mm;
    }
    tool.cutting.front().feed_mm_per_min /= 2;
    return tool;
}

/// With holders in the way surrogates clear lump by lump at once, or a later tool clears what one left, while
/// the oracle's tools leave what their holder keeps off to whoever comes later. That is sometimes cheaper;
/// docs/algorithms/tool-dag.md has the figures printed here.
TEST(OrderLaw, OtherOrdersSometimesBeatSurrogates) {
    Comparison found;
    for (unsigned seed = 200; seed < 320; ++seed) {
        std::mt19937 random(seed);
        const Feature feature = randomBossedPocket(random);
        ToolLibrary library = randomHeldTools(random, 4);
        library.tools.push_back(longerTwin(library.tools[seed % library.tools.size()]));
        compare(feature, library, seed, found);
    }
    found.print("holders in the way");
    EXPECT_GE(found.compared, 100);
    EXPECT_LE(found.any_order.sum, 0.01 * found.compared) << "more than 1 % over all features";
}

}  // namespace
}  // namespace stepmill::test
