// Rapids that keep their distance from what stands, or may stand, beside them.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "stepmill/core/units.h"
#include "stepmill/feature/heights.h"
#include "stepmill/planar/chain.h"
#include "stepmill/planar/indexed_region.h"
#include "stepmill/toolpath/adaptive_cutting.h"
#include "stepmill/toolpath/path_frame.h"
#include "stepmill/toolpath/toolpath.h"
#include "toolpath/emit.h"
#include "toolpath/engagement/swept_ways.h"
#include "toolpath/swept_ground.h"

namespace stepmill {
namespace {

/// Places to come down beside the wanted one are looked for in so many directions ...
constexpr int kDirections = 12;
/// ... and at these many clearances' distance, from inside and from outside.
constexpr std::array<double, 2> kInsideSteps{1.05, 2.1};
constexpr std::array<double, 2> kSideSteps{1.05, 1.6};
/// A glide down keeps this off what stands [mm]; nearer the cutter goes down as fast as it cuts.
constexpr double kGlideOffMm = 0.05;
/// Less of it is no move of its own [mm].
constexpr double kLeastGlideMm = 0.1;

/// A way that was cut, and how high the tool was there at most, the deepest time: depths of cut are like each
/// other.
struct CutEdge {
    Edge edge;
    double top_z_mm;
    int id;
};

/// Heights and distances that rapids keep.
struct RapidClearance {
    double side_mm = 0;    ///< beside the target, from outside
    double inside_mm = 0;  ///< from all that stands, where the tool is over its own ground
    double top_mm = 0;     ///< over the target's top
};

/// The clearances of the machine, over a raw top its own, else what rapids keep over any ground.
RapidClearance clearanceOver(const ClearingTask& task, const Machine& machine) {
    const double top_mm = toolpath::isRawTop(task.top_z_mm) ? machine.top_clearance_mm : 0;
    return {machine.side_clearance_mm, machine.inside_clearance_mm, top_mm};
}

/// What stands when: the walls, the skirt, and of the target what the path has not cut so far.
class Ground {
  public:
    Ground(const ClearingTask& task, double radius_mm, const RapidClearance& keep)
        : task_(task),
          radius_mm_(radius_mm),
          keep_(keep),
          target_(task.target),
          walls_(task.obstruction),
          skirt_(task.skirt),
          swept_(task, radius_mm),
          top_mm_(task.top_z_mm + keep.top_mm) {
        if (task.stands_above) above_.emplace(*task.stands_above);
        for (const KeptOff& kept : task.kept_off)
            holder_.push_back({EdgeIndex(kept.section), kept.distance_mm});
    }

    void add(const Edge& edge, const Vec3& from, const Vec3& to) {
        const double top_z_mm = std::max(from.z(), to.z());
        if (last_ && last_->top_z_mm == top_z_mm && last_->edge.to() == edge.from &&
            goesOn(last_->edge.from, last_->edge.segment, edge.segment)) {
            last_->edge = makeEdge(last_->edge.from, edge.segment);
        } else {
            enter();
            last_ = CutEdge{edge, top_z_mm, 0};
        }
        const auto same = [&](double height) { return std::abs(height - top_z_mm) < kSameHeightMm; };
        if (from.z() == to.z() && std::none_of(heights_.begin(), heights_.end(), same))
            heights_.push_back(top_z_mm);
    }

    /// Takes the cuts near a place together, for the questions about it that follow.
    void lookAt(const Vec2& place, double reach_mm) {
        enter();
        const Box2 box = grown(Box2(place, place), reach_mm + 3 * radius_mm_);
        near_.clear();
        for (const CutEdge& cut : cuts_)
            if (cut.edge.box.intersects(box)) near_.push_back(cut);
    }

