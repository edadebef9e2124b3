#include <random>
#include <set>

#include <gtest/gtest.h>

#include "sequence/surrogates/lump_ways.h"

namespace stepmill {
namespace {

using LumpsWays = std::vector<std::vector<LumpWay>>;

LumpsWays randomLumps(std::mt19937& random) {
    const auto number = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
    LumpsWays lumps(number(1, 4));
    for (std::vector<LumpWay>& ways : lumps) {
        for (int i = number(1, 5); i > 0; --i) {
            std::set<int> tools;
            while (static_cast<int>(tools.size()) < number(1, 3))
                tools.insert(number(0, 6));
            ways.push_back({{tools.begin(), tools.end()}, static_cast<double>(number(0, 12))});
        }
    }
    return lumps;
}

/// Every combination of ways, every change counted where tools really change.
double leastByEnumeration(const LumpsWays& lumps, double change, int next) {
    double least = kNoEdge;
    std::vector<std::size_t> choice(lumps.size(), 0);
    for (;;) {
        double sum = 0;
        std::set<int> tools;
        bool next_last = true;
        for (std::size_t i = 0; i < lumps.size(); ++i) {
            const LumpWay& way = lumps[i][choice[i]];
            sum += way.weight;
            tools.insert(way.tools.begin(), way.tools.end());
            for (std::size_t k = 0; k + 1 < way.tools.size(); ++k)
                next_last = next_last && way.tools[k] != next;
        }
        const bool joins = next_last && tools.count(next) > 0;
        least = std::min(least, sum + change * static_cast<double>(tools.size() - (joins ? 1 : 0)));
        std::size_t i = 0;
        while (i < lumps.size() && ++choice[i] == lumps[i].size())
            choice[i++] = 0;
        if (i == lumps.size()) return least;
    }
}

TEST(LumpWaysLaw, AreAsCheapAsTheBestOfAllCombinations) {
    for (unsigned seed = 0; seed < 2000; ++seed) {
        std::mt19937 random(seed);
        const LumpsWays lumps = randomLumps(random);
        const double change = std::uniform_int_distribution(0, 8)(random);
        for (const int next : {kNoTool, 0, 3, 6}) {
            const ChosenWays found = cheapestWays(lumps, change, next);
            ASSERT_EQ(found.weight, leastByEnumeration(lumps, change, next))
                << "seed " << seed << ", next " << next;
            ASSERT_EQ(found.ways.size(), lumps.size());
        }
    }
}

TEST(LumpWaysLaw, ALumpWithoutAWayHasNoWeight) {
    EXPECT_EQ(cheapestWays({{{{1}, 2.0}}, {}}, 5).weight, kNoEdge);
    EXPECT_EQ(cheapestWays({}, 5).weight, 0);
}

}  // namespace
}  // namespace stepmill
