#include <map>
#include <random>

#include <gtest/gtest.h>

#include "plan/order/fewest_visits.h"

namespace stepmill::test {
namespace {

/// One to seven features in one or two setups, each with up to three operations by up to four tools, that
/// wait for what stands above them wholly or in part.
struct RandomVisits {
    std::vector<VisitOperation> operations;
    std::vector<VisitFeature> features;
};

RandomVisits randomVisits(std::mt19937& random) {
    const auto between = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
    RandomVisits made;
    const int features = between(1, 7);
    const int setups = between(1, 2);
    std::vector<int> count(features);
    for (int f = 0; f < features; ++f) {
        VisitFeature feature{f * setups / features, {}};
        for (int parent = 0; parent < f; ++parent)
            if (made.features[parent].setup == feature.setup && between(0, 2) == 0)
                feature.parents.push_back(parent);
        count[f] = between(0, 3);
        for (int i = 0; i < count[f]; ++i) {
            VisitOperation operation{between(0, 3), f, between(0, 2), {}};
            for (const int parent : feature.parents)
                if (between(0, 1) == 0) operation.needs.push_back({parent, between(0, count[parent])});
            made.operations.push_back(std::move(operation));
        }
        made.features.push_back(std::move(feature));
    }
    return made;
}

/// The fewest visits, by trying every operation that may come next.
class EveryOrder {
  public:
    explicit EveryOrder(const VisitProblem& problem) : problem_(problem) {}

    int fewest() { return after(std::vector<int>(problem_.queue.size(), 0), -1); }

  private:
    int after(const std::vector<int>& done, int tool) {
        const auto known = known_.find({done, tool});
        if (known != known_.end()) return known->second;
        int fewest = -1;
        for (const int next : readyOperations(problem_, done)) {
            std::vector<int> then = done;
            ++then[problem_.operations[next].feature];
            const int own = problem_.operations[next].tool;
            const int visits = after(then, own) + (own == tool ? 0 : 1);
            if (fewest < 0 || visits < fewest) fewest = visits;
        }
        return known_[{done, tool}] = std::max(0, fewest);
    }

    const VisitProblem& problem_;
    std::map<std::pair<std::vector<int>, int>, int> known_;
};

TEST(FewestVisitsLaw, AreThoseOfEveryOrderTried) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937 random(seed);
        const RandomVisits visits = randomVisits(random);
        const VisitProblem problem = visitProblem(visits.operations, visits.features);
        const int fewest = EveryOrder(problem).fewest();
        const FewestVisits found = fewestVisits(problem, kPlanSearch);
        EXPECT_EQ(static_cast<int>(found.tools.size()), fewest) << "seed " << seed;
        EXPECT_EQ(found.at_least, fewest) << "seed " << seed;
    }
}

TEST(FewestVisitsLaw, AreFoundWithinThemAndNotWithinFewer) {
    constexpr std::size_t kWide = 256;
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937 random(seed);
        const RandomVisits visits = randomVisits(random);
        const VisitProblem problem = visitProblem(visits.operations, visits.features);
        const int fewest = EveryOrder(problem).fewest();
        const int least = leastVisits(problem);
        EXPECT_LE(least, fewest) << "seed " << seed;
        EXPECT_EQ(visitsWithin(problem, fewest, 0, kWide), fewest) << "seed " << seed;
        EXPECT_EQ(visitsWithin(problem, fewest - 1, 0, kWide), std::nullopt) << "seed " << seed;
        EXPECT_EQ(visitsWithin(problem, fewest, fewest - least, kWide), fewest) << "seed " << seed;
        EXPECT_EQ(visitsWithin(problem, fewest, fewest - least + 1, kWide), std::nullopt) << "seed " << seed;
    }
}

TEST(FewestVisitsLaw, ANarrowSearchClaimsNoMoreThanItKnows) {
    int missed = 0;
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937 random(seed);
        const RandomVisits visits = randomVisits(random);
        const VisitProblem problem = visitProblem(visits.operations, visits.features);
        const int fewest = EveryOrder(problem).fewest();
        const FewestVisits found = fewestVisits(problem, {1, 0});
        EXPECT_LE(found.at_least, fewest) << "seed " << seed;
        EXPECT_GE(static_cast<int>(found.tools.size()), fewest) << "seed " << seed;
        missed += static_cast<int>(found.tools.size()) > fewest ? 1 : 0;
    }
    EXPECT_LT(missed, 50) << "of 500 by one partial order alone";
}

TEST(FewestVisitsLaw, TheVisitsDoEveryOperation) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937 random(seed);
        const RandomVisits visits = randomVisits(random);
        const VisitProblem problem = visitProblem(visits.operations, visits.features);
        std::vector<int> done(problem.queue.size(), 0);
        std::size_t taken = 0;
        for (const int tool : fewestVisits(problem, kPlanSearch).tools) {
            const std::vector<int> of_visit = takeAll(problem, tool, done);
            EXPECT_FALSE(of_visit.empty()) << "seed " << seed;
            taken += of_visit.size();
        }
        EXPECT_EQ(taken, visits.operations.size()) << "seed " << seed;
    }
}

}  // namespace
}  // namespace stepmill::test
