// Roughing with an allowance and finishing against the plain sequence of the same feature.

#include <random>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "support/height_map.h"
#include "support/random_pockets.h"
#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;
constexpr double kCellMm = 0.25;
/// Half a cell's diagonal at the cutter's rim.
constexpr double kRimMm = 0.2;
constexpr double kBlockMm = 15;
constexpr double kScallopMm = kCellMm / 10;

/// A random target in a block that is cut away on some sides.
Feature randomFeature(std::mt19937& random) {
    const double depth_mm = std::uniform_real_distribution(3.0, 25.0)(random);
    const Region target = components(randomTarget(random, kTol)).front();
    Feature feature = makePocket(target, depth_mm);
    feature.obstruction = randomObstruction(random, target, kTol);
    feature.obstacles = {{feature.floor_z_mm, feature.top_z_mm, feature.obstruction}};
    feature.open_length_mm = feature.closed_length_mm = 0;
    feature.boundary.clear();
    for (const Loop& loop : target.loops) {
        const SplitPath parts = split(loop, feature.obstruction, kTol);
        for (const Path& wall : parts.on)
            feature.closed_length_mm += length(wall);
        for (const Path& open : parts.outside)
            feature.open_length_mm += length(open);
    }
    return feature;
}

ToolLibrary randomTools(std::mt19937& random) {
    std::vector<ToolAssembly> tools;
    for (const int diameter : {4, 6, 10, 16, 20})
        if (diameter == 4 || random() % 2 == 0)
            tools.push_back(makeMill(diameter, 300.0 * diameter, std::max(2.0, 0.4 * diameter)));
    return makeLibrary(tools);
}

HeightMap blockOf(const Feature& feature) {
    Box2 box = boundingBox(feature.target);
    HeightMap map(grown(box, kBlockMm), kCellMm, feature.floor_z_mm - 1);
    map.raise(feature.target, feature.top_z_mm);
    map.raise(feature.obstruction, feature.top_z_mm);
    return map;
}

/// Runs all steps; rapids must hit nothing.
HeightMap machined(const Feature& feature, const ToolSequence& sequence, const ToolLibrary& library,
                   int seed) {
    HeightMap map = blockOf(feature);
    for (const SequenceStep& step : sequence.steps) {
        const double radius_mm = library.tool(step.tool_id).radius_mm();
        EXPECT_EQ(map.run(step.path, radius_mm, kRimMm).rapid_hits, 0)
            << "seed " << seed << " " << toString(step.role) << " " << step.tool_id;
    }
    return map;
}

void expectAllowanceKept(const Feature& feature, const ToolSequence& sequence, const ToolLibrary& library,
                         int seed) {
    ClearingTask bare;
    bare.target = feature.target;
    bare.obstruction = feature.obstruction;
    bare.top_z_mm = feature.top_z_mm;
    bare.retract_z_mm = 5;
    for (const SequenceStep& step : sequence.steps) {
        const PathProof proof = prove(step.path, bare, library.tool(step.tool_id).radius_mm(), kTol);
        EXPECT_GE(proof.least_clearance_mm, step.leaves.walls_mm - kTol.gouge_mm) << "seed " << seed;
        double lowest = 0;
        for (const Move& move : step.path.moves)
            lowest = std::min(lowest, move.to.z());
        EXPECT_NEAR(lowest, feature.floor_z_mm + step.leaves.floors_mm, 1e-9) << "seed " << seed;
    }
}

TEST(FinishingLaw, RoughingAndFinishingLeaveWhatThePlainSequenceLeaves) {
    int finished = 0;
    int refused = 0;
    for (int seed = 1; seed <= 60; ++seed) {
        std::mt19937 random(seed);
        const Feature feature = randomFeature(random);
        const ToolLibrary library = randomTools(random);
        SequenceOptions options = inAluminium();
        const ToolSequence plain = sequenceTools(feature, library, makeMachine(), options, kTol);
        options.finish = {std::uniform_real_distribution(0.1, 0.6)(random),
                          random() % 3 == 0 ? 0 : std::uniform_real_distribution(0.1, 0.5)(random)};
        const ToolSequence sequence = sequenceTools(feature, library, makeMachine(), options, kTol);
        if (sequence.steps.empty()) continue;
        const bool walls = std::any_of(sequence.steps.begin(), sequence.steps.end(),
                                       [](const SequenceStep& step) { return step.leaves.walls_mm > 0; });
        ++(walls ? finished : refused);
        if (!walls && feature.closed_length_mm > 1) fmt::print("seed {}: {}\n", seed, sequence.no_allowance);
        expectAllowanceKept(feature, sequence, library, seed);
        EXPECT_GE(sequence.time_s, sequence.lower_bound_s) << "seed " << seed;
        EXPECT_NEAR(residualVolumeMm3(sequence), residualVolumeMm3(plain), 1e-6) << "seed " << seed;

        const HeightMap with = machined(feature, sequence, library, seed);
        const HeightMap without = machined(feature, plain, library, seed);
        std::size_t differ = 0;
        for (std::size_t i = 0; i < with.heights().size(); ++i)
            if (std::abs(with.heights()[i] - without.heights()[i]) > 1e-6) ++differ;
        // Cells at walls alone: discs sampled at other places leave scallops of up to a tenth of a cell. An
        // allowance that stays would be a strip at least four times as wide.
        EXPECT_LE(static_cast<double>(differ) * kCellMm * kCellMm, kScallopMm * perimeter(feature.target))
            << "seed " << seed;
    }
    fmt::print("{} with an allowance on walls, {} without\n", finished, refused);
    EXPECT_GT(finished, 2 * refused);
}

}  // namespace
}  // namespace stepmill::test
