// One operation of a posted program against what must stay and what is still there.

#include "verify/prove_operation.h"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "stepmill/access/collision.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge_index.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/sizing.h"
#include "stepmill/sequence/spotting.h"
#include "stepmill/toolpath/swept_region.h"
#include "verify/read_path.h"

namespace stepmill::verify {
namespace {

using toolpath::notSwept;
using toolpath::sweptRegion;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Words of feeds and speeds are rounded: more than this share over what is planned is not rounding.
constexpr double kFeedRounding = 1e-3;

/// How far the ends of an arc may be unequally far from its centre, rounded to decimals of an inch or not
/// [mm].
constexpr double kSpiralMm = 2e-3;
/// The spindle may turn this much slower than planned at the planned feed: what a tooth cuts then is within
/// the scatter of cutting data.
constexpr double kSlowSpindle = 0.9;

/// How much less the feed must be because the spindle turns slower than planned.
double slowSpindleShare(double speed_rpm, double planned_rpm) {
    if (planned_rpm <= 0 || speed_rpm <= 0) return 1;  // told elsewhere
    return std::min(1.0, speed_rpm / (kSlowSpindle * planned_rpm));
}

double lowOf(const Vec3& from, const Move& move) {
    return std::min(from.z(), move.to.z());
}

/// A task that only tells prove() what must stay.
ClearingTask keepOff(const Region& obstruction) {
    ClearingTask task;
    task.obstruction = obstruction;
    task.top_z_mm = kInfinite;       // every feed is looked at
    task.retract_z_mm = -kInfinite;  // no rapid is
    return task;
}

void checkClearance(const LinedPath& path, const ClearingTask& task, double radius_mm, double allowed_mm,
                    const Tolerances& tol, double& least_mm, const std::string& what,
                    const Findings& findings) {
    if (path.path.moves.empty()) return;
    const double clearance = prove(path.path, task, radius_mm, tol).least_clearance_mm;
    least_mm = std::min(least_mm, clearance);
    if (clearance >= allowed_mm) return;
    const int line = firstFailingLine(path, [&](const Toolpath& part) {
        return prove(part, task, radius_mm, tol).least_clearance_mm < allowed_mm;
    });
    findings.add(line, fmt::format("{} by {:.4f} mm", what, allowed_mm + tol.gouge_mm - clearance));
}

/// The path of an arc whose ends are not equally far from its centre is no circle: LinuxCNC spirals.
void checkArcs(const ReadOperation& operation, const Findings& findings) {
    for (const ReadMove& read : operation.moves) {
        if (std::abs(read.radii_differ_mm) <= kSpiralMm) continue;
        findings.add(read.line, fmt::format("an arc ends {:.4f} mm nearer to its centre than it starts",
                                            read.radii_differ_mm));
        return;
    }
}

void checkFloor(const ReadOperation& operation, double lowest_mm, const Tolerances& tol,
                const Findings& findings) {
    for (const ReadMove& read : operation.moves) {
        if (read.fed.move.to.z() >= lowest_mm - tol.gouge_mm) continue;
        findings.add(read.line, fmt::format("goes down to Z{:.4f}, the floor is at Z{:.4f}",
                                            read.fed.move.to.z(), lowest_mm));
        return;
    }
}

bool isLevelBelow(const Vec3& from, const Move& move, double z_mm) {
    return move.kind != MoveKind::Rapid && std::max(from.z(), move.to.z()) <= z_mm;
}

/// Ways of the feeds that end no higher than z, joined where one goes on from another. Of a plunge its end.
std::vector<Path> waysBelow(const ReadOperation& operation, std::size_t from_move, std::size_t to_move,
                            double z_mm, const Vec3& start) {
    std::vector<Path> ways;
    Vec3 from = start;
    bool goes_on = false;
    for (std::size_t i = from_move; i < to_move; ++i) {
        const Move& move = operation.moves[i].fed.move;
        const bool plunged = move.kind == MoveKind::Plunge && move.to.z() <= z_mm;
        const bool wanted = isLevelBelow(from, move, z_mm) || plunged;
        if (wanted && !goes_on) ways.push_back({Vec2(from.head<2>()), {}});
        if (wanted && Vec2(move.to.head<2>()) != from.head<2>())
            ways.back().segments.push_back({move.to.head<2>(), move.arc});
        goes_on = wanted;
        from = move.to;
    }
    return ways;
}

/// The feature's own material as the holder meets it: what stood when the operation began, less what it has
/// cut by then. Cuts are taken off only when it matters.
class OwnMaterial {
  public:
    OwnMaterial(const ReadOperation& operation, const RecordedOperation& planned, const Region& standing,
                const Tolerances& tol)
        : operation_(operation), planned_(planned), whole_(standing), standing_(standing), tol_(tol) {
        edges_ = EdgeIndex(standing_);
    }

