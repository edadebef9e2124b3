#include <random>

#include <gtest/gtest.h>

#include "plan/order/share_tools.h"

namespace stepmill::test {
namespace {

struct Shop {
    std::vector<Precedence> features;  ///< ids and parents
    std::vector<std::vector<SequenceChoice>> choices;
    double change = 0;
};

int between(std::mt19937& random, int from, int to) {
    return std::uniform_int_distribution(from, to)(random);
}

/// Features with some parents, each with one to `most` sequences of one to three of five tools.
Shop randomShop(std::mt19937& random, int features, int most) {
    Shop shop;
    shop.change = between(random, 1, 10);
    for (int f = 0; f < features; ++f) {
        Precedence feature;
        feature.feature_id = "S1.F" + std::to_string(f + 1);
        if (f > 0 && std::bernoulli_distribution(0.4)(random))
            feature.parents.push_back(shop.features[between(random, 0, f - 1)].feature_id);
        shop.features.push_back(feature);
        std::vector<SequenceChoice> choices(between(random, 1, most));
        for (SequenceChoice& choice : choices) {
            std::vector<std::string> tools{"A", "B", "C", "D", "E"};
            std::shuffle(tools.begin(), tools.end(), random);
            choice.tools.assign(tools.begin(), tools.begin() + between(random, 1, 3));
            choice.paths = between(random, 5, 40);
        }
        // Its own cheapest comes first.
        const auto alone = [&](const SequenceChoice& c) {
            return c.paths + shop.change * static_cast<double>(c.tools.size());
        };
        std::sort(choices.begin(), choices.end(),
                  [&](const auto& a, const auto& b) { return alone(a) < alone(b); });
        shop.choices.push_back(std::move(choices));
    }
    return shop;
}

/// The fewest tool changes for one choice a feature, by trying every order of visits.
class FewestVisits {
  public:
    FewestVisits(const Shop& shop, const std::vector<std::size_t>& choice) : shop_(shop), choice_(choice) {}

    int find() { return from(std::vector<std::size_t>(shop_.features.size(), 0)); }

  private:
    const std::vector<std::string>& toolsOf(std::size_t f) const {
        return shop_.choices[f][choice_[f]].tools;
    }

    bool isReady(const std::vector<std::size_t>& done, std::size_t f) const {
        if (done[f] == toolsOf(f).size()) return false;
        for (const std::string& parent : shop_.features[f].parents)
            for (std::size_t p = 0; p < shop_.features.size(); ++p)
                if (shop_.features[p].feature_id == parent && done[p] < toolsOf(p).size()) return false;
        return true;
    }

    int from(const std::vector<std::size_t>& done) {
        const auto known = known_.find(done);
        if (known != known_.end()) return known->second;
        int fewest = 0;
        for (const char* tool : {"A", "B", "C", "D", "E"}) {
            std::vector<std::size_t> after = done;
            for (bool again = true; again;) {
                again = false;
                for (std::size_t f = 0; f < after.size(); ++f) {
                    if (!isReady(after, f) || toolsOf(f)[after[f]] != tool) continue;
                    ++after[f];
                    again = true;
                }
            }
            if (after == done) continue;
            const int visits = 1 + from(after);
            if (fewest == 0 || visits < fewest) fewest = visits;
        }
        return known_[done] = fewest;
    }

    const Shop& shop_;
    const std::vector<std::size_t>& choice_;
    std::map<std::vector<std::size_t>, int> known_;
};

double weightOf(const Shop& shop, const std::vector<std::size_t>& choice) {
    double weight = shop.change * FewestVisits(shop, choice).find();
    for (std::size_t f = 0; f < choice.size(); ++f)
        weight += shop.choices[f][choice[f]].paths;
    return weight;
}

bool next(const Shop& shop, std::vector<std::size_t>& choice) {
    for (std::size_t f = 0; f < choice.size(); ++f) {
        if (++choice[f] < shop.choices[f].size()) return true;
        choice[f] = 0;
    }
    return false;
}

int toolsIn(const Shop& shop, const std::vector<std::size_t>& choice) {
    std::set<std::string> tools;
    for (std::size_t f = 0; f < choice.size(); ++f)
        tools.insert(shop.choices[f][choice[f]].tools.begin(), shop.choices[f][choice[f]].tools.end());
    return static_cast<int>(tools.size());
}

TEST(ShareToolsLaw, IsAsGoodAsTheBestOfAllCombinations) {
    int gained = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        const Shop shop = randomShop(random, between(random, 2, 4), 4);
        const SharedChoice shared = shareTools(shop.features, shop.choices, shop.change, {}, 0);
        std::vector<std::size_t> choice(shop.features.size(), 0);
        double least = weightOf(shop, choice);
        while (next(shop, choice))
            least = std::min(least, weightOf(shop, choice));
        EXPECT_NEAR(weightOf(shop, shared.choice), least, 1e-9) << "seed " << seed;
        gained += shared.gain.saved > 0 ? 1 : 0;
    }
    EXPECT_GE(gained, 10) << "the shops should have something to share";
}

TEST(ShareToolsLaw, IsNeverWorseThanEachFeaturesOwnCheapest) {
    double saved = 0;
    for (unsigned seed = 100; seed < 130; ++seed) {
        std::mt19937 random(seed);
        const Shop shop = randomShop(random, 9, 5);
        const SharedChoice shared = shareTools(shop.features, shop.choices, shop.change, {}, 0);
        const std::vector<std::size_t> own(shop.features.size(), 0);
        EXPECT_GE(shared.gain.saved, 0) << "seed " << seed;
        EXPECT_LE(weightOf(shop, shared.choice), weightOf(shop, own) + 1e-9) << "seed " << seed;
        saved += shared.gain.saved;
    }
    EXPECT_GT(saved, 0);
}

TEST(ShareToolsLaw, KeepsToTheMagazineWhereSomeCombinationDoes) {
    for (unsigned seed = 200; seed < 240; ++seed) {
        std::mt19937 random(seed);
        const Shop shop = randomShop(random, 3, 5);
        const int places = between(random, 1, 4);
        const SharedChoice shared = shareTools(shop.features, shop.choices, shop.change, {}, places);
        std::vector<std::size_t> choice(shop.features.size(), 0);
        int fewest = toolsIn(shop, choice);
        while (next(shop, choice))
            fewest = std::min(fewest, toolsIn(shop, choice));
        if (fewest <= places) {
            EXPECT_LE(shared.gain.tools, places) << "seed " << seed;
        } else {  // tools are changed by hand anyway
            EXPECT_EQ(shared.choice, shareTools(shop.features, shop.choices, shop.change, {}, 0).choice)
                << "seed " << seed;
        }
        EXPECT_EQ(shared.gain.tools, toolsIn(shop, shared.choice)) << "seed " << seed;
    }
}

}  // namespace
}  // namespace stepmill::test
