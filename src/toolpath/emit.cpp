// From the plan view of a depth of cut to moves in space.

#include "toolpath/emit.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/path_parts.h"

namespace stepmill::toolpath {

namespace {

/// Lines whose directions differ by less than this become one move [rad].
constexpr double kStraightRad = 1e-9;

Vec3 at3(const Vec2& p, double z) {
    return {p.x(), p.y(), z};
}

/// How many times a piece of path must be gone along to descend at no more than the angle.
int timesAlong(double length_mm, const DepthHeights& heights) {
    const double drop = heights.above_mm + kDescentStartMm - heights.floor_mm;
    const double needed = drop / std::tan(heights.ramp_angle_rad);
    return std::max(1, static_cast<int>(std::ceil(needed / length_mm - 1e-9)));
}

/// Heights in programs, of a move's both ends, may differ from the path's by so much [mm].
constexpr double kPostedHeightsMm = 3e-4;

}  // namespace

double sinkingFeed(double plunge_feed_mm_per_min, double length_mm, double drop_mm) {
    return plunge_feed_mm_per_min * length_mm / (drop_mm + kPostedHeightsMm);
}

void MoveWriter::writeDepth(const std::vector<ScriptStep>& script, Over first_over,
                            const DepthHeights& heights) {
    heights_ = heights;
    for (std::size_t i = 0; i < script.size(); ++i) {
        ScriptStep step = script[i];
        if (i == 0) setOver(step, first_over);
        std::visit([this](const auto& s) { write(s); }, step);
    }
}

void MoveWriter::writeRing(const Path& ring, double descent_mm, Over first_over,
                           const std::vector<DepthHeights>& depths) {
    const Path rest = firstPart(ring, length(ring) - descent_mm);
    const Path ramp = reversed(firstPart(reversed(ring), descent_mm));
    heights_ = depths.front();
    descendTo(ramp.start, first_over);
    for (const DepthHeights& heights : depths) {
        heights_ = heights;
        along(ramp, MoveKind::Ramp, heights.floor_mm);
        along(rest, levelKind(), heights.floor_mm);
    }
    along(ramp, levelKind(), heights_.floor_mm);
}

void MoveWriter::write(const ComeDown& step) {
    // From a deeper place that was just cleared: straight up.
    if (at_.head<2>() == step.at && at_.z() < heights_.floor_mm && !path_.moves.empty())
        return add(MoveKind::Rapid, at3(step.at, heights_.floor_mm));
    const double ground_mm = step.deep ? heights_.last_floor_mm : heights_.floor_mm;
    approach(step.at, std::max(heights_.floor_mm, ground_mm + kApproachMm), step.over);
    add(MoveKind::Plunge, at3(step.at, heights_.floor_mm), std::nullopt, true);
}

void MoveWriter::write(const RampDown& step) {
    descendTo(step.from, step.over);
    const double from_z = at_.z();
    // Oddly many legs end at the far end, from where a level one comes back and takes the slope away.
    int legs = timesAlong((step.to - step.from).norm(), heights_);
    if ((legs % 2 == 1) != step.level) ++legs;
    for (int i = 1; i <= legs; ++i)
        add(MoveKind::Ramp,
            at3(i % 2 == 1 ? step.to : step.from, from_z + (heights_.floor_mm - from_z) * i / legs));
    if (step.level) add(levelKind(), at3(step.from, heights_.floor_mm));
}

/// Has the depth before come another such step deeper, beyond the first?
bool MoveWriter::liftsForChips(double each_mm) const {
    if (each_mm <= 0 || path_.moves.empty()) return false;
    const double deep_mm = heights_.stock_top_mm - heights_.above_mm;
    const double before_mm = deep_mm - (heights_.above_mm - heights_.floor_mm);
    return deep_mm >= 2 * each_mm && std::floor(deep_mm / each_mm) > std::floor(before_mm / each_mm);
}

void MoveWriter::write(const PlungeDown& step) {
    const bool lifts = liftsForChips(step.lifts_each_mm);
    if (lifts) {
        retract();
        path_.moves.back().for_chips = true;
    }
    descendTo(step.at, lifts ? Over::Retract : step.over);
    add(MoveKind::Plunge, at3(step.at, heights_.floor_mm));
}

void MoveWriter::write(const RampAlong& step) {
    descendTo(step.lead.start, step.over);
    const double from_z = at_.z();
    const double lead_mm = length(step.lead);
    const double turn_mm = step.closed ? length(step.curve) : 2 * lead_mm;
    const double whole_mm = (step.closed ? lead_mm : 0) + step.turns * turn_mm;
    double gone_mm = 0;
    const std::size_t first = path_.moves.size();
    const auto down = [&](const Path& path, double length_mm) {
        gone_mm += length_mm;
        along(path, MoveKind::Ramp, from_z + (heights_.floor_mm - from_z) * (gone_mm / whole_mm));
    };
    if (step.closed && !step.lead.segments.empty()) down(step.lead, lead_mm);
    for (int i = 0; i < step.turns; ++i) {
        if (step.closed) {
            down(step.curve, turn_mm);
        } else {
            down(step.lead, lead_mm);
            down(reversed(step.lead), lead_mm);
        }
    }
    at_.z() = path_.moves.back().to.z() = heights_.floor_mm;
    if (step.feed_mm_per_min > 0) feedHelix(first, step.feed_mm_per_min);
    if (step.level) along(step.curve, levelKind(), heights_.floor_mm);
}

void MoveWriter::feedHelix(std::size_t first, double feed_mm_per_min) {
    Vec3 from = first > 0 ? path_.moves[first - 1].to : path_.start;
    for (std::size_t i = first; i < path_.moves.size(); ++i) {
        Move& move = path_.moves[i];
        const double drop_mm = from.z() - move.to.z();
        const double flat_mm = length(Vec2(from.head<2>()), {Vec2(move.to.head<2>()), move.arc});
        move.feed_mm_per_min = std::min(feed_mm_per_min, sinkingFeed(path_.plunge_feed_mm_per_min,
                                                                     std::hypot(flat_mm, drop_mm), drop_mm));
        from = move.to;
    }
}

void MoveWriter::write(const Link& step) {
    add(step.wide ? MoveKind::Slot : MoveKind::Feed, at3(step.to, heights_.floor_mm), std::nullopt,
        step.in_air);
}

void MoveWriter::write(const Cut& step) {
    if (step.wide.empty()) return along(step.path, MoveKind::Feed, heights_.floor_mm);
    Vec2 from = step.path.start;
    for (std::size_t i = 0; i < step.path.segments.size(); ++i) {
        const Segment& segment = step.path.segments[i];
        along(Path{from, {segment}}, step.wide[i] ? MoveKind::Slot : MoveKind::Feed, heights_.floor_mm);
        from = segment.to;
    }
}

void MoveWriter::write(const Glide& step) {
    const auto glide = [&](const Vec3& to) {
        if (to == at_) return;
        path_.moves.push_back({MoveKind::Feed, to, std::nullopt, true, step.feed_mm_per_min});
        at_ = to;
    };
    const double z_mm = heights_.floor_mm + step.lift_mm;
    glide(at3(at_.head<2>(), z_mm));
    for (const Vec2& point : step.way)
        glide(at3(point, z_mm));
    glide(at3(at_.head<2>(), heights_.floor_mm));
}

double MoveWriter::crossingZ(Over over) const {
    if (over == Over::Retract) return heights_.retract_mm;
    const double ground = over == Over::LastFloor ? heights_.above_mm : heights_.top_mm;
    return std::min(ground + kApproachMm, heights_.retract_mm);
}

void MoveWriter::approach(const Vec2& at, double clear_z_mm, Over over) {
    if (path_.moves.empty()) {
        path_.start = at3(at, heights_.retract_mm);
        at_ = path_.start;
    }
    if (at_.head<2>() != at) {
        const double z = std::max(at_.z(), crossingZ(over));
        add(MoveKind::Rapid, Vec3(at_.x(), at_.y(), z));
        add(MoveKind::Rapid, at3(at, z));
    }
    add(MoveKind::Rapid, at3(at, std::min(clear_z_mm, at_.z())));
}

/// Is the way along the floor of the depth before quicker than the last of the way down from over it?
bool MoveWriter::staysDown(const Vec2& at) const {
    if (path_.moves.empty() || at_.z() != heights_.above_mm) return false;
    const double fed_down_mm = kApproachMm - kDescentStartMm;
    return (at - at_.head<2>()).norm() / path_.feed_mm_per_min <= fed_down_mm / path_.plunge_feed_mm_per_min;
}

/// To the place where a descent through the material of this depth begins.
void MoveWriter::descendTo(const Vec2& at, Over over) {
    if (over == Over::LastFloor && staysDown(at))
        return add(MoveKind::Feed, at3(at, at_.z()), std::nullopt, true);
    approach(at, heights_.above_mm + kApproachMm, over);
    const double from_z = std::min(heights_.above_mm + kDescentStartMm, at_.z());
    add(MoveKind::Plunge, at3(at, from_z), std::nullopt, true);
}

void MoveWriter::retract() {
    if (at_.z() < heights_.retract_mm) add(MoveKind::Rapid, Vec3(at_.x(), at_.y(), heights_.retract_mm));
}

void MoveWriter::along(const Path& path, MoveKind kind, double to_z_mm) {
    if (path.segments.empty()) return;
    const double whole = length(path);
    const double from_z = at_.z();
    double gone = 0;
    for (const Edge& edge : edgesOf(path)) {
        const double part = length(edge);
        const auto z = [&](double share) {
            return to_z_mm == from_z ? to_z_mm : from_z + (to_z_mm - from_z) * (gone + share * part) / whole;
        };
        const Vec2& to = edge.segment.to;
        // End where it starts means nothing to a controller: a full circle goes out as two halves.
        if (edge.segment.arc && edge.from == to)
            add(kind, at3(snapToGrid(pointAt(edge, 0.5)), z(0.5)), edge.segment.arc);
        add(kind, at3(to, z(1)), edge.segment.arc);
        gone += part;
    }
    // The last share is 1 but for rounding; the next depth counts on the exact level.
    if (path_.moves.back().kind == kind) path_.moves.back().to.z() = to_z_mm;
    at_.z() = to_z_mm;
}

void MoveWriter::add(MoveKind kind, const Vec3& to, const std::optional<Arc>& arc, bool in_air) {
    if (to == at_ && !arc) return;
    const Vec3 step = to - at_;
    if (!arc && kind == MoveKind::Feed && !path_.moves.empty()) {
        Move& last = path_.moves.back();
        const Vec3 start = path_.moves.size() > 1 ? path_.moves[path_.moves.size() - 2].to : path_.start;
        const Vec3 before = last.to - start;
        const bool goes_on = last.kind == kind && !last.arc && last.in_air == in_air &&
                             before.dot(step) > 0 &&
                             before.cross(step).norm() <= kStraightRad * before.norm() * step.norm();
        if (goes_on) {
            last.to = to;
            at_ = to;
            return;
        }
    }
    path_.moves.push_back({kind, to, arc, in_air});
    at_ = to;
}

}  // namespace stepmill::toolpath
