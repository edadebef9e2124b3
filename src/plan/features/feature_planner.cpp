#include "plan/features/feature_planner.h"

#include <algorithm>
#include <mutex>

#include "plan/features/nests.h"
#include "plan/features/planned_nest.h"
#include "plan/features/propose_depths.h"
#include "plan/features/propose_ground.h"
#include "stepmill/core/error.h"
#include "stepmill/core/parallel.h"
#include "stepmill/plan/common_ground.h"
#include "stepmill/plan/grown_feature.h"

namespace stepmill {
namespace {

/// Does a caution ask for more than another pattern than that of constant engagement?
bool isMoreThanAPattern(const FeatureCaution& caution) {
    return caution.plain_ways || caution.dropped || !caution.without_tools.empty() || !caution.left.empty();
}

/// Together is taken where it weighs no more than this share: beside other features, which call tools anyway,
/// less would be no gain.
constexpr double kGroundPays = 0.995;
/// So often ground is sought anew beside the ground that was found.
constexpr int kMostGroundRounds = 2;

/// "S1.G2.1" of the ground that begins in S1.F2.1.
std::string groundIds(const Feature& first) {
    std::string id = first.id;
    id.replace(id.find(".F"), 2, ".G");
    return id;
}

/// Plans the features of a setup nest by nest: one has to know what those above it leave.
class FeaturePlanner {
  public:
    FeaturePlanner(std::vector<Feature>&& features, const Setup& setup, const PlanningShop& shop,
                   const Progress& progress)
        : features_(std::move(features)),
          setup_(setup),
          shop_(shop),
          growth_(growthOf(setup.stock, setup.part_to_setup)),
          progress_(progress) {}

    PlannedFeatures plan() {
        const std::vector<Nest> nests = nestsOf(features_);
        std::vector<PlannedNest> planned(nests.size());
        for (const std::vector<std::size_t>& generation : generationsOf(nests, features_)) {
            parallelFor(generation.size(),
                        [&](std::size_t i) { planned[generation[i]] = planNest(nests[generation[i]]); });
            for (const std::size_t nest : generation)
                publish(nests[nest], planned[nest]);
        }
        return inOrder(nests, std::move(planned));
    }

  private:
    void reportStart(const std::string& id) {
        const std::lock_guard lock(progress_mutex_);
        const double done = static_cast<double>(started_++) / static_cast<double>(features_.size());
        if (progress_) progress_(id, std::min(1.0, done));
    }

    /// What later generations ask of a nest.
    void publish(const Nest& nest, const PlannedNest& planned) {
        for (const PlannedFeature& feature : planned.features)
            known_[feature.feature.id] = &feature;
        std::vector<std::string> kept;
        for (const std::size_t i : nest) {
            const std::string& id = features_[i].id;
            if (known_.count(id) > 0)
                kept.push_back(id);
            else
                stands_in_[id] = standInFor(id, kept, planned);
        }
    }

    /// What the children of a level wait for that common ground took whole: the level above, if that has some
    /// of the ground too, else the ground.
    /// \param kept  levels above that are still there
    static std::string standInFor(const std::string& id, const std::vector<std::string>& kept,
                                  const PlannedNest& planned) {
        const auto has = [](const PlannedFeature& ground, const std::string& level) {
            const std::vector<std::string>& levels = ground.feature.ground_of;
            return std::find(levels.begin(), levels.end(), level) != levels.end();
        };
        const auto ground = std::find_if(planned.features.rbegin(), planned.features.rend(),
                                         [&](const PlannedFeature& one) { return has(one, id); });
        STEPMILL_CHECK(ground != planned.features.rend(), "only common ground takes a level");
        return !kept.empty() && has(*ground, kept.back()) ? kept.back() : ground->feature.id;
    }

    /// The features in the order they came in, each ground before the first of its levels.
    PlannedFeatures inOrder(const std::vector<Nest>& nests, std::vector<PlannedNest> planned) const {
        std::vector<std::size_t> nest_of(features_.size());
        for (std::size_t n = 0; n < nests.size(); ++n)
            for (const std::size_t i : nests[n])
                nest_of[i] = n;
        PlannedFeatures result;
        std::vector<std::size_t> next(nests.size(), 0);
        for (std::size_t i = 0; i < features_.size(); ++i) {
            PlannedNest& nest = planned[nest_of[i]];
            for (std::size_t& k = next[nest_of[i]]; k < nest.features.size(); ++k) {
                PlannedFeature& one = nest.features[k];
                const bool itself = one.feature.id == features_[i].id;
                if (!itself && one.feature.ground_of.empty()) break;
                const PlannedNest::Making& making = nest.makings[k];
                if (!making.failure.empty())
                    result.warnings.push_back({"feature-failed", one.feature.id, making.failure});
                if (making.hasty && !one.sequence.steps.empty())
                    result.warnings.push_back(
                        {"few-tools", one.feature.id,
                         "few tools were weighed: all of them take longer than --timeout allows"});
                result.features.push_back(std::move(one));
                if (itself) {
                    ++k;
                    break;
                }
            }
        }
        return result;
    }

