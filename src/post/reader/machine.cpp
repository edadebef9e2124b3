#include "post/reader/machine.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/core/units.h"

namespace stepmill::reader {
namespace {

/// No machine is larger; lengths beyond are slips that would only overflow [mm].
constexpr double kLargestMm = 1e5;
/// Where LinuxCNC takes a number for a whole one.
constexpr double kWholeNumber = 1e-4;

}  // namespace

bool Machine::obey(const Block& block, const Where& where) {
    where_ = &where;
    const std::optional<int> motion = motionOf(block);
    checkWords(block, motion);
    checkModes(block, motion);
    setFeed(block);
    setSpindle(block);
    setCoolant(block);
    dwellIn(block);
    setModes(block);
    setLengthOffset(block);
    setWorkOffset(block);
    setPathControl(block);
    goHome(block);
    if (motion) move(block, *motion);
    if (block.has(ModalGroup::Motion, code(80))) {
        motion_.reset();
        cycles_from_.reset();
    }
    return stop(block);
}

void Machine::note(const std::string& comment, const Where& where) {
    where_ = &where;
    act(Comment{comment});
}

std::optional<int> Machine::motionOf(const Block& block) const {
    const std::optional<int> own = block.codeOf(ModalGroup::Motion);
    const bool goes_home =
        block.has(ModalGroup::NonModal, code(28)) || block.has(ModalGroup::NonModal, code(30));
    if (own && *own != code(80)) {
        if (goes_home) refuse(codeName('G', *own) + " with G28 or G30: both use the axis words");
        return own;
    }
    const bool axes = block.hasAny("XYZ");
    if (goes_home) return std::nullopt;
    if (own && axes) refuse("axis words with G80, which ends motions");
    const bool arc_words = motion_ && isArc(*motion_) && block.hasAny("IJ");
    if (!axes && !arc_words) return std::nullopt;
    if (!motion_) refuse("axis words without a G code that uses them");
    return motion_;
}

/// Every word is for something in the block.
void Machine::checkWords(const Block& block, std::optional<int> motion) const {
    const bool arc = motion && isArc(*motion);
    const bool cycle = motion && isCycle(*motion);
    const bool dwells = block.has(ModalGroup::NonModal, code(4));
    const bool blends = block.has(ModalGroup::PathControl, code(64)) && rules_.own_words;
    const auto need = [&](char letter, bool used, const char* for_what) {
        if (block.has(letter) && !used) refuse(fmt::format("{} without {} to use it", letter, for_what));
    };
    need('I', arc, "G2 or G3");
    need('J', arc, "G2 or G3");
    need('R', arc || cycle, "G2, G3 or a cycle");
    need('P', dwells || blends || (arc && rules_.own_words) || motion == code(82), "G4, G64, G82 or an arc");
    need('Q', blends || motion == code(83), "G83");
    need('H', block.has(ModalGroup::LengthOffset, code(43)), "G43");
    for (const char letter : {'P', 'Q', 'F', 'S'})
        if (block.number(letter).value_or(0) < 0) refuse(fmt::format("{} is negative", letter));
    for (const char letter : {'T', 'H'})
        if (const auto number = block.number(letter))
            if (*number < 0 || *number > 1e6 || std::abs(*number - std::round(*number)) > kWholeNumber)
                refuse(fmt::format("{}{:g} is no whole number", letter, *number));
    if (arc && block.has('P')) {
        const double turns = *block.number('P');
        if (std::abs(turns - std::round(turns)) > 1e-3 || std::round(turns) < 1 || turns > 1000)
            refuse("P in an arc is a whole number of turns");
    }
}

/// Codes of a block that do not go together.
void Machine::checkModes(const Block& block, std::optional<int> motion) const {
    const bool dwells = block.has(ModalGroup::NonModal, code(4));
    if (dwells && !block.has('P')) refuse("G4 without P");
    if (dwells && motion && isArc(*motion)) refuse("G4 with an arc: both use P");
    if (dwells && rules_.dwell_in_ms && block.hasAny("XYZ"))
        refuse("G4 with axis words, of which X is a time on this controller");
    if (motion && isCycle(*motion) && !block.hasAny("XYZ"))
        refuse(codeName('G', *motion) + " without axis words");
    if (!block.has(ModalGroup::NonModal, code(53))) return;
    if (motion != code(0)) refuse("G53 without G0");
    const auto distance = block.codeOf(ModalGroup::Distance);
    if (distance ? *distance == code(91) : state_.distance == DistanceMode::Incremental)
        refuse("G53 with G91: a place of the machine's is no distance");
}

void Machine::setFeed(const Block& block) {
    if (const auto mode = block.codeOf(ModalGroup::FeedMode)) {
        const FeedMode wanted = *mode == code(93)   ? FeedMode::InverseTime
                                : *mode == code(94) ? FeedMode::PerMinute
                                                    : FeedMode::PerRevolution;
        // LinuxCNC forgets F with every such word, others when it says something new.
        if (rules_.own_words || state_.feed_mode != wanted) feed_ = 0;
        state_.feed_mode = wanted;
    }
    const auto f = block.number('F');
    if (f && state_.feed_mode != FeedMode::InverseTime) {
        if (changesUnits(block)) refuse("F in the block that sets its unit: LinuxCNC takes the old one");
        feed_ = length(*f);
    }
    if (const auto s = block.number('S')) state_.speed_rpm = *s;
}

bool Machine::changesUnits(const Block& block) const {
    const auto units = block.codeOf(ModalGroup::Units);
    return units && mm_per_unit_ != (*units == code(20) ? kMillimetresPerInch : 1);
}

void Machine::setSpindle(const Block& block) {
    prepareTool(block);
    changeTool(block);
    if (block.has(ModalGroup::Spindle, code(3))) state_.spin = Spin::Clockwise;
    if (block.has(ModalGroup::Spindle, code(4))) state_.spin = Spin::CounterClockwise;
    if (block.has(ModalGroup::Spindle, code(5))) state_.spin = Spin::Off;
}

void Machine::prepareTool(const Block& block) {
    const auto t = block.number('T');
    if (!t) return;
    prepared_tool_ = static_cast<int>(std::round(*t));
    act(ToolPrepared{*prepared_tool_});
    // Without a changer the first tool is in the spindle when the program starts.
    if (!rules_.tool_changer && !state_.tool) state_.tool = prepared_tool_;
}

void Machine::changeTool(const Block& block) {
    if (!block.has(ModalGroup::ToolChange, code(6))) return;
    if (!prepared_tool_) refuse("M6 without a tool (T) to put in");
    state_.tool = prepared_tool_;
    state_.spin = Spin::Off;
    act(ToolChange{});
    losePlace();
}

void Machine::setCoolant(const Block& block) {
    if (block.has(ModalGroup::Coolant, code(7))) state_.mist = true;
    if (block.has(ModalGroup::Coolant, code(8))) state_.flood = true;
    if (block.has(ModalGroup::Coolant, code(9))) state_.mist = state_.flood = false;
}

void Machine::dwellIn(const Block& block) {
    if (!block.has(ModalGroup::NonModal, code(4))) return;
    act(Dwell{dwellSeconds(block.words().at('P')), at_.z.value_or(std::numeric_limits<double>::infinity())});
}

void Machine::setModes(const Block& block) {
    if (const auto plane = block.codeOf(ModalGroup::Plane))
        state_.plane = *plane == code(17) ? Plane::XY : *plane == code(18) ? Plane::ZX : Plane::YZ;
    if (changesUnits(block) && motion_ && isCycle(*motion_))
        refuse("units change between cycles, whose heights LinuxCNC then takes in the new ones");
    if (const auto units = block.codeOf(ModalGroup::Units))
        mm_per_unit_ = *units == code(20) ? kMillimetresPerInch : 1;
    if (block.has(ModalGroup::CutterCompensation, code(40))) state_.compensation_off = true;
    if (const auto distance = block.codeOf(ModalGroup::Distance))
        state_.distance = *distance == code(90) ? DistanceMode::Absolute : DistanceMode::Incremental;
    if (const auto arcs = block.codeOf(ModalGroup::ArcDistance)) arc_centre_absolute_ = *arcs == code(90, 1);
    if (const auto retract = block.codeOf(ModalGroup::Retract)) back_to_start_ = *retract == code(98);
}

void Machine::setLengthOffset(const Block& block) {
    const auto offset = block.codeOf(ModalGroup::LengthOffset);
    if (!offset) return;
    int h = kNoLengthOffset;
    if (*offset == code(43)) {
        if (!block.has('H') && !state_.tool) refuse("G43 without H, and no tool is in the spindle");
        h = block.has('H') ? static_cast<int>(std::round(*block.number('H'))) : *state_.tool;
    }
    if (state_.length_offset == h) return;
    // Zero moves by what only the controller knows.
    if (rules_.tool_lengths) at_.z.reset();
    state_.length_offset = h;
}

void Machine::setWorkOffset(const Block& block) {
    const auto offset = block.codeOf(ModalGroup::WorkOffset);
    if (!offset) return;
    const int number = (*offset - code(54)) / 10 + 1 + *offset % 10;
    if (state_.work_offset == number) return;
    losePlace();
    state_.work_offset = number;
}

void Machine::setPathControl(const Block& block) {
    const auto control = block.codeOf(ModalGroup::PathControl);
    if (!control) return;
    state_.path_control = *control == code(61)      ? PathControl::ExactPath
                          : *control == code(61, 1) ? PathControl::ExactStop
                                                    : PathControl::Blend;
    state_.blend_mm = *control == code(64) && block.has('P') ? length(*block.number('P')) : 0;
    if (*control == code(64) && block.has('Q'))
        state_.blend_mm = std::max(state_.blend_mm, length(*block.number('Q')));
}

bool Machine::stop(const Block& block) {
    const auto code_of_stop = block.codeOf(ModalGroup::Stop);
    // Where the operator changes tools, he does it while the program waits.
    const bool waits = code_of_stop == code(0) || code_of_stop == code(1);
    if (waits && !rules_.tool_changer && prepared_tool_ && state_.tool != prepared_tool_) {
        if (code_of_stop == code(1)) refuse("M1 stops by a switch, the tool has to be changed at M0");
        state_.tool = prepared_tool_;
        act(ToolChange{});
        at_ = {};
    }
    if (!code_of_stop || waits) return true;
    state_.spin = Spin::Off;
    state_.mist = state_.flood = false;
    act(ProgramEnd{});
    return false;
}

double Machine::unit() const {
    if (mm_per_unit_ == 0) refuse("a length before G20 or G21");
    return mm_per_unit_;
}

double Machine::length(double number) const {
    const double mm = number * unit();
    if (std::abs(mm) > kLargestMm) refuse(fmt::format("{:g} mm is more than any machine goes", mm));
    return mm;
}

std::optional<double> Machine::lengthOf(const Block& block, char letter) const {
    const auto number = block.number(letter);
    if (!number) return std::nullopt;
    if (rules_.sticks_to_point && *number != 0 && !block.words().at(letter).has_point)
        refuse(fmt::format("{}{:g} without a decimal point counts last decimals on some controls", letter,
                           *number));
    return length(*number);
}

double Machine::dwellSeconds(const Word& word) const {
    if (rules_.dwell_in_ms && word.has_point) refuse("P of a dwell is in whole milliseconds");
    return rules_.dwell_in_ms ? word.value / 1000 : word.value;
}

/// Where the tool is in the work offset's coordinates is not known any more; at the top it stays.
void Machine::losePlace() {
    at_ = {.x = {}, .y = {}, .z = {}, .z_home = at_.z_home};
}

void Machine::act(Doing doing) {
    if (run_.states.back() != state_) run_.states.push_back(state_);
    run_.actions.push_back({std::move(doing), where_->line, run_.states.size() - 1});
}

}  // namespace stepmill::reader
