// The motions of a machine.

#include <cmath>

#include <fmt/format.h>

#include "post/reader/arc.h"
#include "post/reader/machine.h"

namespace stepmill::reader {
namespace {

/// In inverse time LinuxCNC goes no slower than this many of the program's units a minute.
constexpr double kLeastInverseFeed = 0.1;

}  // namespace

/// G28 and G30: a rapid to the place the words name, from there to the axes' own. Without words all axes go.
void Machine::goHome(const Block& block) {
    if (!block.has(ModalGroup::NonModal, code(28)) && !block.has(ModalGroup::NonModal, code(30))) return;
    const bool all = !block.hasAny("XYZ");
    if (all && rules_.goes_home) refuse("G28 without axis words");
    if (!all) goTo(Motion{}, target(block));
    Place home = at_;
    if (all || block.has('X')) home.x.reset();
    if (all || block.has('Y')) home.y.reset();
    if (all || block.has('Z')) home.z.reset();
    home.z_home = at_.z_home || all || block.has('Z');
    toMachinePlace(home, all || block.hasAny("XY"));
}

void Machine::move(const Block& block, int motion) {
    if (!isCycle(motion)) cycles_from_.reset();
    if (block.has(ModalGroup::NonModal, code(53))) {
        moveInMachine(block);
    } else if (isCycle(motion)) {
        drill(block, motion);
    } else if (isArc(motion)) {
        arc(block, motion == code(3));
    } else {
        straight(block, motion);
    }
    motion_ = motion;
}

void Machine::moveInMachine(const Block& block) {
    Place to = at_;
    if (block.has('X')) to.x.reset();
    if (block.has('Y')) to.y.reset();
    if (const auto z = block.number('Z')) {
        if (*z != 0) refuse("G53 with another Z than 0, the top of the machine's travel");
        to.z.reset();
        to.z_home = true;
    }
    if (block.hasAny("XYZ")) toMachinePlace(to, block.hasAny("XY"));
}

void Machine::straight(const Block& block, int motion) {
    if (motion == code(0)) {
        if (block.hasAny("XYZ")) goTo(Motion{}, target(block));
        return;
    }
    if (!block.hasAny("XYZ")) return;
    if (!at_.known()) refuse("a feed from a place that is not known");
    const Place to = target(block);
    const double length_mm = std::hypot(*to.x - *at_.x, *to.y - *at_.y, *to.z - *at_.z);
    Motion feed;
    feed.kind = MotionKind::Feed;
    feed.feed_mm_per_min = feedFor(block, length_mm);
    goTo(feed, to);
}

void Machine::arc(const Block& block, bool ccw) {
    if (state_.plane != Plane::XY) refuse("an arc is read in G17 alone");
    if (!at_.known()) refuse("a feed from a place that is not known");
    const Place to = target(block);
    const Vec2 from_xy(*at_.x, *at_.y);
    const Vec2 to_xy(*to.x, *to.y);
    const ArcWords words{lengthOf(block, 'I'), lengthOf(block, 'J'), lengthOf(block, 'R'),
                         arc_centre_absolute_};
    const ArcShape shape = arcShape(from_xy, to_xy, ccw, words, *where_);
    Motion motion;
    motion.kind = MotionKind::Arc;
    motion.centre = shape.centre;
    motion.ccw = ccw;
    motion.turns = static_cast<int>(std::round(block.number('P').value_or(1)));
    motion.radii_differ_mm = shape.radii_differ_mm;
    motion.feed_mm_per_min =
        feedFor(block, arcLengthMm(from_xy, to_xy, shape.centre, ccw, motion.turns, *to.z - *at_.z));
    goTo(motion, to);
}

Place Machine::target(const Block& block) const {
    if (!state_.distance && block.hasAny("XYZ")) refuse("a motion before G90 or G91");
    Place to = at_;
    to.x = axisTarget(block, 'X', at_.x);
    to.y = axisTarget(block, 'Y', at_.y);
    to.z = axisTarget(block, 'Z', at_.z);
    to.z_home = at_.z_home && !to.z;
    return to;
}

std::optional<double> Machine::axisTarget(const Block& block, char letter,
                                          const std::optional<double>& at) const {
    const auto number = lengthOf(block, letter);
    if (!number) return at;
    if (state_.distance == DistanceMode::Absolute) return snapToGrid(*number);
    if (!at && *number != 0) refuse(fmt::format("{} by a distance from a place that is not known", letter));
    return at ? std::optional(snapToGrid(*at + *number)) : std::nullopt;
}

/// The feed of a motion, in mm/min whatever the mode.
double Machine::feedFor(const Block& block, double length_mm) const {
    if (state_.feed_mode == FeedMode::InverseTime) {
        const auto per_min = block.number('F');
        if (!per_min || *per_min <= 0) refuse("a feed in inverse time without F");
        return std::max(kLeastInverseFeed * unit(), length_mm * *per_min);
    }
    if (feed_ <= 0) refuse("a feed without F");
    return state_.feed_mode == FeedMode::PerRevolution ? feed_ * state_.speed_rpm : feed_;
}

void Machine::goTo(Motion motion, const Place& to) {
    motion.across = to.x != at_.x || to.y != at_.y;
    motion.names_place = true;
    go(motion, to);
}

void Machine::toMachinePlace(const Place& to, bool across) {
    Motion motion;
    motion.across = across;
    go(motion, to);
}

void Machine::go(Motion motion, const Place& to) {
    if (motion.across && !at_.z && !at_.z_home) refuse("moves across before its height is known");
    motion.from = at_;
    motion.to = to;
    at_ = to;
    act(motion);
}

}  // namespace stepmill::reader
