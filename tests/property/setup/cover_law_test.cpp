// The search for setups against all subsets of small random instances.

#include <gtest/gtest.h>

#include <random>

#include "setup/cover.h"

using namespace stepmill::setup;

namespace {

double worthOf(const std::vector<SampleGroup>& groups, const std::vector<double>& bonus, unsigned set) {
    double worth = 0;
    for (std::size_t axis = 0; axis < bonus.size(); ++axis)
        if ((set >> axis & 1U) != 0) worth += bonus[axis] - 1;
    for (const SampleGroup& group : groups) {
        Reach best = Reach::None;
        for (std::size_t axis = 0; axis < bonus.size(); ++axis)
            if ((set >> axis & 1U) != 0) best = std::max(best, group.reach[axis]);
        if (best != Reach::None) worth += group.volume_share / kSetupPaysShare + group.faces / kSetupPaysFace;
        if (best == Reach::Finished) worth += group.ruled_share / kFinishPaysShare;
    }
    return worth;
}

struct Instance {
    std::vector<SampleGroup> groups;
    std::vector<double> bonus;
};

/// Groups of about what pays for a setup, so that the choice is a close one; a third of the axes is indexed.
Instance randomInstance(std::mt19937& random, unsigned axes, std::size_t groups) {
    const auto share = [&] { return std::generate_canonical<double, 32>(random); };
    Instance made;
    made.groups.resize(groups);
    for (SampleGroup& group : made.groups) {
        for (unsigned axis = 0; axis < axes; ++axis)
            group.reach.push_back(static_cast<Reach>(random() % 3));
        group.volume_share = share() * kSetupPaysShare;
        group.faces = share() * kSetupPaysFace / 2;
        group.ruled_share = share() * kFinishPaysShare;
    }
    for (unsigned axis = 0; axis < axes; ++axis)
        made.bonus.push_back(random() % 3 == 0 ? -3 * share() : 0.01 * share());
    return made;
}

}  // namespace

TEST(BestAxesLaw, NoSubsetIsWorthMore) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const Instance made = randomInstance(random, 2 + random() % 7, 1 + random() % 12);
        unsigned found = 0;
        for (const int axis : bestAxes(made.groups, made.bonus))
            found |= 1U << axis;
        double best = 0;
        for (unsigned set = 0; set < 1U << made.bonus.size(); ++set)
            best = std::max(best, worthOf(made.groups, made.bonus, set));
        EXPECT_NEAR(worthOf(made.groups, made.bonus, found), best, 1e-8);
    }
}

TEST(BestAxesLaw, NoSingleExchangeHelpsWhereTheSearchEndsEarly) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        constexpr unsigned kAxes = 30;
        const Instance made = randomInstance(random, kAxes, 400);
        unsigned found = 0;
        for (const int axis : bestAxes(made.groups, made.bonus))
            found |= 1U << axis;
        const double worth = worthOf(made.groups, made.bonus, found);
        for (unsigned one = 0; one < kAxes; ++one)
            for (unsigned other = 0; other <= one; ++other) {
                const unsigned changed = found ^ (1U << one) ^ (other == one ? 0U : 1U << other);
                const bool exchange = other == one || ((found >> one ^ found >> other) & 1U) != 0;
                if (exchange) {
                    EXPECT_LE(worthOf(made.groups, made.bonus, changed), worth + 1e-8);
                }
            }
    }
}
