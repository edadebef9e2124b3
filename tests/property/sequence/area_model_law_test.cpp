#include <random>

#include <gtest/gtest.h>

#include "stepmill/sequence/advice/area_models.h"
#include "stepmill/sequence/advice/ranking.h"
#include "support/random_numbers.h"

namespace stepmill {
namespace {

using test::uniform;

/// Volumes mostly fall with the diameter, with plateaus; now and then a cutter is short and reaches less than
/// a wider one.
std::vector<AccessRow> randomTable(std::mt19937& random) {
    std::vector<AccessRow> rows;
    const int count = std::uniform_int_distribution(1, 12)(random);
    const bool nested = std::bernoulli_distribution(0.7)(random);
    double volume = uniform(random, 1, 1000);
    for (int i = 0; i < count; ++i) {
        const double diameter = std::uniform_int_distribution(1, 40)(random);
        rows.push_back({"", diameter, 0, diameter * diameter * uniform(random, 0.2, 2)});
    }
    std::sort(rows.begin(), rows.end(),
              [](const AccessRow& a, const AccessRow& b) { return a.diameter_mm < b.diameter_mm; });
    for (AccessRow& row : rows) {
        row.volume_cm3 = volume * (nested ? 1 : uniform(random, 0.5, 1));
        if (std::bernoulli_distribution(0.7)(random)) volume *= uniform(random, 0.5, 1);
    }
    std::shuffle(rows.begin(), rows.end(), random);
    return rows;
}

std::vector<AreaModelTool> randomModelTools(std::mt19937& random) {
    std::vector<AreaModelTool> tools;
    double area_mm2 = uniform(random, 1, 100);
    double radius_mm = 25;
    for (int i = std::uniform_int_distribution(1, 10)(random); i > 0; --i) {
        tools.push_back({radius_mm, area_mm2, 10 * area_mm2, radius_mm * uniform(random, 1, 20), 1});
        area_mm2 += std::bernoulli_distribution(0.8)(random) ? uniform(random, 0, 50) : 0;
        radius_mm *= uniform(random, 0.5, 0.95);
    }
    return tools;
}

/// The least over all subsets in falling diameter that end with full access.
double byEnumeration(const Ranking& ranking, double tool_change_min) {
    const int n = static_cast<int>(ranking.rows.size());
    double most = 0;
    for (const RankedRow& row : ranking.rows)
        most = std::max(most, row.cutter.volume_cm3);
    double least = std::numeric_limits<double>::infinity();
    for (unsigned subset = 1; subset < (1U << n); ++subset) {
        double sum = 0;
        double cleared = 0;
        bool rises = true;
        for (int i = n - 1; i >= 0; --i) {
            if ((subset >> i & 1U) == 0) continue;
            const AccessRow& cutter = ranking.rows[i].cutter;
            rises = rises && cutter.volume_cm3 > cleared;
            sum +=
                (cleared > 0 ? tool_change_min : 0) + (cutter.volume_cm3 - cleared) / cutter.mrr_cm3_per_min;
            cleared = cutter.volume_cm3;
        }
        if (rises && cleared >= most * (1 - kFullAccessShare)) least = std::min(least, sum);
    }
    return least;
}

TEST(RankingLaw, TheShortestPathIsNeverWorseThanTheRankingAndIsTheOptimum) {
    for (unsigned seed = 0; seed < 400; ++seed) {
        std::mt19937 random(seed);
        const std::vector<AccessRow> table = randomTable(random);
        for (const double change_s : {0.0, 1.0, 10.0, 300.0, uniform(random, 0, 1e4)}) {
            const Ranking ranking = rankTools(table, change_s);
            EXPECT_LE(ranking.shortest_path.total_min, ranking.greedy.total_min)
                << "seed " << seed << ", change " << change_s << " s";
            const double expected = byEnumeration(ranking, change_s / 60);
            EXPECT_NEAR(ranking.shortest_path.total_min, expected, 1e-9 * expected)
                << "seed " << seed << ", change " << change_s << " s";
        }
    }
}

TEST(RankingLaw, RanksAreWiderAndFasterOneAfterTheOther) {
    for (unsigned seed = 500; seed < 800; ++seed) {
        std::mt19937 random(seed);
        const Ranking ranking = rankTools(randomTable(random), 10);
        double last_rdvc = std::numeric_limits<double>::infinity();
        int next = 0;
        for (const RankedRow& row : ranking.rows) {
            if (row.rank) {
                EXPECT_EQ(*row.rank, next++) << "seed " << seed;
                EXPECT_LT(row.rdvc_min, last_rdvc) << "seed " << seed;
                last_rdvc = row.rdvc_min;
            }
            if (row.dvcd_min && !row.rank && next > 0) {
                EXPECT_GE(*row.dvcd_min, 0) << "seed " << seed;
            }
        }
        EXPECT_GT(next, 0) << "seed " << seed;
    }
}

TEST(AreaModelLaw, ALongerToolChangeNeverTakesMoreTools) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937 random(seed);
        const std::vector<AreaModelTool> tools = randomModelTools(random);
        std::size_t yao = tools.size();
        std::size_t lim = tools.size();
        for (const double change_s : {0.0, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 100.0, 1e4}) {
            const std::size_t yao_now = cheapestByYao(tools, {change_s, 1}).tools.size();
            const std::size_t lim_now = cheapestByLim(tools, change_s).tools.size();
            EXPECT_LE(yao_now, yao) << "seed " << seed << ", " << change_s << " s";
            EXPECT_LE(lim_now, lim) << "seed " << seed << ", " << change_s << " s";
            yao = yao_now;
            lim = lim_now;
        }
    }
}

}  // namespace
}  // namespace stepmill
