// How deep a mill cuts below what was cut before.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/chain.h"
#include "stepmill/sequence/advice/area_models.h"
#include "stepmill/toolpath/swept_region.h"
#include "verify/cut_ways.h"
#include "verify/prove_operation.h"

namespace stepmill::verify {
namespace {

using toolpath::notSwept;
using toolpath::piecesBeyondSkins;
using toolpath::sweptRegion;

/// One feed seen from above.
struct Way {
    Path path;  ///< one segment; none where it goes straight down
    int line = 0;
    double step_mm = 0;  ///< it may cut so far below what was cut before
};

Way wayOf(const Vec2& from, const Segment& segment, int line, double step_mm) {
    Way way{{from, {}}, line, step_mm};
    if (segment.arc || segment.to != from) way.path.segments.push_back(segment);
    return way;
}

/// A step is the difference of two heights, both rounded [mm].
constexpr double kStepRoundingMm = 2 * kSamePostedHeightMm;
/// A ramp may sink by this share of the step-down more: heights along it are known by pieces.
constexpr double kRampPiece = 1.0 / 64;
/// Pieces for that share: the ramp counts with its lower end, the turn above it with its upper one, and the
/// pieces of both need not begin at the same places.
constexpr int kLooksPerPiece = 3;
/// Slopes may be steeper by this share, and heights by their rounding [mm].
constexpr double kSlopeShare = 1e-3;
constexpr double kSlopeRoundingMm = 3e-4;
/// A ramp begins this much over the material, so that turn by turn it sinks as much more than the step-down
/// [mm].
constexpr double kRampStartMm = 0.2;

/// Equal for equal ways: layers mostly repeat those of the layer above word by word.
using WayKey = std::array<double, 7>;

WayKey keyOf(const Path& way) {
    WayKey key{way.start.x(), way.start.y(), way.start.x(), way.start.y(), 0, 0, 0};
    if (way.segments.empty()) return key;
    const Segment& segment = way.segments.front();
    key[2] = segment.to.x();
    key[3] = segment.to.y();
    if (segment.arc) {
        key[4] = segment.arc->centre.x();
        key[5] = segment.arc->centre.y();
        key[6] = segment.arc->ccw ? 1 : -1;
    }
    return key;
}

/// How near ways are looked up together, in diameters of the cutter.
constexpr double kCellDiameters = 4;

/// Follows an operation down its levels. Where material stood when it began, a pass whose lowest point is at
/// z may only go where the operation has cut down to the step-down above z, or lower, or where the feature's
/// top is no higher than that. Of a ramp its upper end counts as cut, its lower end as cutting, so the turns
/// of a helix carry each other. Ways that a level holds word by word need no areas.
class DepthProver {
  public:
    DepthProver(const RecordedOperation& planned, const FeatureState& state, const Tolerances& tol,
                const Findings& findings)
        : planned_(planned),
          state_(state),
          tol_(tol),
          findings_(findings),
          cut_(boundingBox(state.feature.target), kCellDiameters * planned.tool.diameter_mm) {}

    void prove(const ReadOperation& operation) {
        Vec3 from = operation.start;
        for (const ReadMove& read : operation.moves) {
            const Move& move = read.fed.move;
            const double low_mm = std::min(from.z(), move.to.z());
            if (move.kind == MoveKind::Rapid || low_mm >= top() - kSamePostedHeightMm) {
                settle();
            } else {
                follow(from, read);
            }
            if (failed_) return;
            from = move.to;
        }
        settle();
    }

  private:
    double top() const { return state_.feature.top_z_mm; }
    /// How high may be what a pass at that height counts on?
    double reachOver(double low_mm) const {
        const double ramp_mm = kRampStartMm + kRampPiece * planned_.step_down_mm;
        return low_mm + step_mm_ + kStepRoundingMm + (ramping_ ? ramp_mm : 0);
    }

