#include "plan/features/feature_planner.h"

#include <limits>
#include <mutex>
#include <set>

#include "plan/features/few_tools.h"
#include "plan/features/nests.h"
#include "plan/features/propose_depths.h"
#include "plan/features/propose_ground.h"
#include "plan/features/sized_holes.h"
#include "plan/operations/retract.h"
#include "plan/order/share_tools.h"
#include "stepmill/core/error.h"
#include "stepmill/core/parallel.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/plan/common_ground.h"
#include "stepmill/plan/deep_bands.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/plan/hold_stage.h"
#include "stepmill/plan/reduced_feature.h"
#include "stepmill/toolpath/adaptive_cutting.h"

namespace stepmill {
namespace {

Residual wholeAsResidual(const Feature& feature, StayReason reason, std::string advice) {
    Residual residual;
    residual.region = feature.target;
    residual.area_mm2 = feature.area_mm2;
    residual.volume_mm3 = feature.volume_mm3;
    residual.reason = std::move(reason);
    residual.advice = std::move(advice);
    return residual;
}

/// The feature's sequence, or the feature as a residual with the reason when its planning fails: one bad
/// pocket must not lose the plan.
ToolSequence sequenceOrResidual(const Feature& feature, std::string& failure,
                                const std::function<ToolSequence()>& work) {
    try {
        return work();
    } catch (const std::exception& error) {
        failure = error.what();
    }
    ToolSequence sequence;
    sequence.feature_id = feature.id;
    sequence.residual.push_back(
        wholeAsResidual(feature, {Reason::PlanningFailed, failure}, "a report of this part"));
    return sequence;
}

/// Does a caution ask for more than another pattern than that of constant engagement?
bool isMoreThanAPattern(const FeatureCaution& caution) {
    return caution.plain_ways || caution.dropped || !caution.without_tools.empty() || !caution.left.empty();
}

/// Together is taken where it weighs no more than this share: beside other features, which call tools anyway,
/// less would be no gain.
constexpr double kGroundPays = 0.995;
/// What the turns of a mill take off the walls of a bore at last, where there is no boring head [mm].
constexpr double kTurnedMm = 0.2;
/// So often ground is sought anew beside the ground that was found.
constexpr int kMostGroundRounds = 2;
/// So many ways to cut a level in parts are tried, those of most promise.
constexpr std::size_t kMostDepthTrials = 2;

/// Planned features that belong together, parents before children, with what went wrong.
struct PlannedNest {
    std::vector<PlannedFeature> features;
    std::vector<ReducedFeature> free;   ///< what of each was free to be cut
    std::vector<std::string> failures;  ///< of each; empty where it was planned
    std::vector<char> hasty;            ///< of each: were few tools weighed, or none, for want of time?