    /// Least distance from the edge to what stands at `z_mm` when move `index` begins, less the radius.
    double clearance(const Edge& way, double radius_mm, double z_mm, std::size_t index) {
        if (z_mm < cut_at_mm_) restart();
        double found = distance(way, radius_mm) - radius_mm;
        if (found >= 0 || index <= cut_until_) return found;
        takeOff(index, z_mm);
        return distance(way, radius_mm) - radius_mm;
    }

  private:
    double distance(const Edge& way, double radius_mm) const {
        const double least = edges_.distanceTo(way, 4 * radius_mm);
        if (least > 0 && contains(standing_, way.segment.to)) return 0;
        return least;
    }

    /// What was cut no lower than some height still stands below it.
    void restart() {
        standing_ = whole_;
        edges_ = EdgeIndex(standing_);
        cut_until_ = 0;
        cut_at_mm_ = -kInfinite;
    }

    void takeOff(std::size_t index, double z_mm) {
        const Vec3 start = cut_until_ == 0 ? operation_.start : operation_.moves[cut_until_ - 1].fed.move.to;
        const std::vector<Path> ways = waysBelow(operation_, cut_until_, index, z_mm, start);
        const double radius_mm = planned_.tool.radius_mm() + tol_.sliver_mm;
        if (!ways.empty()) {
            standing_ = notSwept(standing_, ways, radius_mm, tol_);
            edges_ = EdgeIndex(standing_);
            cut_at_mm_ = std::max(cut_at_mm_, z_mm);
        }
        cut_until_ = index;
    }

