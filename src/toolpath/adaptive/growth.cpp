// Cleared ground that grows, pass by pass, until all of the room is cleared.

#include "toolpath/adaptive/growth.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/path_parts.h"
#include "stepmill/toolpath/swept_region.h"
#include "toolpath/adaptive/bite.h"
#include "toolpath/adaptive/engaged_way.h"

namespace stepmill::toolpath {
namespace {

/// Fronts are rounded by the widest disc that the room has, then by discs this share smaller each ...
constexpr double kRoundingStep = 0.7;
/// ... down to this share of the cutter's radius. What is left in corners after that is only grazed.
constexpr double kLeastRoundingShare = 0.04;
/// An advance is good enough where it engages so much of the limit; this much is aimed at.
constexpr double kGoodShare = 0.97;
constexpr double kAimedShare = 0.99;
/// Advances tried for one pass.
constexpr int kMostTrials = 10;
/// The next pass begins with the advance of the last one; one that engages too little or too much is made
/// longer or shorter by this.
constexpr double kLonger = 1.3;
constexpr double kShorter = 0.65;
/// No pass advances less than this share of the step-over.
constexpr double kLeastAdvanceShare = 0.02;
/// From this share of the room on it is told how long all passes will be; a tenth may be wrong.
constexpr double kJudgedShare = 0.1;
constexpr double kTooLong = 1.1;
/// A way that engages as much as it may is no longer than this many times the front that it stands for.
constexpr double kLongestWay = 2;
/// No way along the limit goes farther from its front than so many step-overs.
constexpr double kFarAdvances = 2;
/// No place in a bite lies farther from the cleared ground than this share of the radius.
constexpr double kWidestBiteShare = 0.95;
/// Shorter fronts, as a share of the radius, are grown evenly.
constexpr double kLeastFrontShare = 0.2;
/// Shares of the limit that are aimed at: between places and along the fitted arcs it may be a little more.
constexpr double kAims[] = {0.985, 0.95, 0.9};
/// Ways into a pass that begins in material: arcs of these radii, in radii of the cutter ...
constexpr double kLeadRadii[] = {1, 0.5, 0.25};
/// ... and no longer than a third of a turn.
constexpr double kLeadTurnsDeg[] = {20, 30, 45, 60, 90, 120};
/// Arcs into passes that close on themselves turn so far.
constexpr double kLoopLeadTurnsDeg[] = {30, 45, 60, 75, 90, 120, 150};
/// Length of such a way in where the pass itself begins in cleared ground, with an edge shorter than this
/// [mm].
constexpr double kLeadMm = 0.1;
/// What reaches no farther from the cleared ground than so many slivers gets no pass.
constexpr double kGrownSlivers = 1;
/// A way that is not straight goes by the start of one of so many passes.
constexpr std::size_t kMostVias = 8;
/// After so many bites skins are taken without a pass.
constexpr int kTakenBeforeSkins = 8;
/// More passes are no way to clear anything.
constexpr std::size_t kMostPasses = 4000;

class Growth {
  public:
    Growth(const GrowthTask& task, const Tolerances& tol)
        : task_(task),
          tol_(tol),
          room_(task.room),
          limit_(engagementLimit(task.radius_mm, task.step_over_mm)),
          before_(intersect(task.cleared, task.room, tol)),
          cleared_(before_),
          at_(task.at),
          advance_mm_(task.step_over_mm) {
        const auto widest = ClearanceDiagram(task.room, tol).largestInscribedDisc();
        const double least_mm = kLeastRoundingShare * task.radius_mm;
        if (widest)
            for (double rounding = widest->radius_mm; rounding > least_mm; rounding *= kRoundingStep)
                roundings_mm_.push_back(rounding);
        roundings_mm_.push_back(0);
    }

    std::optional<std::vector<GrowthPass>> run() {
        if (cleared_.empty()) return std::nullopt;
        while (passes_.size() < kMostPasses && step())
            if (isTooLong()) return std::nullopt;
        const bool all = piecesToClear(subtract(task_.room, cleared_, tol_)).empty();
        if (!all || !sweepsAll()) return std::nullopt;
        return std::move(passes_);
    }

  private:
    /// By what the passes so far have cleared of the room: the first are the best, corners come last.
    bool isTooLong() const {
        const double before_mm2 = area(before_);
        const double share = (area(cleared_) - before_mm2) / (area(task_.room) - before_mm2);
        return share > kJudgedShare && cut_mm_ > kTooLong * share * task_.longest_mm;
    }

    /// Nothing stands that the room reaches: places between those that a pass is looked at may have been
    /// missed.
    bool sweepsAll() const {
        const double r = task_.radius_mm;
        std::vector<Path> ways;
        for (const GrowthPass& pass : passes_)
            ways.push_back(pass.path);
        const Region swept = unite(offset(before_, r, tol_), sweptRegion(ways, r, tol_), tol_);
        const Region reached = intersect(task_.target, offset(task_.room, r, tol_), tol_);
        return piecesBeyondSkins(subtract(reached, swept, tol_), tol_).empty();
    }

