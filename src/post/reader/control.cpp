#include "post/reader/control.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "stepmill/core/units.h"

namespace stepmill::reader {
namespace {

/// No machine is larger; lengths beyond are slips that would only overflow [mm].
constexpr double kLargestMm = 1e5;
/// In inverse time LinuxCNC goes no slower than this many of the program's units a minute.
constexpr double kLeastInverseFeed = 0.1;

}  // namespace

double Control::unit() const {
    if (mm_per_unit == 0) refuse("a length before G20 or G21");
    return mm_per_unit;
}

double Control::length(double number) const {
    const double mm = number * unit();
    if (std::abs(mm) > kLargestMm) refuse(fmt::format("{:g} mm is more than any machine goes", mm));
    return mm;
}

std::optional<double> Control::lengthOf(const Block& block, char letter) const {
    const auto number = block.number(letter);
    if (!number) return std::nullopt;
    if (rules.sticks_to_point && *number != 0 && !block.words().at(letter).has_point)
        refuse(fmt::format("{}{:g} without a decimal point counts last decimals on some controls", letter,
                           *number));
    return length(*number);
}

double Control::dwellSeconds(const Word& word) const {
    if (rules.dwell_in_ms && word.has_point) refuse("P of a dwell is in whole milliseconds");
    return rules.dwell_in_ms ? word.value / 1000 : word.value;
}

bool Control::changesUnits(const Block& block) const {
    const auto units = block.codeOf(ModalGroup::Units);
    return units && mm_per_unit != (*units == code(20) ? kMillimetresPerInch : 1);
}

double Control::feedFor(const Block& block, double length_mm) const {
    if (state.feed_mode == FeedMode::InverseTime) {
        const auto per_min = block.number('F');
        if (!per_min || *per_min <= 0) refuse("a feed in inverse time without F");
        return std::max(kLeastInverseFeed * unit(), length_mm * *per_min);
    }
    if (feed <= 0) refuse("a feed without F");
    return state.feed_mode == FeedMode::PerRevolution ? feed * state.speed_rpm : feed;
}

void Control::goTo(Motion motion, const Place& to) {
    motion.across = to.x != at.x || to.y != at.y;
    motion.names_place = true;
    go(motion, to);
}

void Control::goToHeight(MotionKind kind, double z_mm) {
    Motion motion;
    motion.kind = kind;
    if (kind == MotionKind::Feed)
        motion.feed_mm_per_min = state.feed_mode == FeedMode::PerRevolution ? feed * state.speed_rpm : feed;
    Place to = at;
    to.z = snapToGrid(z_mm);
    goTo(motion, to);
}

void Control::toMachinePlace(const Place& to, bool across) {
    Motion motion;
    motion.across = across;
    go(motion, to);
}

void Control::go(Motion motion, const Place& to) {
    if (motion.across && !at.z && !at.z_home) refuse("moves across before its height is known");
    motion.from = at;
    motion.to = to;
    at = to;
    act(motion);
}

void Control::losePlace() {
    at = {.x = {}, .y = {}, .z = {}, .z_home = at.z_home};
}

void Control::act(Doing doing) {
    if (run.states.back() != state) run.states.push_back(state);
    run.actions.push_back({std::move(doing), where->line, run.states.size() - 1});
}

}  // namespace stepmill::reader
