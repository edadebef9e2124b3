// Words that set a controller.

#include "post/reader/modes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stepmill/core/units.h"

namespace stepmill::reader {
namespace {

void setFeed(Control& control, const Block& block) {
    if (const auto mode = block.codeOf(ModalGroup::FeedMode)) {
        const FeedMode wanted = *mode == code(93)   ? FeedMode::InverseTime
                                : *mode == code(94) ? FeedMode::PerMinute
                                                    : FeedMode::PerRevolution;
        // LinuxCNC forgets F with every such word, others when it says something new.
        if (control.rules.own_words || control.state.feed_mode != wanted) control.feed = 0;
        control.state.feed_mode = wanted;
    }
    const auto f = block.number('F');
    if (f && control.state.feed_mode != FeedMode::InverseTime) {
        if (control.changesUnits(block))
            control.refuse("F in the block that sets its unit: LinuxCNC takes the old one");
        control.feed = control.length(*f);
    }
    if (const auto s = block.number('S')) control.state.speed_rpm = *s;
}

void setSpin(Control& control, const Block& block) {
    if (block.has(ModalGroup::Spindle, code(3))) control.state.spin = Spin::Clockwise;
    if (block.has(ModalGroup::Spindle, code(4))) control.state.spin = Spin::CounterClockwise;
    if (block.has(ModalGroup::Spindle, code(5))) control.state.spin = Spin::Off;
}

void setRigidTapping(Control& control, const Block& block) {
    if (!block.has(ModalGroup::RigidTapping, code(29))) return;
    if (control.state.speed_rpm <= 0) control.refuse("M29 at S0");
    control.rigid_tapping = true;
}

void prepareTool(Control& control, const Block& block) {
    const auto t = block.number('T');
    if (!t) return;
    control.prepared_tool = static_cast<int>(std::round(*t));
    control.act(ToolPrepared{*control.prepared_tool});
    // Without a changer the first tool is in the spindle when the program starts.
    if (!control.rules.tool_changer && !control.state.tool) control.state.tool = control.prepared_tool;
}

void changeTool(Control& control, const Block& block) {
    if (!block.has(ModalGroup::ToolChange, code(6))) return;
    if (!control.prepared_tool) control.refuse("M6 without a tool (T) to put in");
    control.state.tool = control.prepared_tool;
    control.state.spin = Spin::Off;
    control.act(ToolChange{});
    control.losePlace();
}

void setCoolant(Control& control, const Block& block) {
    if (block.has(ModalGroup::Coolant, code(7))) control.state.mist = true;
    if (block.has(ModalGroup::Coolant, code(8))) control.state.flood = true;
    if (block.has(ModalGroup::Coolant, code(9))) control.state.mist = control.state.flood = false;
}

void dwellIn(Control& control, const Block& block) {
    if (!block.has(ModalGroup::NonModal, code(4))) return;
    control.act(Dwell{control.dwellSeconds(block.words().at('P')),
                      control.at.z.value_or(std::numeric_limits<double>::infinity())});
}

void setPlaneUnitsDistance(Control& control, const Block& block) {
    if (const auto plane = block.codeOf(ModalGroup::Plane))
        control.state.plane = *plane == code(17) ? Plane::XY : *plane == code(18) ? Plane::ZX : Plane::YZ;
    if (control.changesUnits(block) && control.motion_in_force && isCycle(*control.motion_in_force))
        control.refuse("units change between cycles, whose heights LinuxCNC then takes in the new ones");
    if (const auto units = block.codeOf(ModalGroup::Units))
        control.mm_per_unit = *units == code(20) ? kMillimetresPerInch : 1;
    if (block.has(ModalGroup::CutterCompensation, code(40))) control.state.compensation_off = true;
    if (const auto distance = block.codeOf(ModalGroup::Distance))
        control.state.distance = *distance == code(90) ? DistanceMode::Absolute : DistanceMode::Incremental;
    if (const auto arcs = block.codeOf(ModalGroup::ArcDistance))
        control.arc_centre_absolute = *arcs == code(90, 1);
    if (const auto retract = block.codeOf(ModalGroup::Retract)) control.back_to_start = *retract == code(98);
}

void setLengthOffset(Control& control, const Block& block) {
    const auto offset = block.codeOf(ModalGroup::LengthOffset);
    if (!offset) return;
    int h = kNoLengthOffset;
    if (*offset == code(43)) {
        if (!block.has('H') && !control.state.tool)
            control.refuse("G43 without H, and no tool is in the spindle");
        h = block.has('H') ? static_cast<int>(std::round(*block.number('H'))) : *control.state.tool;
    }
    if (control.state.length_offset == h) return;
    // Zero moves by what only the controller knows.
    if (control.rules.tool_lengths) control.at.z.reset();
    control.state.length_offset = h;
}

void setWorkOffset(Control& control, const Block& block) {
    const auto offset = block.codeOf(ModalGroup::WorkOffset);
    if (!offset) return;
    const int number = (*offset - code(54)) / 10 + 1 + *offset % 10;
    if (control.state.work_offset == number) return;
    control.losePlace();
    control.state.work_offset = number;
}

void setPathControl(Control& control, const Block& block) {
    const auto path = block.codeOf(ModalGroup::PathControl);
    if (!path) return;
    control.state.path_control = *path == code(61)      ? PathControl::ExactPath
                                 : *path == code(61, 1) ? PathControl::ExactStop
                                                        : PathControl::Blend;
    control.state.blend_mm = *path == code(64) && block.has('P') ? control.length(*block.number('P')) : 0;
    if (*path == code(64) && block.has('Q'))
        control.state.blend_mm = std::max(control.state.blend_mm, control.length(*block.number('Q')));
}

}  // namespace

void setModes(Control& control, const Block& block) {
    setFeed(control, block);
    prepareTool(control, block);
    changeTool(control, block);
    setSpin(control, block);
    setRigidTapping(control, block);
    setCoolant(control, block);
    dwellIn(control, block);
    setPlaneUnitsDistance(control, block);
    setLengthOffset(control, block);
    setWorkOffset(control, block);
    setPathControl(control, block);
}

}  // namespace stepmill::reader
