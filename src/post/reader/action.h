#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "stepmill/planar/region.h"
#include "stepmill/post/machine_state.h"

namespace stepmill::reader {

/// Where the tool is, in the work offset in force [mm]; nothing where the program does not say.
struct Place {
    std::optional<double> x;
    std::optional<double> y;
    std::optional<double> z;
    bool z_home = false;  ///< at the top of the machine's travel, z unknown

    bool knowsXY() const { return x && y; }
    bool known() const { return x && y && z; }
};

enum class MotionKind { Rapid, Feed, Arc };

struct Motion {
    MotionKind kind = MotionKind::Rapid;
    Place from;
    Place to;
    /// Of an arc.
    Vec2 centre = Vec2::Zero();
    bool ccw = false;
    int turns = 1;  ///< P: whole turns before the last one are turns - 1
    double radii_differ_mm = 0;
    double feed_mm_per_min = 0;
    double pitch_mm = 0;       ///< coupled to the spindle: its way with each turn; 0: not coupled
    bool across = false;       ///< x or y change
    bool names_place = false;  ///< ends at a place of the work offset's, not at the machine's own
};

struct Dwell {
    double seconds = 0;
    double z_mm = std::numeric_limits<double>::infinity();  ///< infinite: not known
};

/// A tool is asked for; it comes into the spindle later.
struct ToolPrepared {
    int tool = 0;
};
/// The tool in the state is the new one.
struct ToolChange {};
struct ProgramEnd {};
struct Comment {
    std::string text;
};

using Doing = std::variant<Motion, Dwell, ToolPrepared, ToolChange, ProgramEnd, Comment>;

/// One thing the machine does, the line that asks for it, and what the machine is set to by then.
struct Action {
    Doing doing;
    int line = 0;
    std::size_t state = 0;  ///< index into Run::states
};

/// All that a program makes a machine do.
struct Run {
    std::vector<MachineState> states;  ///< each differs from the one before
    std::vector<Action> actions;
};

}  // namespace stepmill::reader
