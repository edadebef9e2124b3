// The canned cycles of a machine [RS274/NGC, 3.5.16].

#include "post/reader/cycles.h"

#include <fmt/format.h>

#include "post/reader/moves.h"
#include "stepmill/core/units.h"

namespace stepmill::reader {
namespace {

/// From where LinuxCNC feeds again after a peck: a hundredth of an inch over its bottom [mm].
constexpr double kOverPeckMm = 0.01 * kMillimetresPerInch;
/// More pecks in a hole are a slip in Q.
constexpr double kMostPecks = 10000;

bool pecks(int cycle) {
    return cycle == code(73) || cycle == code(83);
}

bool dwells(int cycle) {
    return cycle == code(82) || cycle == code(89);
}

/// The drill goes up with the feed too.
bool feedsOut(int cycle) {
    return cycle == code(85) || cycle == code(89);
}

CycleWords cycleWords(const Control& control, const Block& block, int cycle) {
    const bool goes_on = control.motion_in_force == cycle;
    const auto take = [&](char letter, double& kept) {
        control.lengthOf(block, letter);  // refuses what is no length
        if (!goes_on && !block.has(letter))
            control.refuse(fmt::format("{} without {}", codeName('G', cycle), letter));
        kept = block.number(letter).value_or(kept);
    };
    CycleWords words = control.cycle;
    take('Z', words.z);
    take('R', words.r);
    if (pecks(cycle)) take('Q', words.q);
    if (!dwells(cycle)) return words;
    if (!goes_on && !block.has('P')) control.refuse(codeName('G', cycle) + " without P");
    if (block.has('P')) words.dwell_s = control.dwellSeconds(block.words().at('P'));
    return words;
}

/// To a height with the spindle's turns.
void goCoupled(Control& control, double z_mm, double pitch_mm) {
    Motion motion;
    motion.kind = MotionKind::Feed;
    motion.pitch_mm = pitch_mm;
    motion.feed_mm_per_min = pitch_mm * control.state.speed_rpm;
    Place to = control.at;
    to.z = snapToGrid(z_mm);
    control.goTo(motion, to);
}

void tapDown(Control& control, double r, double bottom, double clear_mm) {
    if (!control.rigid_tapping)
        control.refuse("G84 without M29 before it: the feed may not be coupled to the spindle");
    if (control.state.feed_mode != FeedMode::PerMinute) control.refuse("G84 in another feed mode than G94");
    const double pitch_mm = control.feed / control.state.speed_rpm;
    goCoupled(control, bottom * control.unit(), pitch_mm);
    goCoupled(control, r * control.unit(), pitch_mm);
    control.goToHeight(MotionKind::Rapid, clear_mm);
}

void feedDown(Control& control, int cycle, const CycleWords& words, double r, double bottom,
              double clear_mm) {
    if (pecks(cycle)) {
        if (words.q <= 0) control.refuse("Q is not over zero");
        if ((r - bottom) / words.q > kMostPecks)
            control.refuse(fmt::format("a hole of over {} pecks", kMostPecks));
        for (double depth = r - words.q; depth > bottom; depth -= words.q) {
            control.goToHeight(MotionKind::Feed, depth * control.unit());
            if (cycle == code(83)) control.goToHeight(MotionKind::Rapid, r * control.unit());
            control.goToHeight(MotionKind::Rapid, depth * control.unit() + kOverPeckMm);
        }
    }
    control.goToHeight(MotionKind::Feed, bottom * control.unit());
    if (dwells(cycle)) control.act(Dwell{words.dwell_s, *control.at.z});
    if (feedsOut(cycle)) control.goToHeight(MotionKind::Feed, r * control.unit());
    control.goToHeight(MotionKind::Rapid, clear_mm);
}

}  // namespace

void drill(Control& control, const Block& block, int cycle) {
    if (control.state.plane != Plane::XY) control.refuse("a cycle is read in G17 alone");
    if (!control.back_to_start) control.refuse("a cycle before G98 or G99");
    if (control.state.feed_mode == FeedMode::InverseTime) control.refuse("a cycle in inverse time (G93)");
    if (control.feed <= 0) control.refuse("a feed without F");
    Place over = target(control, block);
    if (!over.knowsXY() || !control.at.z) control.refuse("a hole from a place that is not known");
    control.cycle = cycleWords(control, block, cycle);
    const bool incremental = control.state.distance == DistanceMode::Incremental;
    // Cycles in a row come back to, and count from, the height the first of them began at.
    if (!control.cycles_from) control.cycles_from = *control.at.z;
    double start_mm = *control.cycles_from;
    // In the program's numbers, so that pecks are counted as the controller counts them.
    const double r = incremental ? control.cycle.r + start_mm / control.unit() : control.cycle.r;
    const double bottom = incremental ? r + control.cycle.z : control.cycle.z;
    if (r < bottom) control.refuse("the hole's bottom (Z) is above R");
    if (start_mm < snapToGrid(control.length(r))) {
        control.goToHeight(MotionKind::Rapid, r * control.unit());
        start_mm = *control.at.z;
    }
    const double clear_mm = *control.back_to_start ? start_mm : r * control.unit();
    // From below R it goes straight to where it will retract to, as LinuxCNC does.
    over.z = *control.at.z > snapToGrid(r * control.unit()) ? *control.at.z : snapToGrid(clear_mm);
    control.goTo(Motion{}, over);
    control.goToHeight(MotionKind::Rapid, r * control.unit());
    if (cycle == code(84)) return tapDown(control, r, bottom, clear_mm);
    feedDown(control, cycle, control.cycle, r, bottom, clear_mm);
}

void tap(Control& control, const Block& block) {
    if (control.state.plane != Plane::XY) control.refuse("G33.1 is read in G17 alone");
    if (!control.at.known()) control.refuse("G33.1 from a place that is not known");
    if (control.state.spin == Spin::Off || control.state.speed_rpm <= 0)
        control.refuse("G33.1 while the spindle does not turn");
    const double pitch_mm = control.lengthOf(block, 'K').value();
    if (pitch_mm <= 0) control.refuse("K is not over zero");
    const Place from = control.at;
    const Place to = target(control, block);
    if (to.x != from.x || to.y != from.y) control.refuse("G33.1 at a slant");
    if (*to.z >= *from.z) control.refuse("G33.1 that does not go down");
    goCoupled(control, *to.z, pitch_mm);
    goCoupled(control, *from.z, pitch_mm);
}

}  // namespace stepmill::reader