    /// How deep a move may go below what was cut before: where it is steeper than the tool's ramps, no deeper
    /// than the tool may plunge. Finishing plunges into the allowance alone.
    double stepOf(double drop_mm, double flat_mm) const {
        const bool finishes = planned_.role == Role::Finish;
        const double ramp_mm = flat_mm * std::tan(degToRad(planned_.ramp_angle_deg));
        const bool told = flat_mm == 0 || planned_.ramp_angle_deg > 0;
        const bool steep = told && drop_mm > ramp_mm * (1 + kSlopeShare) + kSlopeRoundingMm;
        return steep && !finishes ? std::min(planned_.step_down_mm, planned_.tool.max_plunge_mm)
                                  : planned_.step_down_mm;
    }

    /// Ways that may go deeper or less deep than those before are looked at by themselves.
    void allow(double step_mm) {
        if (step_mm != step_mm_) settle();
        step_mm_ = step_mm;
    }

    /// Feeds a move; a ramp in pieces.
    void follow(const Vec3& from, const ReadMove& read) {
        const Move& move = read.fed.move;
        const Segment segment{move.to.head<2>(), move.arc};
        const double drop_mm = from.z() - move.to.z();
        allow(stepOf(drop_mm, move.kind == MoveKind::Plunge ? 0 : length(Vec2(from.head<2>()), segment)));
        if (move.kind == MoveKind::Plunge || drop_mm <= kSamePostedHeightMm) {
            const bool plunge = move.kind == MoveKind::Plunge;
            const double low_mm = std::min(from.z(), move.to.z());
            return feed(wayOf(from.head<2>(), segment, read.line, step_mm_), low_mm,
                        plunge ? low_mm : std::max(from.z(), move.to.z()));
        }
        const double sinks_mm = kRampPiece * planned_.step_down_mm / kLooksPerPiece;
        const int pieces = std::max(1, static_cast<int>(std::ceil(drop_mm / sinks_mm)));
        Vec2 at = from.head<2>();
        for (int i = 1; i <= pieces; ++i) {
            const double share = static_cast<double>(i) / pieces;
            const Vec2 to = i == pieces ? segment.to : pointAt(from.head<2>(), segment, share);
            const double high_mm = from.z() - drop_mm * (i - 1) / pieces;
            feed(wayOf(at, {to, segment.arc}, read.line, step_mm_), from.z() - drop_mm * share, high_mm);
            if (failed_) return;
            at = to;
        }
    }

    void feed(Way way, double low_mm, double cut_to_mm) {
        ramping_ = cut_to_mm > low_mm + kSamePostedHeightMm;
        auto counts_on = levelOver(low_mm);
        // Where a drill has cleared what is above, the first level counts on nothing of this operation, and
        // the next one on it.
        const bool next_level = highest_fresh_mm_ >= low_mm + step_mm_ / 2;
        if (counts_on != counts_on_ || next_level) {
            settle();
            counts_on = levelOver(low_mm);
        }
        counts_on_ = counts_on;
        if (counts_on)
            findings_.proof.depth_of_cut_mm = std::max(findings_.proof.depth_of_cut_mm, *counts_on - low_mm);
        const bool from_top = reachOver(low_mm) >= top();
        if (!from_top && !isKnown(keyOf(way.path), low_mm)) {
            asked_.push_back(way);
            asked_reach_mm_ = std::min(asked_reach_mm_, reachOver(low_mm));
        }
        fresh_.emplace_back(cut_to_mm, std::move(way.path));
        highest_fresh_mm_ = std::max(highest_fresh_mm_, cut_to_mm);
    }

    /// The highest level, or the top, that a pass at that height may count on; nothing without any.
    std::optional<double> levelOver(double low_mm) const {
        if (reachOver(low_mm) >= top()) return top();
        const auto over = levels_.upper_bound(reachOver(low_mm));
        if (over == levels_.begin()) return std::nullopt;
        return *std::prev(over);
    }

    bool isKnown(const WayKey& key, double low_mm) const {
        const auto lowest = lowest_mm_.find(key);
        return lowest != lowest_mm_.end() && lowest->second <= reachOver(low_mm);
    }