    bool failed() const {
        return std::any_of(failures.begin(), failures.end(),
                           [](const std::string& failure) { return !failure.empty(); });
    }
    bool isHasty() const { return std::find(hasty.begin(), hasty.end(), 1) != hasty.end(); }
    double residualMm3() const {
        double sum_mm3 = 0;
        for (const PlannedFeature& planned : features)
            sum_mm3 += residualVolumeMm3(planned.sequence);
        return sum_mm3;
    }
};

/// Seconds or money of a path with the change to its tool.
double weightOf(const PathTotals& path, const std::string& tool, const PlanningShop& shop) {
    return weightOf(edgeCost(path, shop.library.tool(tool), shop.machine), shop.request.sequence.objective);
}

/// Seconds or money of a tool change.
double changeWeight(const PlanningShop& shop) {
    return weightOf({}, shop.library.tools.front().id, shop);
}

/// Of all paths, without tool changes.
double pathsWeight(const PlannedNest& nest, const PlanningShop& shop) {
    double weight = 0;
    for (const PlannedFeature& planned : nest.features)
        for (const SequenceStep& step : planned.sequence.steps)
            weight += weightOf(step.path.totals, step.tool_id, shop) - changeWeight(shop);
    return weight;
}

/// Seconds or money of all paths and tool changes, with tools shared as the plan will share them.
double weightOf(const PlannedNest& nest, const PlanningShop& shop) {
    const double change = changeWeight(shop);
    std::set<std::string> own;
    std::vector<Precedence> precedences;
    std::vector<std::vector<SequenceChoice>> choices;
    for (const PlannedFeature& planned : nest.features) {
        Precedence precedence;
        precedence.feature_id = planned.feature.id;
        for (const std::string& parent : planned.feature.parents)
            if (own.count(parent) > 0) precedence.parents.push_back(parent);
        own.insert(planned.feature.id);
        precedences.push_back(std::move(precedence));
        choices.push_back(choicesOf(planned.sequence));
    }
    const SharedChoice shared = shareTools(precedences, choices, change, shop.library, 0);
    return pathsWeight(nest, shop) + shared.gain.visits_alone * change - shared.gain.saved;
}

/// What a nest may leave and weigh to be better than another.
struct NestLimit {
    double residual_mm3 = std::numeric_limits<double>::infinity();
    double weight = std::numeric_limits<double>::infinity();
};

/// Do the features so far leave more, or do their paths alone weigh more?
bool isBeyond(const PlannedNest& nest, const NestLimit& limit, const PlanningShop& shop) {
    return nest.residualMm3() > limit.residual_mm3 || pathsWeight(nest, shop) > limit.weight;
}

/// "S1.G2.1" of the ground that begins in S1.F2.1.
std::string groundIds(const Feature& first) {
    std::string id = first.id;
    id.replace(id.find(".F"), 2, ".G");
    return id;
}

/// Do tools find the same in both?
bool sameRoom(const Feature& a, const Feature& b) {
    const auto same = [](const Obstacle& one, const Obstacle& other) {
        return one.bottom_z_mm == other.bottom_z_mm && one.top_z_mm == other.top_z_mm &&
               feature::identical(one.section, other.section);
    };
    return a.top_z_mm == b.top_z_mm && a.floor_z_mm == b.floor_z_mm && a.through == b.through &&
           feature::identical(a.target, b.target) && feature::identical(a.obstruction, b.obstruction) &&
           std::equal(a.obstacles.begin(), a.obstacles.end(), b.obstacles.begin(), b.obstacles.end(), same);
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
                if (!nest.failures[k].empty())
                    result.warnings.push_back({"feature-failed", one.feature.id, nest.failures[k]});
                if (nest.hasty[k] != 0 && !one.sequence.steps.empty())
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
        const std::vector<DepthProposal> proposals = proposeDepths(
            best.features,
            {shop_.library, shop_.request.sequence.material, growth_, shop_.machine.tool_change_s}, ids,
            shop_.tol);
        for (std::size_t i = 0; i < std::min(proposals.size(), kMostDepthTrials); ++i)
            if (takeGrounds(proposals[i].grounds, best)) return true;
        return false;
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
        for (const Feature& feature : features) {
            ReducedFeature& free = nest.free.emplace_back();
            std::string& failure = nest.failures.emplace_back();
            char& hasty = nest.hasty.emplace_back(0);
            ToolSequence sequence = sequenceOrResidual(feature, failure, [&] {
                free = reduced(feature, by_id, setup_.fixtures, shop_.tol);
                const ToolSequence* same = sequenceIn(known, free);
                return same != nullptr ? *same : sequenceOf(free, feature, hasty);
            });
            nest.features.push_back({feature, std::move(sequence)});
            if (isBeyond(nest, limit, shop_)) break;
        }
        return nest;
    }

    /// The sequence of the same feature with the same room; null where there is none.
    static const ToolSequence* sequenceIn(const PlannedNest& known, const ReducedFeature& free) {
        for (std::size_t i = 0; i < known.features.size(); ++i) {
            const bool same = known.features[i].feature.id == free.feature.id && known.failures[i].empty() &&
                              known.free[i].blocked.empty() && free.blocked.empty() &&
                              sameRoom(known.free[i].feature, free.feature);
            if (same) return &known.features[i].sequence;
        }
        return nullptr;
    }

