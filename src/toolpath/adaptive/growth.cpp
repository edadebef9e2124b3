// Cleared ground that grows, pass by pass, until all of the room is cleared.

#include "toolpath/adaptive/growth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/path_parts.h"
#include "stepmill/toolpath/swept_region.h"

namespace stepmill::toolpath {
namespace {

/// Fronts are rounded by the widest disc that the room has, then by discs this share smaller each ...
constexpr double kRoundingStep = 0.7;
/// ... down to this share of the cutter's radius. What is left in corners after that is only grazed.
constexpr double kLeastRoundingShare = 0.04;
/// An advance is good enough where it engages so much of the limit; this much is aimed at.
constexpr double kGoodShare = 0.95;
constexpr double kAimedShare = 0.98;
/// Advances tried for one pass.
constexpr int kMostTrials = 6;
/// The next pass begins with the advance of the last one; one that engages too little or too much is made
/// longer or shorter by this.
constexpr double kLonger = 1.3;
constexpr double kShorter = 0.75;
/// No pass advances less than this share of the step-over.
constexpr double kLeastAdvanceShare = 0.02;
/// From this share of the room on it is told how long all passes will be; a tenth may be wrong.
constexpr double kJudgedShare = 0.1;
constexpr double kTooLong = 1.1;
/// More passes are no way to clear anything.
constexpr std::size_t kMostPasses = 4000;

/// Ground that one more pass clears.
struct Bite {
    Region ground;
    std::vector<Path> fronts;  ///< its boundary where it is not that of the cleared ground
    double distance_mm = 0;    ///< from the cutter to the nearest of them
};

class Growth {
  public:
    Growth(const GrowthTask& task, const Tolerances& tol)
        : task_(task),
          tol_(tol),
          target_(task.target),
          limit_(engagementLimit(task.radius_mm, task.step_over_mm)),
          cleared_(intersect(task.cleared, task.room, tol)),
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
        const bool all = piecesBeyondSkins(subtract(task_.room, cleared_, tol_), tol_).empty();
        if (!all) return std::nullopt;
        return std::move(passes_);
    }

  private:
    /// By what the passes so far have cleared of the room: the first are the best, corners come last.
    bool isTooLong() const {
        const double to_clear_mm2 = area(task_.room) - cleared_before_mm2_;
        const double share = (area(cleared_) - cleared_before_mm2_) / to_clear_mm2;
        return share > kJudgedShare && cut_mm_ > kTooLong * share * task_.longest_mm;
    }

    bool step() {
        const ClearanceDiagram grown(cleared_, tol_);
        const ClearanceDiagram reach = reachOf(grown, advance_mm_);
        for (const double rounding_mm : roundings_mm_)
            for (const Bite& bite : bitesOf(reach, rounding_mm))
                if (take(grown, bite, rounding_mm)) return true;
        return false;
    }

    ClearanceDiagram reachOf(const ClearanceDiagram& grown, double advance_mm) const {
        return ClearanceDiagram(intersect(grown.offset(advance_mm), task_.room, tol_), tol_);
    }

    /// What going so far adds, with its fronts rounded, in pieces, nearest to the cutter first.
    std::vector<Bite> bitesOf(const ClearanceDiagram& reach, double rounding_mm) const {
        const Region next = rounding_mm > 0 ? reach.opening(rounding_mm) : reach.region();
        std::vector<Bite> bites;
        for (Region& piece : piecesBeyondSkins(subtract(next, cleared_, tol_), tol_)) {
            Bite bite{std::move(piece), {}, std::numeric_limits<double>::infinity()};
            for (const Loop& loop : bite.ground.loops)
                for (Path& front : split(loop, cleared_, tol_).outside) {
                    if (length(front) <= tol_.sliver_mm) continue;
                    bite.distance_mm = std::min(bite.distance_mm, distanceToStart(front));
                    bite.fronts.push_back(std::move(front));
                }
            if (!bite.fronts.empty()) bites.push_back(std::move(bite));
        }
        std::stable_sort(bites.begin(), bites.end(),
                         [](const Bite& a, const Bite& b) { return a.distance_mm < b.distance_mm; });
        return bites;
    }

    double distanceToStart(const Path& front) const {
        return front.closed() ? nearestOn(front, at_).distance_mm : (front.start - at_).norm();
    }

    /// A bite, what its passes do, and the advance it comes from.
    struct Trial {
        Bite bite;
        FrontCut cut;
        double advance_mm = 0;
    };

