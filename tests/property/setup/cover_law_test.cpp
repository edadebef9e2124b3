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

}  // namespace

TEST(BestAxesLaw, NoSubsetIsWorthMore) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const auto share = [&] { return std::generate_canonical<double, 32>(random); };
        const unsigned axes = 2 + random() % 7;
        std::vector<SampleGroup> groups(1 + random() % 12);
        for (SampleGroup& group : groups) {
            for (unsigned axis = 0; axis < axes; ++axis)
                group.reach.push_back(static_cast<Reach>(random() % 3));
            // About what pays for a setup, so that the choice is a close one.
            group.volume_share = share() * kSetupPaysShare;
            group.faces = share() * kSetupPaysFace / 2;
            group.ruled_share = share() * kFinishPaysShare;
        }
        std::vector<double> bonus(axes);
        for (double& value : bonus)
            value = 0.01 * share();
        unsigned found = 0;
        for (const int axis : bestAxes(groups, bonus))
            found |= 1U << axis;
        double best = 0;
        for (unsigned set = 0; set < 1U << axes; ++set)
            best = std::max(best, worthOf(groups, bonus, set));
        EXPECT_NEAR(worthOf(groups, bonus, found), best, 1e-8);
    }
}