    const ReadOperation& operation_;
    const RecordedOperation& planned_;
    const Region& whole_;
    Region standing_;
    const Tolerances& tol_;
    EdgeIndex edges_;
    std::size_t cut_until_ = 0;
    double cut_at_mm_ = -kInfinite;  ///< highest height that something was taken off for
};

/// The feature from one height that operations go down to up to the next, as a task for prove().
std::vector<ClearingTask> bandsOf(const FeatureState& state, const RecordedOperation& planned) {
    std::vector<ClearingTask> bands;
    for (std::size_t i = 0; i < state.standing.size(); ++i) {
        ClearingTask band;
        band.target = state.standing[i].region;
        band.obstruction = state.feature.obstruction;
        band.skirt = state.feature.skirt;
        const bool highest = i + 1 == state.standing.size();
        band.top_z_mm = highest ? state.feature.top_z_mm : state.standing[i + 1].z_mm;
        band.floor_z_mm = planned.z_floor_mm;
        band.retract_z_mm = std::max(state.safe_z_mm, state.feature.top_z_mm);
        band.stands_to_mm = highestMm(state.feature);
        bands.push_back(std::move(band));
    }
    return bands;
}

}  // namespace

namespace {

bool endsAtFloor(const RecordedOperation& planned, const Feature& feature) {
    return std::abs(planned.z_floor_mm - feature.floor_z_mm) <= kSamePostedHeightMm;
}

}  // namespace

double lowestZ(const RecordedOperation& planned, const Feature& feature) {
    if (planned.tool.isSizer()) return sizerTipZ(feature, planned.tool, planned.z_floor_mm);
    if (!planned.tool.isDrill()) return planned.z_floor_mm;
    // Over a floor that a mill makes, its point lies below what it clears.
    if (planned.leaves.floors_mm > 0) return planned.z_floor_mm - pointLengthMm(planned.tool);
    return endsAtFloor(planned, feature) ? drillTipZ(feature, planned.tool) : planned.z_floor_mm;
}

double clearedDownTo(const RecordedOperation& planned, const Feature& feature) {
    if (!planned.tool.isDrill() || planned.leaves.floors_mm > 0) return planned.z_floor_mm;
    return endsAtFloor(planned, feature) ? std::max(planned.z_floor_mm, drilledToZ(feature, planned.tool))
                                         : planned.z_floor_mm + pointLengthMm(planned.tool);
}

const Region& FeatureState::standingAt(double z_mm) const {
    const Region* found = &standing.front().region;
    for (const StandingAbove& above : standing)
        if (above.z_mm <= z_mm + kSamePostedHeightMm) found = &above.region;
    return *found;
}

namespace {

/// How wide the tool is where it goes into the feature. What a tap cuts of the hole's wall is the thread,
/// what sizes a bore makes its fit; both are proven beside.
double provenRadiusMm(const RecordedOperation& planned, const Feature& feature) {
    const ToolAssembly& tool = planned.tool;
    if (!tool.isForHoles() || !isHole(feature.feature_class)) return tool.radius_mm();
    if (tool.isSpot()) return spotRadiusMm(feature, tool, planned.z_floor_mm);
    return tool.isDrill() ? tool.radius_mm() : std::min(tool.radius_mm(), holeRadiusMm(feature));
}

}  // namespace

void proveMoves(const ReadOperation& operation, const RecordedOperation& planned, const FeatureState& state,
                const Tolerances& tol, const Findings& findings) {
    const Feature& feature = state.feature;
    const double radius_mm = provenRadiusMm(planned, feature);
    checkFloor(operation, lowestZ(planned, feature), tol, findings);
    checkArcs(operation, findings);

    const std::vector<ClearingTask> bands = bandsOf(state, planned);
    const LinedPath whole = wholePath(operation);
    checkClearance(whole, bands.back(), radius_mm, planned.leaves.walls_mm - tol.gouge_mm, tol,
                   findings.proof.clearance_mm,
                   planned.leaves.walls_mm > 0 ? "cuts into the finishing allowance or what must stay"
                                               : "cuts into what must stay",
                   findings);
    // Feeds over the feature's top, where prove() takes for granted that nothing stands.
    const LinedPath above = somePath(operation, 0, [&](const Vec3& from, const Move& move) {
        const double low = lowOf(from, move);
        return move.kind != MoveKind::Rapid && low >= feature.top_z_mm && low < state.safe_z_mm;
    });
    checkClearance(above, keepOff(feature.obstruction), radius_mm, -tol.gouge_mm, tol,
                   findings.proof.clearance_mm, "meets what stands over the feature", findings);

    for (const ClearingTask& band : bands) {
        const auto rapidFails = [&](const Toolpath& part) {
            return !prove(part, band, radius_mm, tol).rapids_clear;
        };
        if (!rapidFails(whole.path)) continue;
        findings.proof.rapids_clear = false;
        findings.add(firstFailingLine(whole, rapidFails), "a rapid meets material that is still there");
        break;
    }
}

void proveHolder(const ReadOperation& operation, const RecordedOperation& planned, const FeatureState& state,
                 const Tolerances& tol, const Findings& findings) {
    const Feature& feature = state.feature;
    double& least_mm = findings.proof.holder_clearance_mm;
    for (const HolderCylinder& cylinder : access::cylindersOf(planned.tool)) {
        const double kept_mm = access::clearanceAround(planned.tool, cylinder);
        const double radius_mm = cylinder.diameter_mm / 2 - kept_mm;
        const std::string what = fmt::format(
            "shank or holder ({:.4g} mm wide from {:.4g} mm over the tip{}) comes into "
            "material",
            cylinder.diameter_mm, cylinder.bottom_mm, clearanceWords(planned.tool));
        for (std::size_t i = 0; i < feature.obstacles.size(); ++i) {
            const Region& section = feature.obstacles[i].section;
            if (section.empty()) continue;
            const LinedPath met =
                somePath(operation, cylinder.bottom_mm, [&](const Vec3& from, const Move& move) {
                    const double z = lowOf(from, move) + cylinder.bottom_mm;
                    return access::obstacleAbove(feature.obstacles, z, kSamePostedHeightMm) == i;
                });
            checkClearance(met, keepOff(section), radius_mm, kept_mm - tol.gouge_mm, tol, least_mm, what,
                           findings);
        }
        std::map<const Region*, OwnMaterial> own;
        Vec3 from = operation.start;
        for (std::size_t i = 0; i < operation.moves.size(); ++i) {
            const Move& move = operation.moves[i].fed.move;
            const double z = lowOf(from, move) + cylinder.bottom_mm;
            const Edge way = edgeOf(from, move);
            from = move.to;
            if (z >= feature.top_z_mm - kSamePostedHeightMm) continue;
            const Region& standing = state.standingAt(z);
            OwnMaterial& there = own.try_emplace(&standing, operation, planned, standing, tol).first->second;
            const double clearance = there.clearance(way, radius_mm + kept_mm, z, i);
            least_mm = std::min(least_mm, clearance + kept_mm);
            if (clearance >= -tol.gouge_mm) continue;
            findings.add(operation.moves[i].line,
                         fmt::format("{} of the feature itself by {:.4f} mm", what, -clearance));
            break;
        }
    }
}

void proveFeeds(const ReadProgram& program, const ReadOperation& operation, const RecordedOperation& planned,
                double max_feed_mm_per_min, const Findings& findings) {
    // Cutting data without a feed down mean the cutting feed.
    const double sink_limit =
        planned.plunge_feed_mm_per_min > 0 ? planned.plunge_feed_mm_per_min : planned.feed_mm_per_min;
    const bool only_sinks = planned.tool.isForHoles() && !planned.tool.isTap();
    double feed_limit = std::max(planned.feed_mm_per_min, only_sinks ? sink_limit : 0.0);
    if (planned.rating) feed_limit *= kMostChipThinning;
    if (max_feed_mm_per_min > 0) feed_limit = std::min(feed_limit, max_feed_mm_per_min);
    Vec3 from = operation.start;
    bool told = false;
    for (const ReadMove& read : operation.moves) {
        const Move& move = read.fed.move;
        const double drop = from.z() - move.to.z();
        const double flat = length(Vec2(from.head<2>()), {Vec2(move.to.head<2>()), move.arc});
        from = move.to;
        if (move.kind == MoveKind::Rapid) continue;
        // Moves as short as the last decimal have any slope once they are rounded.
        const double sinking =
            drop > kSamePostedHeightMm ? read.fed.feed_mm_per_min * drop / std::hypot(drop, flat) : 0;
        const double slow = slowSpindleShare(program.states[read.state].speed_rpm, planned.speed_rpm);
        const double share = std::max(read.fed.feed_mm_per_min / feed_limit, sinking / sink_limit) / slow;
        findings.proof.feed_share = std::max(findings.proof.feed_share, share);
        if (told || share <= 1 + kFeedRounding) continue;
        told = true;
        findings.add(
            read.line,
            fmt::format("feeds at {:.1f} mm/min ({:.1f} down); planned are {:.1f} at most and "
                        "{:.1f} down{}",
                        read.fed.feed_mm_per_min, sinking, feed_limit, sink_limit,
                        slow < 1 ? fmt::format(", less at S{:.0f}", program.states[read.state].speed_rpm)
                                 : std::string()));
    }
}

Region cleared(const ReadOperation& operation, const RecordedOperation& planned, const Feature& feature,
               const Tolerances& tol) {
    if (planned.tool.isTap() || planned.tool.isSpot()) return {};
    const ToolAssembly& tool = planned.tool;
    double radius_mm = tool.radius_mm() + tol.sliver_mm;
    const bool fits = tool.isForHoles() && tool.radius_mm() >= holeRadiusMm(feature) - kDrillUndersizeMm / 2;
    if (fits) radius_mm += kDrillUndersizeMm / 2;
    const double down_to_mm = tool.isForHoles() ? lowestZ(planned, feature) : planned.z_floor_mm;
    return sweptRegion(
        waysBelow(operation, 0, operation.moves.size(), down_to_mm + kSamePostedHeightMm, operation.start),
        radius_mm, tol);
}

}  // namespace stepmill::verify
