// Motions but for cycles.

#include "post/reader/moves.h"

#include <cmath>

#include <fmt/format.h>

#include "post/reader/arc.h"
#include "post/reader/cycles.h"

namespace stepmill::reader {
namespace {

std::optional<double> axisTarget(const Control& control, const Block& block, char letter,
                                 const std::optional<double>& at) {
    const auto number = control.lengthOf(block, letter);
    if (!number) return at;
    if (control.state.distance == DistanceMode::Absolute) return snapToGrid(*number);
    if (!at && *number != 0)
        control.refuse(fmt::format("{} by a distance from a place that is not known", letter));
    return at ? std::optional(snapToGrid(*at + *number)) : std::nullopt;
}

void moveInMachine(Control& control, const Block& block) {
    Place to = control.at;
    if (block.has('X')) to.x.reset();
    if (block.has('Y')) to.y.reset();
    if (const auto z = block.number('Z')) {
        if (*z != 0) control.refuse("G53 with another Z than 0, the top of the machine's travel");
        to.z.reset();
        to.z_home = true;
    }
    if (block.hasAny("XYZ")) control.toMachinePlace(to, block.hasAny("XY"));
}

void straight(Control& control, const Block& block, int motion) {
    if (motion == code(0)) {
        if (block.hasAny("XYZ")) control.goTo(Motion{}, target(control, block));
        return;
    }
    if (!block.hasAny("XYZ")) return;
    if (!control.at.known()) control.refuse("a feed from a place that is not known");
    const Place to = target(control, block);
    const double length_mm = std::hypot(*to.x - *control.at.x, *to.y - *control.at.y, *to.z - *control.at.z);
    Motion feed;
    feed.kind = MotionKind::Feed;
    feed.feed_mm_per_min = control.feedFor(block, length_mm);
    control.goTo(feed, to);
}

void arc(Control& control, const Block& block, bool ccw) {
    if (control.state.plane != Plane::XY) control.refuse("an arc is read in G17 alone");
    if (!control.at.known()) control.refuse("a feed from a place that is not known");
    const Place to = target(control, block);
    const Vec2 from_xy(*control.at.x, *control.at.y);
    const Vec2 to_xy(*to.x, *to.y);
    const ArcWords words{control.lengthOf(block, 'I'), control.lengthOf(block, 'J'),
                         control.lengthOf(block, 'R'), control.arc_centre_absolute};
    const ArcShape shape = arcShape(from_xy, to_xy, ccw, words, *control.where);
    Motion motion;
    motion.kind = MotionKind::Arc;
    motion.centre = shape.centre;
    motion.ccw = ccw;
    motion.turns = static_cast<int>(std::round(block.number('P').value_or(1)));
    motion.radii_differ_mm = shape.radii_differ_mm;
    motion.feed_mm_per_min = control.feedFor(
        block, arcLengthMm(from_xy, to_xy, shape.centre, ccw, motion.turns, *to.z - *control.at.z));
    control.goTo(motion, to);
}

}  // namespace

Place target(const Control& control, const Block& block) {
    if (!control.state.distance && block.hasAny("XYZ")) control.refuse("a motion before G90 or G91");
    Place to = control.at;
    to.x = axisTarget(control, block, 'X', control.at.x);
    to.y = axisTarget(control, block, 'Y', control.at.y);
    to.z = axisTarget(control, block, 'Z', control.at.z);
    to.z_home = control.at.z_home && !to.z;
    return to;
}

void goHome(Control& control, const Block& block) {
    if (!block.has(ModalGroup::NonModal, code(28)) && !block.has(ModalGroup::NonModal, code(30))) return;
    const bool all = !block.hasAny("XYZ");
    if (all && control.rules.home_needs_axes) control.refuse("G28 without axis words");
    if (!all) control.goTo(Motion{}, target(control, block));
    Place home = control.at;
    if (all || block.has('X')) home.x.reset();
    if (all || block.has('Y')) home.y.reset();
    if (all || block.has('Z')) home.z.reset();
    home.z_home = control.at.z_home || all || block.has('Z');
    control.toMachinePlace(home, all || block.hasAny("XY"));
}

void move(Control& control, const Block& block, int motion) {
    if (!isCycle(motion)) control.cycles_from.reset();
    if (motion != code(84)) control.rigid_tapping = false;
    if (block.has(ModalGroup::NonModal, code(53))) {
        moveInMachine(control, block);
    } else if (isCycle(motion)) {
        drill(control, block, motion);
    } else if (motion == code(33, 1)) {
        tap(control, block);
    } else if (isArc(motion)) {
        arc(control, block, motion == code(3));
    } else {
        straight(control, block, motion);
    }
    control.motion_in_force = motion;
}

}  // namespace stepmill::reader