    Trial tried(Bite bite, const FrontMeter& meter, double advance_mm, double rounding_mm) const {
        Trial trial{std::move(bite), {}, advance_mm};
        for (Path& front : trial.bite.fronts) {
            if (front.closed()) front = withLead(front, rounding_mm);
            if (!startsClear(front)) {
                trial.cut.worst_share = std::numeric_limits<double>::infinity();
                return trial;
            }
            const FrontCut cut = meter.measure(front);
            trial.cut.worst_share = std::max(trial.cut.worst_share, cut.worst_share);
            trial.cut.cuts = trial.cut.cuts || cut.cuts;
        }
        return trial;
    }

    /// Finds the longest advance for one bite that engages no more than the limit, and takes it.
    bool take(const ClearanceDiagram& grown, const Bite& first, double rounding_mm) {
        const FrontMeter meter(cleared_, target_, task_.radius_mm, limit_);
        std::optional<Trial> best;
        std::optional<Trial> over;
        Trial trial = tried(first, meter, advance_mm_, rounding_mm);
        for (int count = 1;; ++count) {
            const bool fits = trial.cut.worst_share <= 1;
            (fits ? best : over) = trial;
            const bool good =
                fits && (trial.cut.worst_share > kGoodShare || trial.advance_mm >= task_.step_over_mm);
            const double advance_mm = nextAdvance(best, over);
            if (good || count == kMostTrials || advance_mm < kLeastAdvanceShare * task_.step_over_mm) break;
            const std::optional<Bite> same = sameBite(first, grown, advance_mm, rounding_mm);
            if (!same) break;
            trial = tried(*same, meter, advance_mm, rounding_mm);
        }
        if (!best) return false;
        advance_mm_ = std::min(task_.step_over_mm, best->advance_mm);
        if (best->cut.cuts)
            for (const Path& front : best->bite.fronts)
                add(front);
        cleared_ = unite(cleared_, best->bite.ground, tol_);
        return true;
    }

    /// Between the longest advance that fits and the shortest that does not, where the engagement would be
    /// just right if it rose evenly.
    double nextAdvance(const std::optional<Trial>& best, const std::optional<Trial>& over) const {
        if (!over) return std::min(task_.step_over_mm, kLonger * best->advance_mm);
        if (!best) return kShorter * over->advance_mm;
        const double rise = over->cut.worst_share - best->cut.worst_share;
        const double share =
            rise > 0 && std::isfinite(rise) ? (kAimedShare - best->cut.worst_share) / rise : 0.5;
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
        const double radius_mm = snapToGrid(rounding_mm > 0 ? rounding_mm : task_.radius_mm / 4);
        const Edge first = makeEdge(loop.start, loop.segments.front());
        const Vec2 along = tangentAt(first, 0);
        const Vec2 centre = snapToGrid(Vec2(loop.start + radius_mm * leftOf(along)));
        const Vec2 out = loop.start - centre;
        for (const double back_deg : {30.0, 45.0, 60.0, 75.0, 90.0, 120.0, 150.0}) {
            const double angle = std::atan2(out.y(), out.x()) - degToRad(back_deg);
            const Vec2 start = snapToGrid(Vec2(centre + radius_mm * Vec2(std::cos(angle), std::sin(angle))));
            if (!contains(cleared_, start)) continue;
            Path lead{start, {{loop.start, Arc{centre, radius_mm, true}}}};
            lead.segments.insert(lead.segments.end(), loop.segments.begin(), loop.segments.end());
            return lead;
        }
        return loop;
    }

    void add(const Path& front) {
        if (task_.ground.empty()) return addPass(front);
        const SplitPath parts = split(front, task_.ground, tol_);
        for (const std::vector<Path>* some : {&parts.inside, &parts.on})
            for (const Path& part : *some)
                if (length(part) > tol_.sliver_mm) addPass(part);
    }

    void addPass(const Path& pass) {
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
        const std::size_t looks = std::min<std::size_t>(passes_.size(), 8);
        for (std::size_t i = 0; i < looks; ++i) {
            const Path& before = passes_[passes_.size() - 1 - i].path;
            const Vec2 via = snapToGrid(pointAt(makeEdge(before.start, before.segments.front()), 0));
            if (isClear(at_, via) && isClear(via, to)) return std::vector<Vec2>{via, to};
        }
        return std::nullopt;
    }

    const GrowthTask& task_;
    const Tolerances& tol_;
    IndexedRegion target_;
    EngagementLimit limit_;
    std::vector<double> roundings_mm_;
    Region cleared_;
    Vec2 at_;
    double advance_mm_;
    std::vector<GrowthPass> passes_;
    double cleared_before_mm2_ = area(cleared_);
    double cut_mm_ = 0;
};

}  // namespace

std::optional<std::vector<GrowthPass>> growthPasses(const GrowthTask& task, const Tolerances& tol) {
    return Growth(task, tol).run();
}

}  // namespace stepmill::toolpath
