#pragma once

#include <random>
#include <set>

#include "support/random_numbers.h"
#include "support/sample_feature.h"

namespace stepmill::test {

/// A closed pocket, some with an island, with one to three bosses beside it higher than its top.
inline Feature randomBossedPocket(std::mt19937& random) {
    const Tolerances tol;
    const double width = uniform(random, 40, 90);
    const double height = uniform(random, 30, 70);
    Region target = makeRoundedRectangle(Vec2(0, 0), Vec2(width, height), uniform(random, 1.5, 6));
    if (std::bernoulli_distribution(0.4)(random)) {
        const Vec2 centre(width * uniform(random, 0.35, 0.65), height * uniform(random, 0.35, 0.65));
        target = subtract(target, makeCircle(centre, uniform(random, 3, 8)), tol);
    }
    Feature pocket = makePocket(target, uniform(random, 4, 10));
    const Region wall = subtract(pocket.obstruction, offset(target, uniform(random, 0.5, 4), tol), tol);
    std::vector<Region> bosses;
    for (int i = std::uniform_int_distribution(1, 3)(random); i > 0; --i) {
        const Vec2 at(uniform(random, -10, width + 10), uniform(random, -10, height + 10));
        bosses.push_back(intersect(makeCircle(at, uniform(random, 6, 16)), wall, tol));
    }
    // The bosses end at the stock's top, z = 0.
    const double boss_mm = uniform(random, 5, 30);
    pocket.top_z_mm -= boss_mm;
    pocket.floor_z_mm -= boss_mm;
    pocket.obstacles = {{pocket.floor_z_mm, pocket.top_z_mm, pocket.obstruction},
                        {pocket.top_z_mm, 0, unite(bosses, tol)}};
    return pocket;
}

/// One to five end mills of different diameters, most in holders that may be in the way.
inline ToolLibrary randomHeldTools(std::mt19937& random, int most = 5) {
    std::vector<ToolAssembly> tools;
    const int count = std::uniform_int_distribution(1, most)(random);
    std::set<int> diameters;
    while (static_cast<int>(diameters.size()) < count)
        diameters.insert(std::uniform_int_distribution(3, 20)(random));
    for (const int diameter : diameters) {
        ToolAssembly tool = makeMill(diameter, uniform(random, 300, 3000), uniform(random, 1, 8));
        tool.price = uniform(random, 0, 200);
        tool.life_min = uniform(random, 5, 100);
        if (std::bernoulli_distribution(0.8)(random)) {
            tool.stick_out_mm = uniform(random, 11, 35);
            tool.holder.push_back(
                {diameter + uniform(random, 4, 40), tool.stick_out_mm, tool.stick_out_mm + 20});
        }
        tools.push_back(tool);
    }
    return makeLibrary(tools);
}

inline SequenceOptions randomOptions(unsigned seed) {
    SequenceOptions options = inAluminium(seed % 2 == 0 ? Objective::Time : Objective::Cost);
    constexpr std::array kRules{SurrogateRule::Single, SurrogateRule::SingleOrLater, SurrogateRule::Sequence};
    options.surrogates = kRules[seed % kRules.size()];
    return options;
}

}  // namespace stepmill::test
