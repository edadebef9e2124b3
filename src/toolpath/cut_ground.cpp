// How wide and how deep the moves of an operation cut.

#include "stepmill/toolpath/cut_ground.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>

#include "stepmill/core/units.h"
#include "stepmill/planar/indexed_region.h"
#include "stepmill/toolpath/path_frame.h"
#include "toolpath/engagement/rim.h"
#include "toolpath/engagement/swept_ways.h"
#include "toolpath/engagement/trail.h"

namespace stepmill {
namespace {

using toolpath::EdgeKey;
using toolpath::isShort;
using toolpath::keyOf;
using toolpath::Rim;
using toolpath::SweptWay;
using toolpath::SweptWays;
using toolpath::Trail;

/// The first and the last position lie so far inside the move, as a share of the radius: where it ends at the
/// end of an earlier way the rim only touches what lies beyond.
constexpr double kInsideShare = 0.05;
/// Length of the way, as a share of the radius, whose sweep alone makes no graze: five times as long as one
/// is deep.
constexpr double kFreshShare = 5 * kGrazeShare;

bool isFlat(const Vec3& from, const Move& move) {
    return move.arc || from.head<2>() != move.to.head<2>();
}

/// Where widths are asked along an edge, as shares of its length.
std::vector<double> placesAlong(const Edge& edge, double radius_mm) {
    const double length_mm = length(edge);
    const double step = kCutStepShare * radius_mm / length_mm;
    const int steps = std::max(1, static_cast<int>(std::ceil(1 / step)));
    const double inside = std::min(0.25, kInsideShare * radius_mm / length_mm);
    std::vector<double> places;
    for (int i = 0; i <= steps; ++i)
        places.push_back(std::clamp(i < steps ? i * step : 1.0, inside, 1 - inside));
    return places;
}

}  // namespace

struct CutGround::Impl {
    IndexedRegion target;
    double top_z_mm;
    SweptWays swept;
};

CutGround::CutGround(const Region& target, double top_z_mm) : impl_(std::make_unique<Impl>()) {
    impl_->target = IndexedRegion(target);
    impl_->top_z_mm = top_z_mm;
}
CutGround::CutGround(CutGround&&) noexcept = default;
CutGround& CutGround::operator=(CutGround&&) noexcept = default;
CutGround::~CutGround() = default;

void CutGround::add(const Vec3& start, const std::vector<Move>& moves, double radius_mm) {
    Vec3 from = start;
    for (const Move& move : moves) {
        if (move.kind != MoveKind::Rapid) {
            const bool flat = isFlat(from, move);
            const double z_mm = flat ? std::max(from.z(), move.to.z()) : std::min(from.z(), move.to.z());
            if (z_mm < impl_->top_z_mm) impl_->swept.add(edgeOf(from, move), radius_mm, z_mm);
        }
        from = move.to;
    }
}

/// One operation on its way.
struct CutFollower::Impl {
    /// Moves at one height.
    struct Level {
        SweptWays swept;
        int state = 0;  ///< equal for levels at which the same ways were gone in the same order
    };
    /// What a level move found, and the state of its level after it.
    struct Known {
        int state = 0;
        std::vector<double> widths_mm;  ///< empty until they are asked for
        double widest_mm = 0;
        double engaged_rad = 0;
    };
    /// Of a rim at one place.
    struct Cut {
        double width_mm = 0;
        double engaged_rad = 0;
    };
    /// State of the level, what earlier operations and slopes have swept down to it, the way, whether it is
    /// gone back, and where the cutter goes in it if it is short.
    using Question = std::tuple<int, std::uint64_t, std::uint64_t, EdgeKey, bool, double, double>;
    /// Heights at which a line or arc was gone along last, at the ends as its key has them.
    struct Heights {
        double first_mm;
        double second_mm;
    };