    /// Has a rapid there, level or straight down to that height, the room it needs? Straight down: near the
    /// place that was looked at.
    bool isClear(const Vec2& a, const Vec2& b, double z_mm) const {
        if (z_mm >= task_.retract_z_mm) return true;
        const bool high = z_mm >= top_mm_ - kSameHeightMm;
        // Over all that stands a way across still keeps its proof, which looks at walls below the retract
        // height whatever their height.
        if (high && z_mm >= task_.stands_to_mm)
            return a == b || !walls_.boundary().anyNearer(makeLine(a, b), radius_mm_);
        const bool own_ground = a != b || target_.contains(a);
        const double keep_mm = own_ground ? keep_.inside_mm : keep_.side_mm;
        // Straight down to the top a narrow feature's own walls are still below.
        const IndexedRegion& walls = high && a == b && above_ ? *above_ : walls_;
        const Edge way = makeLine(a, b);
        if (walls.isNear(way, radius_mm_ + keep_.inside_mm) || skirt_.isNear(way, radius_mm_ + keep_mm))
            return false;
        const std::vector<CutEdge>& cuts = a == b ? near_ : cuts_;
        return high || isSweptClear(z_mm, a, b, keep_mm, cuts);
    }

    /// Is the straight way at that height clear of all that stands for the cutter itself, and of what keeps
    /// the holder away?
    /// \param off_mm  and farther off it than that
    bool isFreeInAir(const Vec2& a, const Vec2& b, double z_mm, double off_mm = 0) const {
        const Edge way = makeLine(a, b);
        if (walls_.boundary().anyNearer(way, radius_mm_ + off_mm)) return false;
        for (const Holder& holder : holder_)
            if (holder.edges.anyNearer(way, holder.distance_mm)) return false;
        return z_mm >= task_.top_z_mm || isSweptClear(z_mm, a, b, off_mm, near_);
    }

    /// May stock that is larger than drawn lie there, beside what must stay?
    bool mayBeStock(const Vec2& place) const { return skirt_.isNear(place, radius_mm_); }

    /// Over how high ground the tool may be fed down at a place from there on, ascending.
    std::vector<double> heightsOver(double z_mm) const {
        std::vector<double> heights{z_mm};
        for (const double height : heights_)
            if (height < task_.top_z_mm - kSameHeightMm && height + toolpath::kApproachMm > z_mm)
                heights.push_back(height + toolpath::kApproachMm);
        const double over_top_mm = std::max(top_mm_, task_.top_z_mm + toolpath::kApproachMm);
        heights.push_back(std::max(over_top_mm, z_mm));
        heights.push_back(std::max({over_top_mm, z_mm, task_.stands_to_mm + toolpath::kApproachMm}));
        for (double& height : heights)
            height = std::min(height, std::max(z_mm, task_.retract_z_mm));
        std::sort(heights.begin(), heights.end());
        heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
        return heights;
    }

    double topMm() const { return std::max(top_mm_, task_.top_z_mm + toolpath::kApproachMm); }
    double retractMm() const { return task_.retract_z_mm; }

  private:
    struct Holder {
        EdgeIndex edges;
        double distance_mm;
    };

    /// Nothing will lengthen the last cut any more.
    void enter() {
        if (!last_) return;
        const auto [known, is_new] =
            ids_.try_emplace(toolpath::keyOf(last_->edge).key, static_cast<int>(cuts_.size()));
        last_->id = known->second;
        if (is_new)
            cuts_.push_back(*last_);
        else
            cuts_[known->second].top_z_mm = std::min(cuts_[known->second].top_z_mm, last_->top_z_mm);
        last_.reset();
    }

    /// Is the straight way clear of what has not been cut down to that height? Most depths of cut are like
    /// each other, and so are their questions: answers are kept.
    bool isSweptClear(double z_mm, const Vec2& a, const Vec2& b, double keep_mm,
                      const std::vector<CutEdge>& cuts) const {
        const Box2 box = grown(makeLine(a, b).box, 2 * radius_mm_ + keep_mm);
        Question question{{a.x(), a.y(), b.x(), b.y(), keep_mm}, {}};
        for (const CutEdge& cut : cuts)
            if (cut.top_z_mm <= z_mm && cut.edge.box.intersects(box)) question.second.push_back(cut.id);
        const auto [answer, is_new] = answers_.try_emplace(std::move(question), false);
        if (!is_new) return answer->second;
        toolpath::SweptGround ground = swept_;
        for (const int id : answer->first.second)
            ground.add(cuts_[id].edge);
        answer->second = ground.isClearFor(radius_mm_ + keep_mm, a, b);
        return answer->second;
    }