    /// The components that reach farther from the cleared ground than a skin is thick. In a corner the disc
    /// leaves a strip as long as its corner where hardly anything of the room is missing.
    std::vector<Region> piecesToClear(const Region& region) const {
        std::vector<Region> pieces = components(region);
        std::erase_if(pieces, [&](const Region& piece) {
            for (const Edge& edge : edgesOf(piece))
                for (const double share : {0.5, 1.0})
                    if (distanceToRegion(cleared_, pointAt(edge, share)) > kGrownSlivers * tol_.sliver_mm)
                        return false;
            return true;
        });
        return pieces;
    }

    bool step() { return push() || growEvenly(); }

    /// Takes what one way along the limit of engagement clears, from where a front of the cleared ground
    /// meets a wall.
    bool push() {
        for (const Path& front : fronts()) {
            if (std::find(stuck_.begin(), stuck_.end(), front.start) != stuck_.end()) continue;
            const Box2 around = boundingBox(front);
            const double far_mm = kFarAdvances * task_.step_over_mm;
            const auto near = [&](const Region& region, double reach_mm) {
                const Box2 box = grown(around, reach_mm);
                return intersect(region, makeRectangle(box.min(), box.max()), tol_);
            };
            const double r = task_.radius_mm;
            const ClearanceDiagram cleared_near(near(cleared_, far_mm + 2 * r), tol_);
            const FrontMeter meter(cleared_near, near(task_.target, far_mm + r), r, limit_, tol_);
            for (const double aim : kAims) {
                const std::optional<Trial> pushed = pushedOut(front, meter, aim, grown(around, far_mm));
                // Whatever the disc reaches from inside the bite lies within r of its front or of what was
                // cleared only where no centre of it lies farther from that.
                const bool wide = pushed && !covers(cleared_near.offset(kWidestBiteShare * r),
                                                    pushed->bite.ground, tol_.sliver_mm, tol_);
                if (!pushed || wide) continue;
                take(*pushed, meter);
                return true;
            }
            stuck_.push_back(front.start);
        }
        return false;
    }

    /// Of the cleared ground, from wall to wall, material on their right, nearest to the cutter first.
    std::vector<Path> fronts() const {
        std::vector<Path> fronts;
        for (const Loop& loop : cleared_.loops)
            for (Path& front : split(loop, task_.room, tol_).inside)
                if (!front.closed() && length(front) > kLeastFrontShare * task_.radius_mm)
                    fronts.push_back(std::move(front));
        std::stable_sort(fronts.begin(), fronts.end(), [this](const Path& a, const Path& b) {
            return distanceToStart(a, at_) < distanceToStart(b, at_);
        });
        return fronts;
    }

    /// Takes the cleared ground grown evenly, its fronts rounded.
    bool growEvenly() {
        const ClearanceDiagram grown(cleared_, tol_);
        const ClearanceDiagram reach = reachOf(grown, advance_mm_);
        const FrontMeter meter(grown, task_.target, task_.radius_mm, limit_, tol_);
        for (const double rounding_mm : roundings_mm_)
            for (const Bite& bite : bitesOf(reach, rounding_mm))
                if (take(grown, meter, bite, rounding_mm)) return true;
        return false;
    }

    ClearanceDiagram reachOf(const ClearanceDiagram& grown, double advance_mm) const {
        return ClearanceDiagram(intersect(grown.offset(advance_mm), task_.room, tol_), tol_);
    }

    /// What going so far adds, with its fronts rounded, in pieces, nearest to the cutter first.
    std::vector<Bite> bitesOf(const ClearanceDiagram& reach, double rounding_mm) const {
        const Region next = rounding_mm > 0 ? reach.opening(rounding_mm) : reach.region();
        std::vector<Bite> bites;
        for (Region& piece : piecesToClear(subtract(next, cleared_, tol_))) {
            Bite bite = biteOf(std::move(piece), cleared_, at_, tol_);
            if (!bite.fronts.empty()) bites.push_back(std::move(bite));
        }
        std::stable_sort(bites.begin(), bites.end(),
                         [](const Bite& a, const Bite& b) { return a.distance_mm < b.distance_mm; });
        return bites;
    }

    /// A bite, what its passes do, and the advance it comes from.
    struct Trial {
        Bite bite;
        double advance_mm = 0;
        std::vector<FrontCut> cuts{};  ///< of each front
        double worst_share = 0;
    };

