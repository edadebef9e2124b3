// How wide and how deep the moves of an operation cut.

#include "stepmill/toolpath/cut_ground.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <tuple>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge_index.h"
#include "toolpath/engagement/rim.h"
#include "toolpath/engagement/swept_ways.h"

namespace stepmill {
namespace {

using toolpath::EdgeKey;
using toolpath::keyOf;
using toolpath::Rim;
using toolpath::SweptWay;
using toolpath::SweptWays;

/// Positions along a move, as a share of the radius.
constexpr double kStepShare = 0.2;
/// The first and the last position lie so far inside the move, as a share of the radius: where it ends at the
/// end of an earlier way the rim only touches what lies beyond.
constexpr double kInsideShare = 0.05;
/// Longer arcs are looked at as two halves, as programs have them.
constexpr double kLongestSweepRad = 1.5 * kPi;

Edge edgeOf(const Vec3& from, const Move& move) {
    return makeEdge(from.head<2>(), {Vec2(move.to.head<2>()), move.arc});
}

bool isFlat(const Vec3& from, const Move& move) {
    return move.arc || from.head<2>() != move.to.head<2>();
}

int stepsAlong(const Edge& edge, double radius_mm) {
    const double step_mm = kStepShare * radius_mm;
    const auto stepsOf = [&](double length_mm) {
        return std::max(1, static_cast<int>(std::ceil(length_mm / step_mm)));
    };
    const std::optional<Arc>& arc = edge.segment.arc;
    if (arc && std::abs(sweepAngle(edge.from, edge.to(), *arc)) > kLongestSweepRad)
        return 2 * stepsOf(length(edge) / 2);
    return stepsOf(length(edge));
}

}  // namespace

struct CutGround::Impl {
    Region target;
    EdgeIndex boundary;
    double top_z_mm;
    SweptWays swept;
};

CutGround::CutGround(Region target, double top_z_mm) : impl_(std::make_unique<Impl>()) {
    impl_->boundary = EdgeIndex(target);
    impl_->target = std::move(target);
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
        std::vector<double> widths_mm;
        double widest_mm = 0;
    };
    /// State of the level, what earlier operations and slopes have swept down to it, where the way begins,
    /// and the way.
    using Question = std::tuple<int, std::uint64_t, std::uint64_t, double, double, EdgeKey>;
    /// Heights at which a line or arc was gone along last, at the ends as its key has them.
    struct Heights {
        double first_mm;
        double second_mm;
    };

    MoveCut next(const Vec3& from, const Move& move) {
        if (move.kind == MoveKind::Rapid) return {};
        const double low_mm = std::min(from.z(), move.to.z());
        const double high_mm = std::max(from.z(), move.to.z());
        const Edge edge = edgeOf(from, move);
        if (!isFlat(from, move)) {
            if (move.to.z() < from.z()) enter(edge, levelAt(low_mm), low_mm);
            return {};
        }
        MoveCut cut;
        cut.depth_mm = depthOf(edge, from.z(), move.to.z());
        if (high_mm - low_mm > kSameCutHeightMm) {
            cut.widest_mm = 2 * radius_mm;
            slopes.add(edge, radius_mm, high_mm);
            return cut;
        }
        const Known& found = lookUp(edge, levelAt(low_mm), low_mm);
        cut.widths_mm = &found.widths_mm;
        cut.widest_mm = found.widest_mm;
        return cut;
    }

    double depthOf(const Edge& edge, double from_z_mm, double to_z_mm) {
        const EdgeKey key = keyOf(edge);
        const bool turned = key[0] != edge.from.x() || key[1] != edge.from.y();
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

    const Known& lookUp(const Edge& edge, Level& level, double z_mm) {
        bool is_new = false;
        Known& found = answerTo(edge, level, z_mm, is_new);
        if (is_new) {
            found.widths_mm = widthsOf(edge, level, z_mm);
            found.widest_mm = *std::max_element(found.widths_mm.begin(), found.widths_mm.end());
        }
        level.state = found.state;
        level.swept.add(edge, radius_mm, z_mm);
        return found;
    }

    /// Straight down: no width is asked for.
    void enter(const Edge& edge, Level& level, double z_mm) {
        bool is_new = false;
        level.state = answerTo(edge, level, z_mm, is_new).state;
        level.swept.add(edge, radius_mm, z_mm);
    }

    Known& answerTo(const Edge& edge, const Level& level, double z_mm, bool& is_new) {
        const double down_to_mm = z_mm + kSameCutHeightMm;
        const Question question{level.state,
                                ground.swept.setOf(down_to_mm),
                                slopes.setOf(down_to_mm),
                                edge.from.x(),
                                edge.from.y(),
                                keyOf(edge)};
        const auto answer = answers.try_emplace(question);
        is_new = answer.second;
        if (is_new) answer.first->second.state = ++last_state;
        return answer.first->second;
    }

    /// The ways and edges that may matter to a rim somewhere on an edge.
    struct Around {
        std::vector<const SweptWay*> swept;
        std::vector<const Edge*> boundary;
    };

    Around around(const Box2& box, const Level& level, double down_to_mm) const {
        Around found;
        const auto add = [&](const SweptWay& way) { found.swept.push_back(&way); };
        level.swept.forEachNear(box, down_to_mm, add);
        slopes.forEachNear(box, down_to_mm, add);
        ground.swept.forEachNear(box, down_to_mm, add);
        ground.boundary.forEachIn(box, [&](const Edge& edge) { found.boundary.push_back(&edge); });
        return found;
    }

    std::vector<double> widthsOf(const Edge& edge, const Level& level, double z_mm) const {
        const int steps = stepsAlong(edge, radius_mm);
        std::vector<double> widths(static_cast<std::size_t>(steps) + 1, 0);
        if (z_mm >= ground.top_z_mm - kSameCutHeightMm) return widths;
        const Around whole = around(grown(edge.box, radius_mm), level, z_mm + kSameCutHeightMm);
        // Without a boundary near, all of the way is inside, or none of it.
        const bool inside = whole.boundary.empty() && contains(ground.target, edge.from);
        if (whole.boundary.empty() && !inside) return widths;
        const double inside_share = std::min(0.25, kInsideShare * radius_mm / length(edge));
        for (int i = 0; i <= steps; ++i) {
            const double share = std::clamp(static_cast<double>(i) / steps, inside_share, 1 - inside_share);
            Rim rim(pointAt(edge, share), tangentAt(edge, share), radius_mm);
            for (const SweptWay* way : whole.swept)
                rim.cover(way->edge, way->radius_mm - cusp_share * radius_mm);
            if (rim.isCovered()) continue;
            widths[static_cast<std::size_t>(i)] =
                inside ? rim.freeWidthMm() : rim.freeWidthInMm(ground.target, whole.boundary);
        }
        return widths;
    }

    const CutGround::Impl& ground;
    double radius_mm;
    double step_down_mm;
    double cusp_share;
    std::map<double, Level> levels;
    SweptWays slopes;
    std::map<EdgeKey, Heights> gone;
    std::map<Question, Known> answers;
    int last_state = 0;
};

CutFollower::CutFollower(const CutGround& ground, double radius_mm, double step_down_mm, double cusp_share)
    : impl_(new Impl{*ground.impl_, radius_mm, step_down_mm, cusp_share, {}, {}, {}, {}, 0}) {}
CutFollower::~CutFollower() = default;

MoveCut CutFollower::next(const Vec3& from, const Move& move) {
    return impl_->next(from, move);
}

}  // namespace stepmill
