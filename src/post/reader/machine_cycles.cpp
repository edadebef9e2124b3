// The canned cycles of a machine [RS274/NGC, 3.5.16].

#include <fmt/format.h>

#include "post/reader/machine.h"
#include "stepmill/core/units.h"

namespace stepmill::reader {
namespace {

/// From where LinuxCNC feeds again after a peck: a hundredth of an inch over its bottom [mm].
constexpr double kOverPeckMm = 0.01 * kMillimetresPerInch;
/// More pecks in a hole are a slip in Q.
constexpr double kMostPecks = 10000;

}  // namespace

CycleWords Machine::cycleWords(const Block& block, int cycle) const {
    const bool goes_on = motion_ == cycle;
    const auto take = [&](char letter, double& kept) {
        lengthOf(block, letter);  // refuses what is no length
        if (!goes_on && !block.has(letter))
            refuse(fmt::format("{} without {}", codeName('G', cycle), letter));
        kept = block.number(letter).value_or(kept);
    };
    CycleWords words = cycle_;
    take('Z', words.z);
    take('R', words.r);
    if (cycle == code(83)) take('Q', words.q);
    if (cycle != code(82)) return words;
    if (!goes_on && !block.has('P')) refuse("G82 without P");
    if (block.has('P')) words.dwell_s = dwellSeconds(block.words().at('P'));
    return words;
}

void Machine::drill(const Block& block, int cycle) {
    if (state_.plane != Plane::XY) refuse("a cycle is read in G17 alone");
    if (!back_to_start_) refuse("a cycle before G98 or G99");
    if (state_.feed_mode == FeedMode::InverseTime) refuse("a cycle in inverse time (G93)");
    if (feed_ <= 0) refuse("a feed without F");
    Place over = target(block);
    if (!over.knowsXY() || !at_.z) refuse("a hole from a place that is not known");
    cycle_ = cycleWords(block, cycle);
    const bool incremental = state_.distance == DistanceMode::Incremental;
    // Cycles in a row come back to, and count from, the height the first of them began at.
    if (!cycles_from_) cycles_from_ = *at_.z;
    double start_mm = *cycles_from_;
    // In the program's numbers, so that pecks are counted as the controller counts them.
    const double r = incremental ? cycle_.r + start_mm / unit() : cycle_.r;
    const double bottom = incremental ? r + cycle_.z : cycle_.z;
    if (r < bottom) refuse("the hole's bottom (Z) is above R");
    if (start_mm < snapToGrid(length(r))) {
        goToHeight(MotionKind::Rapid, r * unit());
        start_mm = *at_.z;
    }
    const double clear_mm = *back_to_start_ ? start_mm : r * unit();
    // From below R it goes straight to where it will retract to, as LinuxCNC does.
    over.z = *at_.z > snapToGrid(r * unit()) ? *at_.z : snapToGrid(clear_mm);
    goTo(Motion{}, over);
    goToHeight(MotionKind::Rapid, r * unit());
    feedDown(cycle, cycle_, r, bottom, clear_mm);
}

void Machine::feedDown(int cycle, const CycleWords& words, double r, double bottom, double clear_mm) {
    if (cycle == code(83)) {
        if (words.q <= 0) refuse("Q is not over zero");
        if ((r - bottom) / words.q > kMostPecks) refuse(fmt::format("a hole of over {} pecks", kMostPecks));
        for (double depth = r - words.q; depth > bottom; depth -= words.q) {
            goToHeight(MotionKind::Feed, depth * unit());
            goToHeight(MotionKind::Rapid, r * unit());
            goToHeight(MotionKind::Rapid, depth * unit() + kOverPeckMm);
        }
    }
    goToHeight(MotionKind::Feed, bottom * unit());
    if (cycle == code(82)) act(Dwell{words.dwell_s, *at_.z});
    goToHeight(MotionKind::Rapid, clear_mm);
}

void Machine::goToHeight(MotionKind kind, double z_mm) {
    Motion motion;
    motion.kind = kind;
    if (kind == MotionKind::Feed)
        motion.feed_mm_per_min =
            state_.feed_mode == FeedMode::PerRevolution ? feed_ * state_.speed_rpm : feed_;
    Place to = at_;
    to.z = snapToGrid(z_mm);
    goTo(motion, to);
}

}  // namespace stepmill::reader