    Trial tried(Bite bite, const FrontMeter& meter, double advance_mm, double rounding_mm) const {
        Trial trial{std::move(bite), advance_mm};
        for (Path& front : trial.bite.fronts) {
            if (front.closed()) front = withLead(front, rounding_mm);
            if (!startsClear(front)) {
                trial.worst_share = std::numeric_limits<double>::infinity();
                return trial;
            }
            trial.cuts.push_back(meter.measure(front));
            trial.worst_share = std::max(trial.worst_share, trial.cuts.back().worst_share);
        }
        return trial;
    }

    /// Finds the longest advance for one bite that engages no more than the limit, and takes it.
    bool take(const ClearanceDiagram& grown, const FrontMeter& meter, const Bite& first, double rounding_mm) {
        std::optional<Trial> best;
        std::optional<Trial> over;
        Trial trial = tried(first, meter, advance_mm_, rounding_mm);
        for (int count = 1;; ++count) {
            const bool fits = trial.worst_share <= 1;
            (fits ? best : over) = trial;
            const bool good =
                fits && (trial.worst_share > kGoodShare || trial.advance_mm >= task_.step_over_mm);
            const double advance_mm = nextAdvance(best, over);
            if (good || count == kMostTrials || advance_mm < kLeastAdvanceShare * task_.step_over_mm) break;
            const std::optional<Bite> same = sameBite(first, grown, advance_mm, rounding_mm);
            if (!same) break;
            trial = tried(*same, meter, advance_mm, rounding_mm);
        }
        if (!best) return false;
        take(*best, meter);
        return true;
    }

    /// The bite whose front engages as much as it may all along, from the start of that front on.
    std::optional<Trial> pushedOut(const Path& front, const FrontMeter& meter, double aim,
                                   const Box2& within) const {
        const Vec2 along = tangentAt(makeEdge(front.start, front.segments.front()), 0);
        const double longest_mm = kLongestWay * (length(front) + task_.radius_mm);
        const std::optional<Path> way = engagedWay(
            {meter, room_, within, task_.radius_mm, aim, longest_mm, front.start, Vec2(-leftOf(along))});
        if (!way) return std::nullopt;
        const std::optional<Region> ground = groundBeside(*way, cleared_, task_.room, tol_);
        if (!ground) return std::nullopt;
        std::optional<Bite> best;
        for (Region& piece : piecesBeyondSkins(*ground, tol_)) {
            Bite one = biteOf(std::move(piece), cleared_, at_, tol_);
            if (!one.fronts.empty() && (!best || area(one.ground) > area(best->ground)))
                best = std::move(one);
        }
        if (!best) return std::nullopt;
        Trial trial = tried(*std::move(best), meter, advance_mm_, 0);
        if (trial.worst_share > 1) return std::nullopt;
        return trial;
    }

    void take(const Trial& trial, const FrontMeter& meter) {
        for (std::size_t i = 0; i < trial.bite.fronts.size(); ++i)
            for (const Stretch& stretch : cuttingStretches(trial.cuts[i], task_.radius_mm))
                add(passOf(trial.bite.fronts[i], stretch, meter));
        advance_mm_ = std::min(task_.step_over_mm, trial.advance_mm);
        cleared_ = unite(cleared_, trial.bite.ground, tol_);
        if (++taken_ % kTakenBeforeSkins == 0) takeSkins();
    }

    /// Skins along the walls get no pass: their edges are only a burden.
    void takeSkins() {
        const std::vector<Region> left = piecesToClear(subtract(task_.room, cleared_, tol_));
        cleared_ = left.empty() ? task_.room : subtract(task_.room, unite(left, tol_), tol_);
    }

    /// A stretch of a front with a way in from cleared ground: an arc or, where none will do, all of the
    /// front before it.
    Path passOf(const Path& front, const Stretch& stretch, const FrontMeter& meter) const {
        const Path until = firstPart(front, stretch.to_mm);
        const Path part = reversed(firstPart(reversed(until), stretch.to_mm - stretch.from_mm));
        return withWayIn(part, meter).value_or(until);
    }

    /// With an arc that comes to its start from cleared ground; nothing where none engages little enough.
    std::optional<Path> withWayIn(const Path& stretch, const FrontMeter& meter) const {
        if (startsClear(stretch)) return stretch;
        for (const double radii : kLeadRadii) {
            std::optional<Path> way = leadInto(stretch, radii * task_.radius_mm, kLeadTurnsDeg);
            if (!way || meter.measure(*way).worst_share > 1 || !staysInRoom(*way)) continue;
            append(*way, stretch);
            return way;
        }
        return std::nullopt;
    }