    ToolSequence sequenceOf(const ReducedFeature& free, const Feature& feature, char& hasty) const {
        ToolSequence sequence = sequenceOf(free.feature, feature, hasty);
        sequence.residual.insert(sequence.residual.end(), free.blocked.begin(), free.blocked.end());
        return sequence;
    }

    /// \param free  what of the feature is free to be cut
    ToolSequence sequenceOf(const Feature& free, const Feature& feature, char& hasty) const {
        const FeatureCaution& caution = shop_.cautionOf(feature.id);
        ToolSequence sequence;
        sequence.feature_id = feature.id;
        sequence.floor_z_mm = feature.floor_z_mm;
        if (free.target.empty()) return sequence;
        if (caution.dropped) {
            sequence.residual.push_back(
                wholeAsResidual(free, {Reason::NotProven, {}}, "a report of this part"));
            return sequence;
        }
        const HoleEntry* entry = shop_.wishes.entryOf(feature, setup_);
        if (entry != nullptr && entry->make == HoleMaking::Leave) {
            sequence.residual.push_back(wholeAsResidual(free, {Reason::AsAsked, {}}, "another hole table"));
            return sequence;
        }
        const bool drills = entry != nullptr && entry->make == HoleMaking::Drill;
        const ToolLibrary& library = drills ? shop_.drills : shop_.libraryOf(feature.id);
        const Feature grown = onGrownStock(free, growth_, shop_.tol);
        std::optional<ToolSequence> in_time = entry != nullptr && entry->fit
                                                  ? fittedInTime(grown, *entry, feature, hasty)
                                                  : sequenceInTime(grown, library, feature, hasty);
        if (!in_time) {
            sequence.residual.push_back(
                wholeAsResidual(free, {Reason::TimeLimit, {}}, "more time (--timeout), or fewer tools"));
            return sequence;
        }
        sequence = std::move(*in_time);
        sequence.residual = onNominalStock(std::move(sequence.residual), free, grown, shop_.tol);
        sequence.residual.insert(sequence.residual.end(), caution.left.begin(), caution.left.end());
        return sequence;
    }

    /// Brought to its fit where some tool can; as without the hole table where none can.
    std::optional<ToolSequence> fittedInTime(const Feature& grown, const HoleEntry& entry,
                                             const Feature& feature, char& hasty) const {
        const ToolLibrary& library = shop_.libraryOf(feature.id);
        const double retract_mm = retractMm(setup_, shop_.request.sequence.retract_mm, shop_.machine);
        SizedSequence sized;
        if (feature.band)
            sized.trouble = "the hole is cut in several bands";
        else if (isHole(grown.feature_class))
            sized = sizedSequence(grown, entry, shop_, library, retract_mm,
                                  [&](const Feature& holes, const ToolLibrary& tools) {
                                      return sequenceInTime(holes, tools, feature, hasty);
                                  });
        if (sized.sequence) return sized.sequence;
        std::optional<ToolSequence> made = sequenceInTime(grown, library, feature, hasty);
        if (!made) return made;
        if (entry.make == HoleMaking::Bore) {
            std::optional<ToolSequence> turned = turnedInTime(grown, library, feature, hasty);
            if (turned && residualVolumeMm3(*turned) <= residualVolumeMm3(*made) + kVolumeRoundingMm3)
                return turned;
        }
        made->not_sized = std::move(sized.trouble);
        return made;
    }

    /// With a mill's turns along the walls at last; nothing where none takes them.
    std::optional<ToolSequence> turnedInTime(Feature bores, const ToolLibrary& library,
                                             const Feature& feature, char& hasty) const {
        bores.drilled = DiameterRange{};  // a drill of their size would leave no wall to turn
        FinishAllowance finish = shop_.request.sequence.finish;
        finish.walls_mm = std::max(finish.walls_mm, kTurnedMm);
        std::optional<ToolSequence> made = sequenceInTime(bores, library, feature, hasty, finish);
        const auto turns = [](const SequenceStep& step) { return step.role == Role::Finish; };
        const bool turned = made && std::any_of(made->steps.begin(), made->steps.end(), turns);
        return turned ? std::move(made) : std::nullopt;
    }