    /// A way, what is kept beside it, and the cuts around it.
    using Question = std::pair<std::array<double, 5>, std::vector<int>>;

    const ClearingTask& task_;
    double radius_mm_;
    RapidClearance keep_;
    IndexedRegion target_;
    IndexedRegion walls_;
    IndexedRegion skirt_;
    std::optional<IndexedRegion> above_;  ///< what stands over the top, where it is known
    std::vector<Holder> holder_;
    toolpath::SweptGround swept_;
    double top_mm_;                ///< rapids over the target stay over this
    std::optional<CutEdge> last_;  ///< the latest, while the next may go on in its line or circle
    std::vector<CutEdge> cuts_;    ///< by their ids: each line or arc once
    std::map<toolpath::EdgeKey, int> ids_;
    std::vector<CutEdge> near_;    ///< those near the place that is looked at
    std::vector<double> heights_;  ///< of the level cuts, each once
    mutable std::map<Question, bool> answers_;
};

/// Where a rapid down ends; from there the tool is fed across, and then down.
struct Landing {
    Vec2 at = Vec2::Zero();
    double z_mm = 0;
};

class ClearRapids {
  public:
    ClearRapids(const Toolpath& path, const ClearingTask& task, double radius_mm, const RapidClearance& keep,
                const Machine& machine)
        : path_(path),
          keep_(keep),
          rapid_mm_per_min_(machine.rapid_mm_per_min),
          glide_mm_per_min_(glideFeedMmPerMin(machine)),
          in_slot_(task.in_slot),
          ground_(task, radius_mm, keep) {
        made_ = path;
        made_.moves.clear();
    }

    Toolpath make() {
        for (std::size_t i = 0; i < path_.moves.size(); ++i) {
            if (path_.moves[i].kind != MoveKind::Rapid) {
                feed(path_.moves[i]);
                continue;
            }
            if (path_.moves[i].for_chips) {
                made_.moves.push_back(path_.moves[i]);
                continue;
            }
            double highest_mm = at().z();
            for (;; ++i) {
                highest_mm = std::max(highest_mm, path_.moves[i].to.z());
                if (i + 1 == path_.moves.size() || path_.moves[i + 1].kind != MoveKind::Rapid) break;
            }
            goTo(path_.moves[i].to, highest_mm);
        }
        return std::move(made_);
    }

  private:
    Vec3 at() const { return made_.moves.empty() ? made_.start : made_.moves.back().to; }

    void add(MoveKind kind, const Vec2& at_xy, double z_mm) {
        const Vec3 to(at_xy.x(), at_xy.y(), z_mm);
        if (to != at()) made_.moves.push_back({kind, to, std::nullopt, kind != MoveKind::Rapid});
    }

    void feed(const Move& move) {
        const Vec3 from = at();
        ground_.add(edgeOf(from, move), from, move.to);
        made_.moves.push_back(move);
    }

    void goTo(const Vec3& to, double crossing_mm) {
        const Vec2 from = at().head<2>();
        const Vec2 place = to.head<2>();
        if (from == place && to.z() >= at().z()) return add(MoveKind::Rapid, place, to.z());
        const Landing landing = landingFor(place, to.z());
        const double over_mm =
            from == landing.at ? landing.z_mm
                               : std::max({crossingZ(from, landing.at, crossing_mm), landing.z_mm, at().z()});
        if (feedAcross(from, to, landing, over_mm)) return;
        // The path starts over its first place: at the retract height that is where it comes down.
        if (made_.moves.empty() && from == place) made_.start.head<2>() = landing.at;
        if (Vec2(at().head<2>()) != landing.at) {
            add(MoveKind::Rapid, from, over_mm);
            add(MoveKind::Rapid, landing.at, over_mm);
        }
        add(MoveKind::Rapid, landing.at, landing.z_mm);
        add(MoveKind::Feed, place, landing.z_mm);
        feedDown(place, to.z());
    }

