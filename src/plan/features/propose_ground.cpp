#include "plan/features/propose_ground.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "plan/features/level_times.h"
#include "stepmill/access/collision.h"
#include "stepmill/access/slivers.h"
#include "stepmill/feature/heights.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// So many grounds of one nest are tried.
constexpr std::size_t kMostGrounds = 4;
/// Gains below this are within the error of the estimate [s], [share of what the levels take].
constexpr double kLeastGroundGainS = 1;
constexpr double kLeastGroundGainShare = 0.05;

/// What one tool could cut through levels `from` to `to`.
struct Proposal {
    std::size_t from = 0;
    std::size_t to = 0;
    Region region;
    double gain_s = 0;
};

class GroundSearch {
  public:
    GroundSearch(const std::vector<PlannedFeature>& nest, const ToolLibrary& library,
                 const std::string& material, const Tolerances& tol)
        : library_(library), material_(material), tol_(tol) {
        for (const PlannedFeature& planned : nest) {
            if (planned.feature.ground_of.empty()) {
                levels_.push_back(&planned);
                times_.emplace_back(planned, tol);
            }
            for (const SequenceStep& step : planned.sequence.steps)
                all_s_ += step.path.totals.motion_time_s;
        }
    }

    const Feature& level(std::size_t i) const { return levels_[i]->feature; }

    std::vector<Proposal> run() {
        while (taken_.size() < kMostGrounds) {
            std::optional<Proposal> best = mostGain();
            if (!best) break;
            taken_.push_back(std::move(*best));
        }
        return std::move(taken_);
    }

  private:
    std::optional<Proposal> mostGain() const {
        std::optional<Proposal> best;
        for (const ToolAssembly& tool : library_.tools) {
            const CuttingData* cutting = tool.cuttingFor(material_);
            if (tool.isForHoles() || cutting == nullptr) continue;
            for (std::size_t to = 1; to < levels_.size(); ++to)
                consider(tool, *cutting, to, best);
        }
        return best;
    }

    void consider(const ToolAssembly& tool, const CuttingData& cutting, std::size_t to,
                  std::optional<Proposal>& best) const {
        const CutterArea* own = ownArea(tool, to);
        const Region region = own != nullptr ? notTaken(*own, to) : Region{};
        if (region.empty()) return;
        const double layer_s = area(region) * secondsPerMm2(*levels_[to], tool, cutting, *own);
        double replaced_s = times_[to].secondsOver(region);
        double lower_s = 0;  ///< the gain from where it begins lower
        for (std::size_t from = to; from-- > highestBegin(to) && goesOn(from);) {
            replaced_s += times_[from].secondsOver(region);
            const double height_mm = level(from).top_z_mm - level(to).floor_z_mm;
            if (height_mm > access::freeReachMm(tool)) return;
            const double gain_s = replaced_s - layer_s * depthsOf(height_mm, cutting);
            // A level that gains next to nothing would only be in the way of ground over it.
            if (gain_s < std::max(kLeastGroundGainShare * all_s_, lower_s) + kLeastGroundGainS) continue;
            lower_s = gain_s;
            if (!best || gain_s > best->gain_s) best = Proposal{from, to, region, gain_s};
        }
    }

    /// Where ground down to that level may begin: none goes down past the top of one that was found before,
    /// which stands until the levels above it are cut.
    std::size_t highestBegin(std::size_t to) const {
        std::size_t highest = 0;
        for (const Proposal& ground : taken_)
            if (ground.from <= to) highest = std::max(highest, ground.from);
        return highest;
    }

    /// Does the next level lie straight below, with no ground between that begins there?
    bool goesOn(std::size_t i) const {
        return level(i + 1).parents == std::vector<std::string>{level(i).id} &&
               std::abs(level(i).floor_z_mm - level(i + 1).top_z_mm) <= kSameHeightMm;
    }

    /// What the tool itself does on a level; null where it takes no part.
    const CutterArea* ownArea(const ToolAssembly& tool, std::size_t level) const {
        for (const ToolReach& reach : levels_[level]->sequence.tools)
            if (reach.tool_id == tool.id) return reach.exclusion() == nullptr ? &reach.own() : nullptr;
        return nullptr;
    }

    /// What the tool covers of a level and no ground has yet that goes down to it or past it.
    Region notTaken(const CutterArea& own, std::size_t to) const {
        const std::size_t highest = highestBegin(to);
        Region free = own.coverable;
        for (const Proposal& ground : taken_)
            if (ground.from <= to && ground.to >= highest) free = subtract(free, ground.region, tol_);
        return access::withoutSliverComponents(free, tol_);
    }

    std::vector<const PlannedFeature*> levels_;  ///< from above
    std::vector<LevelTimes> times_;              ///< of each
    const ToolLibrary& library_;
    const std::string& material_;
    const Tolerances& tol_;
    double all_s_ = 0;
    std::vector<Proposal> taken_;
};

/// The region within the targets of all levels: what tolerances leave outside would be cut by nobody.
Region within(Region region, const GroundSearch& search, std::size_t from, std::size_t to,
              const Tolerances& tol) {
    for (std::size_t i = from; i <= to; ++i)
        if (!subtract(region, search.level(i).target, tol).empty())
            region = intersect(region, search.level(i).target, tol);
    return region;
}

}  // namespace

std::vector<CommonGround> proposeGround(const std::vector<PlannedFeature>& nest, const ToolLibrary& library,
                                        const std::string& material, const std::string& ids,
                                        const Tolerances& tol) {
    const auto known = std::count_if(nest.begin(), nest.end(), [](const PlannedFeature& planned) {
        return !planned.feature.ground_of.empty();
    });
    GroundSearch search(nest, library, material, tol);
    std::vector<CommonGround> grounds;
    for (Proposal& proposal : search.run()) {
        Region region = within(std::move(proposal.region), search, proposal.from, proposal.to, tol);
        // Levels that each have a part of it need not have one in common.
        if (feature::isSliver(region, tol)) continue;
        CommonGround ground;
        ground.id = fmt::format("{}.{}", ids, known + static_cast<std::ptrdiff_t>(grounds.size()) + 1);
        for (std::size_t i = proposal.from; i <= proposal.to; ++i)
            ground.levels.push_back(search.level(i).id);
        ground.region = std::move(region);
        ground.floor_z_mm = search.level(proposal.to).floor_z_mm;
        grounds.push_back(std::move(ground));
    }
    return grounds;
}

}  // namespace stepmill