    /// Of all tools, of a few where these take too long, or nothing where the few do too.
    std::optional<ToolSequence> sequenceInTime(const Feature& grown, const ToolLibrary& library,
                                               const Feature& feature, char& hasty,
                                               std::optional<FinishAllowance> finish = std::nullopt) const {
        SequenceOptions options = sequenceOptions(feature);
        if (finish) options.finish = *finish;
        options.deadline = shop_.request.patience.allToolsOfOne();
        if (auto sequence = sequenceBefore(grown, library, options)) return sequence;
        hasty = 1;
        options.surrogates = SurrogateRule::SingleOrLater;
        options.deadline = shop_.request.patience.fewToolsOfOne();
        auto sequence = sequenceBefore(grown, fewTools(library, options.material), options);
        // Nothing is known of what the other tools could do.
        if (sequence) {
            sequence->lower_bound_s = 0;
            sequence->least = {};
        }
        return sequence;
    }

    /// Nothing where the deadline passes.
    std::optional<ToolSequence> sequenceBefore(const Feature& grown, const ToolLibrary& library,
                                               const SequenceOptions& options) const {
        try {
            return shop_.memory.sequence(grown, library, options, [&] {
                options.deadline.check(grown.id);
                return sequenceTools(grown, library, shop_.machine, options, shop_.tol);
            });
        } catch (const Error& error) {
            if (error.code() != ErrorCode::TimedOut) throw;
            return std::nullopt;
        }
    }

    SequenceOptions sequenceOptions(const Feature& feature) const {
        SequenceOptions options = asPlanned(shop_.request.sequence);
        if (feature.band && feature.band->isUpper()) options.finish.floors_mm = 0;
        const FeatureCaution& caution = shop_.cautionOf(feature.id);
        if (caution.not_adaptive) options.patterns = notAdaptive(std::move(options.patterns));
        if (caution.plain_ways) options.pattern = Pattern::ContourInsideOut;
        options.retract_mm = retractMm(setup_, shop_.request.sequence.retract_mm, shop_.machine);
        const auto wish = shop_.request.wishes.find(feature.id);
        if (wish != shop_.request.wishes.end()) options.first_at_least_mm = wish->second.first_at_least_mm;
        return options;
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

SmallerLibraries smallerLibraries(const PlanRequest& request, const ToolLibrary& library) {
    std::map<std::string, std::set<std::string>> withheld;
    for (const auto& [feature, caution] : request.cautions)
        withheld[feature].insert(caution.without_tools.begin(), caution.without_tools.end());
    for (const auto& [feature, wish] : request.wishes)
        withheld[feature].insert(wish.without_tools.begin(), wish.without_tools.end());
    SmallerLibraries smaller;
    for (const auto& entry : withheld) {
        if (entry.second.empty()) continue;
        ToolLibrary left = library;
        std::erase_if(left.tools, [&](const ToolAssembly& tool) { return entry.second.count(tool.id) > 0; });
        smaller.emplace(entry.first, std::move(left));
    }
    return smaller;
}

const ToolLibrary& PlanningShop::libraryOf(const std::string& feature) const {
    const auto found = smaller.find(feature);
    return found != smaller.end() ? found->second : library;
}

const FeatureCaution& PlanningShop::cautionOf(const std::string& feature) const {
    static const FeatureCaution kNone;
    const auto found = request.cautions.find(feature);
    return found != request.cautions.end() ? found->second : kNone;
}

PlannedFeatures planFeatures(std::vector<Feature> features, const Setup& setup, const PlanningShop& shop,
                             const Progress& progress) {
    return FeaturePlanner(std::move(features), setup, shop, progress).plan();
}

}  // namespace stepmill