    /// The shortest of some arcs that come to a path's start, tangentially, from cleared ground on its left.
    /// \param turns_deg  how far they turn
    std::optional<Path> leadInto(const Path& path, double radius_mm,
                                 std::span<const double> turns_deg) const {
        const double r = snapToGrid(radius_mm);
        const Vec2 along = tangentAt(makeEdge(path.start, path.segments.front()), 0);
        const Vec2 centre = snapToGrid(Vec2(path.start + r * leftOf(along)));
        const Vec2 out = path.start - centre;
        for (const double turn_deg : turns_deg) {
            const double angle = std::atan2(out.y(), out.x()) - degToRad(turn_deg);
            const Vec2 start = snapToGrid(Vec2(centre + r * Vec2(std::cos(angle), std::sin(angle))));
            if (contains(cleared_, start)) return Path{start, {{path.start, Arc{centre, r, true}}}};
        }
        return std::nullopt;
    }

    bool staysInRoom(const Path& path) const { return split(path, task_.room, tol_).outside.empty(); }

    /// Between the longest advance that fits and the shortest that does not, where the engagement would be
    /// just right if it rose evenly.
    double nextAdvance(const std::optional<Trial>& best, const std::optional<Trial>& over) const {
        if (!over) return std::min(task_.step_over_mm, kLonger * best->advance_mm);
        if (!best) return kShorter * over->advance_mm;
        const double rise = over->worst_share - best->worst_share;
        const double share = rise > 0 && std::isfinite(rise) ? (kAimedShare - best->worst_share) / rise : 0.5;
        return best->advance_mm + std::clamp(share, 0.1, 0.9) * (over->advance_mm - best->advance_mm);
    }

    std::optional<Bite> sameBite(const Bite& first, const ClearanceDiagram& grown, double advance_mm,
                                 double rounding_mm) const {
        for (Bite& bite : bitesOf(reachOf(grown, advance_mm), rounding_mm))
            if (meets(first, bite)) return std::move(bite);
        return std::nullopt;
    }

    /// The cutter comes to it over cleared ground.
    bool startsClear(const Path& front) const {
        return contains(cleared_, front.start) || distanceToBoundary(cleared_, front.start) <= tol_.linear_mm;
    }

    bool meets(const Bite& a, const Bite& b) const {
        if (!boundingBox(a.ground).intersects(boundingBox(b.ground))) return false;
        return !intersect(a.ground, b.ground, tol_).empty();
    }

    /// A closed front from its nearest point on, with an arc that comes to it from cleared ground.
    Path withLead(const Path& front, double rounding_mm) const {
        const NearestPoint at = nearestOn(front, at_);
        Path loop = startingAt(front, at.edge, at.share);
        std::optional<Path> lead =
            leadInto(loop, rounding_mm > 0 ? rounding_mm : task_.radius_mm / 4, kLoopLeadTurnsDeg);
        if (!lead) return loop;
        append(*lead, loop);
        return *std::move(lead);
    }

    /// A pass that begins with a short edge is led in straight, so that it is plain where it goes.
    void add(Path pass) {
        const Edge first = makeEdge(pass.start, pass.segments.front());
        if (length(first) < kLeadMm) {
            const Vec2 before = snapToGrid(Vec2(pass.start - kLeadMm * tangentAt(first, 0)));
            if (isClear(before, pass.start)) {
                pass.segments.insert(pass.segments.begin(), Segment{pass.start, std::nullopt});
                pass.start = before;
            }
        }
        cut_mm_ += length(pass);
        passes_.push_back({pass, wayTo(pass.start)});
        at_ = pass.end();
    }

    bool isClear(const Vec2& from, const Vec2& to) const {
        if ((from - to).norm() <= kGridMm) return true;
        return split(Path{from, {{to, std::nullopt}}}, cleared_, tol_).outside.empty();
    }

    std::optional<std::vector<Vec2>> wayTo(const Vec2& to) const {
        if (isClear(at_, to)) return std::vector<Vec2>{to};
        const std::size_t looks = std::min(passes_.size(), kMostVias);
        for (std::size_t i = 0; i < looks; ++i) {
            const Vec2& via = passes_[passes_.size() - 1 - i].path.start;
            if (isClear(at_, via) && isClear(via, to)) return std::vector<Vec2>{via, to};
        }
        return std::nullopt;
    }

    const GrowthTask& task_;
    const Tolerances& tol_;
    IndexedRegion room_;
    EngagementLimit limit_;
    std::vector<double> roundings_mm_;
    Region before_;  ///< centres cleared before the first pass
    Region cleared_;
    Vec2 at_;
    double advance_mm_;
    int taken_ = 0;            ///< bites
    std::vector<Vec2> stuck_;  ///< starts of fronts from which no way along the limit was found
    std::vector<GrowthPass> passes_;
    double cut_mm_ = 0;
};

}  // namespace

std::optional<std::vector<GrowthPass>> growthPasses(const GrowthTask& task, const Tolerances& tol) {
    return Growth(task, tol).run();
}

}  // namespace stepmill::toolpath