    /// The levels one after another, or cut together, or a level in parts, where that is quicker and leaves
    /// no more.
    PlannedNest planNest(const Nest& nest) {
        std::vector<Feature> levels;
        for (const std::size_t i : nest) {
            reportStart(features_[i].id);
            levels.push_back(belowGround(features_[i]));
        }
        PlannedNest best = planAll(levels, {}, {});
        if (!mayTakeGround(levels) || best.failed() || best.isHasty()) return best;
        const std::string ids = groundIds(levels.front());
        for (int round = 0; round < kMostGroundRounds && levels.size() > 1; ++round)
            if (!shareMoreGround(ids, best)) break;
        for (int round = 0; round < kMostGroundRounds && !isAskedFor(levels); ++round)
            if (!cutInParts(ids, best)) break;
        return best;
    }

    /// Takes common ground out of the nest where it is quicker so and leaves no more.
    bool shareMoreGround(const std::string& ids, PlannedNest& best) const {
        std::vector<CommonGround> grounds =
            proposeGround(best.features, shop_.library, shop_.request.sequence.material, ids, shop_.tol);
        // All of them, or the one that promises most: every trial takes as long as the nest itself.
        if (grounds.empty()) return false;
        if (takeGrounds(grounds, best)) return true;
        if (grounds.size() == 1) return false;
        grounds.resize(1);
        return takeGrounds(grounds, best);
    }

    /// Parts one deep level of the nest where stiff mills that do not get down to its floor pay above it.
    bool cutInParts(const std::string& ids, PlannedNest& best) const {
        const DepthPlanning from{shop_.library, shop_.request.sequence.material, growth_,
                                 shop_.machine.tool_change_s};
        const std::vector<CommonGround> grounds = proposeDepths(best.features, from, ids, shop_.tol);
        return !grounds.empty() && takeGrounds(grounds, best);
    }

    /// Is a hole table asked how to make some of it? Such holes stay whole.
    bool isAskedFor(const std::vector<Feature>& levels) const {
        return std::any_of(levels.begin(), levels.end(), [&](const Feature& level) {
            return shop_.wishes.entryOf(level, setup_) != nullptr;
        });
    }

    /// The nest with these grounds taken out of it, where that is quicker and leaves no more; else it stays.
    bool takeGrounds(const std::vector<CommonGround>& grounds, PlannedNest& best) const {
        if (shop_.request.patience.all_tools.passed()) return false;
        const NestLimit limit{best.residualMm3() + kVolumeRoundingMm3, kGroundPays * weightOf(best, shop_)};
        std::vector<Feature> features;
        for (const PlannedFeature& planned : best.features)
            features.push_back(planned.feature);
        for (const CommonGround& ground : grounds)
            if (isCommonGround(features, ground, shop_.tol))
                features = withCommonGround(std::move(features), ground, shop_.tol);
        PlannedNest together = planAll(features, best, limit);
        const bool is_whole = together.features.size() == features.size();
        if (!is_whole || together.failed() || together.isHasty()) return false;
        if (isBeyond(together, limit, shop_) || weightOf(together, shop_) > limit.weight) return false;
        best = std::move(together);
        return true;
    }

    bool mayTakeGround(const std::vector<Feature>& levels) const {
        const PlanRequest& request = shop_.request;
        if (!request.common_ground || request.sequence.finish.any()) return false;
        const std::string grounds = groundIds(levels.front()) + ".";
        return std::none_of(request.cautions.begin(), request.cautions.end(), [&](const auto& caution) {
            if (!isMoreThanAPattern(caution.second)) return false;
            return caution.first.starts_with(grounds) ||
                   std::any_of(levels.begin(), levels.end(),
                               [&](const Feature& level) { return level.id == caution.first; });
        });
    }

    /// The feature with what stands in for parents that are gone.
    Feature belowGround(Feature feature) const {
        std::vector<std::string> parents;
        for (const std::string& parent : feature.parents) {
            const auto gone = stands_in_.find(parent);
            const std::string& id = gone == stands_in_.end() ? parent : gone->second;
            if (std::find(parents.begin(), parents.end(), id) == parents.end()) parents.push_back(id);
        }
        feature.parents = std::move(parents);
        return feature;
    }

    /// \param features  parents before children
    /// \param known     features of it that find the same room keep their sequences
    /// \return  fewer features where those are beyond the limit already
    PlannedNest planAll(const std::vector<Feature>& features, const PlannedNest& known,
                        const NestLimit& limit) const {
        PlannedNest nest;
        nest.features.reserve(features.size());
        const CutById by_id = [&](const std::string& id) {
            for (const PlannedFeature& planned : nest.features)
                if (planned.feature.id == id) return asCut(planned);
            return asCut(*known_.at(id));
        };
        const KnownSequence as_known = [&](const ReducedFeature& free) { return known.sequenceIn(free); };
        for (const Feature& feature : features) {
            nest.add(feature, sequenceFeature(feature, by_id, as_known, setup_, growth_, shop_));
            if (isBeyond(nest, limit, shop_)) break;
        }
        return nest;
    }

    std::vector<Feature> features_;
    const Setup& setup_;
    const PlanningShop& shop_;
    const StockGrowth growth_;
    const Progress& progress_;
    std::map<std::string, const PlannedFeature*> known_;  ///< of earlier generations, by id
    std::map<std::string, std::string> stands_in_;        ///< by the id of a level that is gone
    std::mutex progress_mutex_;
    std::size_t started_ = 0;
};

}  // namespace

PlannedFeatures planFeatures(std::vector<Feature> features, const Setup& setup, const PlanningShop& shop,
                             const Progress& progress) {
    return FeaturePlanner(std::move(features), setup, shop, progress).plan();
}

}  // namespace stepmill