    /// Where the cutter itself has room, but no rapid: faster than through material, as far as that goes.
    void feedDown(const Vec2& place, double z_mm) {
        const std::vector<double> heights =
            ground_.mayBeStock(place) ? std::vector<double>() : ground_.heightsOver(z_mm);
        for (const double height : heights) {
            if (height > at().z() - kLeastGlideMm) break;
            if (!ground_.isFreeInAir(place, place, height)) continue;
            const bool apart = ground_.isFreeInAir(place, place, height, kGlideOffMm);
            const double feed = apart ? glide_mm_per_min_ : path_.feed_mm_per_min;
            if (feed > path_.plunge_feed_mm_per_min)
                made_.moves.push_back(
                    {MoveKind::Feed, {place.x(), place.y(), height}, std::nullopt, true, feed});
            break;
        }
        add(MoveKind::Plunge, place, z_mm);
    }

    /// Level through what is cleared, where that is quicker than over it, or a rapid would have to come down
    /// from higher in a slot.
    bool feedAcross(const Vec2& from, const Vec3& to, const Landing& landing, double over_mm) {
        if (made_.moves.empty()) return false;
        const Vec2 place = to.head<2>();
        const double z_mm = std::max(at().z(), to.z());
        const double over_min = 2 * (over_mm - z_mm) / rapid_mm_per_min_;
        const bool quicker = (place - from).norm() / path_.feed_mm_per_min < over_min;
        const bool higher = in_slot_ && landing.z_mm > z_mm + kSameHeightMm;
        if (!(higher || quicker) || !ground_.isFreeInAir(from, place, z_mm)) return false;
        add(MoveKind::Rapid, from, z_mm);
        add(MoveKind::Feed, place, z_mm);
        if (landing.at == place) add(MoveKind::Rapid, place, std::min(landing.z_mm, z_mm));
        feedDown(place, to.z());
        return true;
    }

    double crossingZ(const Vec2& from, const Vec2& to, double wanted_mm) const {
        for (const double z_mm : {wanted_mm, std::max(wanted_mm, ground_.topMm())})
            if (ground_.isClear(from, to, z_mm)) return z_mm;
        return std::max(wanted_mm, ground_.retractMm());
    }

    /// The lowest height with the room for a rapid at the place or near by.
    Landing landingFor(const Vec2& place, double z_mm) {
        ground_.lookAt(place, kSideSteps.back() * keep_.side_mm + kInsideSteps.back() * keep_.inside_mm);
        const std::vector<double> heights = ground_.heightsOver(z_mm);
        for (const double height : heights) {
            if (ground_.isClear(place, place, height)) return {place, height};
            // Where the cutter itself does not fit no place beside leads to it.
            if (!ground_.isFreeInAir(place, place, height)) continue;
            for (const Vec2& beside : placesBeside(place))
                if (ground_.isClear(beside, beside, height) && ground_.isFreeInAir(beside, place, height))
                    return {beside, height};
        }
        return {place, heights.back()};
    }

    std::vector<Vec2> placesBeside(const Vec2& place) const {
        std::vector<double> distances;
        for (const double step : kInsideSteps)
            distances.push_back(step * keep_.inside_mm);
        for (const double step : kSideSteps)
            distances.push_back(step * keep_.side_mm);
        std::sort(distances.begin(), distances.end());
        std::vector<Vec2> places;
        for (const double distance_mm : distances)
            for (int i = 0; i < kDirections && distance_mm > 0; ++i) {
                const double angle_rad = 2 * kPi * i / kDirections;
                const Vec2 by = distance_mm * Vec2(std::cos(angle_rad), std::sin(angle_rad));
                places.push_back(snapToGrid(Vec2(place + by)));
            }
        return places;
    }

    const Toolpath& path_;
    RapidClearance keep_;
    double rapid_mm_per_min_;
    double glide_mm_per_min_;
    bool in_slot_;
    Ground ground_;
    Toolpath made_;
};

}  // namespace

Toolpath withClearRapids(const Toolpath& path, const ClearingTask& task, double tool_radius_mm,
                         const Machine& machine) {
    const RapidClearance keep = clearanceOver(task, machine);
    const bool may_touch = keep.side_mm <= 0 && keep.inside_mm <= 0 && keep.top_mm <= 0;
    if (path.moves.empty() || (may_touch && task.skirt.empty())) return path;
    Toolpath made = ClearRapids(path, task, tool_radius_mm, keep, machine).make();
    made.totals = measure(made, machine);
    return made;
}

}  // namespace stepmill