    /// Looks at the ways that were asked about, then counts what was cut meanwhile.
    void settle() {
        if (!asked_.empty()) lookAtAsked();
        asked_.clear();
        asked_reach_mm_ = std::numeric_limits<double>::infinity();
        for (auto& [z_mm, way] : fresh_) {
            const double level_mm = levelAt(z_mm);
            const auto [lowest, is_new] = lowest_mm_.try_emplace(keyOf(way), level_mm);
            if (!is_new) lowest->second = std::min(lowest->second, level_mm);
            cut_.add(level_mm, std::move(way));
        }
        fresh_.clear();
        highest_fresh_mm_ = -std::numeric_limits<double>::infinity();
    }

    double levelAt(double z_mm) {
        const auto near = levels_.lower_bound(z_mm - kSamePostedHeightMm);
        if (near != levels_.end() && *near <= z_mm + kSamePostedHeightMm) return *near;
        return *levels_.insert(near, z_mm);
    }

    void lookAtAsked() {
        std::vector<Path> ways;
        for (const Way& way : asked_)
            ways.push_back(way.path);
        const std::vector<Region> left = tooDeep(ways);
        double left_mm2 = 0;
        for (const Region& piece : left)
            left_mm2 += area(piece);
        // What stays of a level may be as much as the planner takes for full access.
        if (left_mm2 <= kFullAccessShare * area(state_.feature.target)) return;
        failed_ = true;
        const auto meets = [&](const Way& way) {
            const Region swept = sweptRegion({way.path}, planned_.tool.radius_mm(), tol_);
            return area(intersect(swept, left.front(), tol_)) > tol_.area_mm2;
        };
        const auto first = std::find_if(asked_.begin(), asked_.end(), meets);
        findings_.add(
            first == asked_.end() ? asked_.front().line : first->line,
            asked_.front().step_mm < planned_.step_down_mm
                ? fmt::format("goes down steeper than {} ramps, more than the {:.4g} mm it may plunge, over "
                              "{:.4g} mm2",
                              planned_.tool.id, asked_.front().step_mm, left_mm2)
                : fmt::format("goes more than the planned {:.4g} mm below what was cut before, over {:.4g} "
                              "mm2",
                              planned_.step_down_mm, left_mm2));
    }

    /// What the ways sweep of standing material that no level they may count on has been taken off.
    std::vector<Region> tooDeep(const std::vector<Path>& ways) const {
        const Region& standing = state_.standingAt(asked_reach_mm_);
        Region left = intersect(sweptRegion(chained(ways), planned_.tool.radius_mm(), tol_), standing, tol_);
        if (left.empty()) return {};
        const double radius_mm = planned_.tool.radius_mm() + tol_.sliver_mm;
        const Box2 around = grown(boundingBox(left), radius_mm);
        // From above: what was cut first of a ramp comes first.
        const std::vector<Path> before = counts_on_ ? cut_.below(*counts_on_, around) : std::vector<Path>{};
        if (!before.empty()) left = notSwept(left, chained(before), radius_mm, tol_);
        return piecesBeyondSkins(left, tol_);
    }

    const RecordedOperation& planned_;
    const FeatureState& state_;
    const Tolerances& tol_;
    const Findings& findings_;
    CutWays cut_;
    std::set<double> levels_;             ///< that were cut so far
    std::map<WayKey, double> lowest_mm_;  ///< of the levels that hold a way
    std::optional<double> counts_on_;
    bool ramping_ = false;
    double step_mm_ = planned_.step_down_mm;  ///< what the move in hand may cut below what was cut before
    std::vector<Way> asked_;                  ///< since settle()
    /// Least height that what they count on may have.
    double asked_reach_mm_ = std::numeric_limits<double>::infinity();
    std::vector<std::pair<double, Path>> fresh_;  ///< cut since settle(), with their heights
    double highest_fresh_mm_ = -std::numeric_limits<double>::infinity();
    bool failed_ = false;
};

}  // namespace

void proveDepths(const ReadOperation& operation, const RecordedOperation& planned, const FeatureState& state,
                 const Tolerances& tol, const Findings& findings) {
    if (planned.tool.isForHoles()) return;
    DepthProver(planned, state, tol, findings).prove(operation);
}

}  // namespace stepmill::verify