    MoveCut next(const Vec3& from, const Move& move, bool asks_width) {
        // A glide goes over ground that is clear, as a rapid does, but lifted over the level that tells so.
        if (move.kind == MoveKind::Rapid || isGlide(move)) {
            trail.clear();
            last.clear();
            return {};
        }
        const double low_mm = std::min(from.z(), move.to.z());
        const double high_mm = std::max(from.z(), move.to.z());
        const Edge edge = edgeOf(from, move);
        if (!isFlat(from, move)) {
            trail.clear();
            last.clear();
            if (move.to.z() < from.z()) enter(edge, levelAt(low_mm), low_mm, {});
            return {};
        }
        const std::optional<Vec2> along = isShort(edge) ? trail.directionTo(edge.to()) : std::nullopt;
        trail.add(edge);
        MoveCut cut;
        cut.depth_mm = depthOf(edge, from.z(), move.to.z());
        if (high_mm - low_mm > kSameCutHeightMm) {
            cut.widest_mm = 2 * radius_mm;
            if (edge.segment.arc)
                cut.depth_mm *= toolpath::helixWidth(edge.segment.arc->radius_mm, radius_mm) / cut.widest_mm;
            slopes.add(edge, radius_mm, high_mm);
            return cut;
        }
        Level& level = levelAt(low_mm);
        if (asks_width) {
            const Known& found = lookUp(edge, level, low_mm, along);
            cut.widths_mm = &found.widths_mm;
            cut.widest_mm = found.widest_mm;
            cut.engaged_rad = found.engaged_rad;
        } else {
            enter(edge, level, low_mm, along);
        }
        return cut;
    }

    double depthOf(const Edge& edge, double from_z_mm, double to_z_mm) {
        const auto [key, turned] = keyOf(edge);
        const Heights now = turned ? Heights{to_z_mm, from_z_mm} : Heights{from_z_mm, to_z_mm};
        double depth_mm = std::min(step_down_mm, ground.top_z_mm - std::min(from_z_mm, to_z_mm));
        const auto [before, is_new] = gone.try_emplace(key, now);
        if (!is_new) {
            depth_mm = std::min(depth_mm, std::max(before->second.first_mm - now.first_mm,
                                                   before->second.second_mm - now.second_mm));
            // A pass higher up takes nothing of what a deeper one has left.
            if (now.first_mm <= before->second.first_mm && now.second_mm <= before->second.second_mm)
                before->second = now;
        }
        return std::max(0.0, depth_mm);
    }

    Level& levelAt(double z_mm) {
        const auto near = levels.lower_bound(z_mm - kSameCutHeightMm);
        if (near != levels.end() && near->first <= z_mm + kSameCutHeightMm) return near->second;
        return levels[z_mm];
    }

    /// \param along  where the cutter goes in a short move; nothing: that is not known
    const Known& lookUp(const Edge& edge, Level& level, double z_mm, const std::optional<Vec2>& along) {
        Known& found = answerTo(edge, level, z_mm, along);
        if (found.widths_mm.empty()) {
            measure(edge, level, z_mm, along, found);
            found.widest_mm = *std::max_element(found.widths_mm.begin(), found.widths_mm.end());
        }
        sweep(edge, level, z_mm, found.state);
        return found;
    }

    /// No width is asked for, as of a way straight down.
    void enter(const Edge& edge, Level& level, double z_mm, const std::optional<Vec2>& along) {
        sweep(edge, level, z_mm, answerTo(edge, level, z_mm, along).state);
    }

    void sweep(const Edge& edge, Level& level, double z_mm, int state) {
        level.state = state;
        level.swept.add(edge, radius_mm, z_mm);
        if (measures != CutMeasures::WidthsAndAngles) return;
        last.push_back(edge);
        double length_mm = 0;
        for (const Edge& one : last)
            length_mm += length(one);
        while (last.size() > 1 && length_mm - length(last.front()) >= kFreshShare * radius_mm) {
            length_mm -= length(last.front());
            last.pop_front();
        }
    }

    Known& answerTo(const Edge& edge, const Level& level, double z_mm, const std::optional<Vec2>& along) {
        const double down_to_mm = z_mm + kSameCutHeightMm;
        const auto [key, turned] = keyOf(edge);
        const Question question{level.state, ground.swept.setOf(down_to_mm), slopes.setOf(down_to_mm), key,
                                turned,      along ? along->x() : 0,         along ? along->y() : 0};
        const auto [answer, is_new] = answers.try_emplace(question);
        if (is_new) answer->second.state = ++last_state;
        return answer->second;
    }

    /// The ways and edges that may matter to a rim somewhere on an edge.
    struct Around {
        std::vector<const SweptWay*> swept;
        std::vector<const SweptWay*> swept_before;  ///< of these all but the last ways
        std::vector<const Edge*> boundary;
    };

    Around around(const Box2& box, const Level& level, double down_to_mm) const {
        Around found;
        const auto add = [&](const SweptWay& way) { found.swept.push_back(&way); };
        level.swept.forEachNear(box, down_to_mm, add);
        slopes.forEachNear(box, down_to_mm, add);
        ground.swept.forEachNear(box, down_to_mm, add);
        ground.target.boundary().forEachIn(box, [&](const Edge& edge) { found.boundary.push_back(&edge); });
        if (measures != CutMeasures::WidthsAndAngles) return found;
        std::copy_if(found.swept.begin(), found.swept.end(), std::back_inserter(found.swept_before),
                     [&](const SweptWay* way) {
                         return std::none_of(last.begin(), last.end(), [&](const Edge& edge) {
                             return edge.from == way->edge.from && edge.to() == way->edge.to() &&
                                    edge.segment.arc == way->edge.segment.arc;
                         });
                     });
        return found;
    }

    void measure(const Edge& edge, const Level& level, double z_mm, const std::optional<Vec2>& along,
                 Known& into) const {
        const std::vector<double> places = placesAlong(edge, radius_mm);
        into.widths_mm.assign(places.size(), 0);
        if (z_mm >= ground.top_z_mm - kSameCutHeightMm) return;
        const Around whole = around(grown(edge.box, radius_mm), level, z_mm + kSameCutHeightMm);
        // Without a boundary near, all of the way is inside, or none of it.
        const bool inside = whole.boundary.empty() && ground.target.contains(edge.from);
        if (whole.boundary.empty() && !inside) return;
        if (isShort(edge)) {
            Cut cut = cutAt(edge.to(), along.value_or(tangentAt(edge, 1)), whole, inside);
            if (!along) cut = anyWay(cut);
            into.widths_mm.assign(places.size(), cut.width_mm);
            into.engaged_rad = cut.engaged_rad;
            return;
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Cut cut = cutAt(pointAt(edge, places[i]), tangentAt(edge, places[i]), whole, inside);
            into.widths_mm[i] = cut.width_mm;
            into.engaged_rad = std::max(into.engaged_rad, cut.engaged_rad);
        }
    }

    Cut cutAt(const Vec2& at, const Vec2& direction, const Around& whole, bool inside) const {
        const Box2 near = grown(Box2(at), radius_mm);
        Rim rim(at, direction, radius_mm);
        for (const SweptWay* way : whole.swept) {
            if (!way->box.intersects(near)) continue;
            rim.cover(way->edge, way->radius_mm - cusp_share * radius_mm);
        }
        if (rim.isCovered()) return {};
        Cut cut;
        cut.width_mm = inside ? rim.freeWidthMm() : rim.freeWidthInMm(ground.target, whole.boundary);
        if (measures != CutMeasures::WidthsAndAngles) return cut;
        Rim beyond_grazes(at, direction, radius_mm);
        for (const SweptWay* way : whole.swept_before)
            if (way->box.intersects(near))
                beyond_grazes.cover(way->edge, way->radius_mm + kGrazeShare * radius_mm);
        const Rim::Spans deep = beyond_grazes.freeIn(ground.target, whole.boundary);
        cut.engaged_rad = rim.engagedIn(ground.target, whole.boundary, deep).angle_rad;
        return cut;
    }

    /// Of a cutter that may go any way: as wide as it is, where it cuts at all.
    Cut anyWay(const Cut& cut) const {
        return {cut.width_mm > 0 ? 2 * radius_mm : 0, cut.engaged_rad > 0 ? kPi : 0};
    }

    const CutGround::Impl& ground;
    double radius_mm;
    double step_down_mm;
    double cusp_share;
    CutMeasures measures;
    std::map<double, Level> levels;
    SweptWays slopes;
    Trail trail;
    /// The last ways of a pass, so long together that the rim ahead is farther than a graze from what came
    /// before: it is always near to what they themselves have swept.
    std::deque<Edge> last;
    std::map<EdgeKey, Heights> gone;
    std::map<Question, Known> answers;
    int last_state = 0;
};

CutFollower::CutFollower(const CutGround& ground, double radius_mm, double step_down_mm, double cusp_share,
                         CutMeasures measures)
    : impl_(new Impl{
          *ground.impl_, radius_mm, step_down_mm, cusp_share, measures, {}, {}, {}, {}, {}, {}, 0}) {}
CutFollower::~CutFollower() = default;

MoveCut CutFollower::next(const Vec3& from, const Move& move) {
    return impl_->next(from, move, true);
}

MoveCut CutFollower::nextDepth(const Vec3& from, const Move& move) {
    return impl_->next(from, move, false);
}

}  // namespace stepmill
