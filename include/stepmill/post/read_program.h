#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stepmill/post/post.h"

namespace stepmill {

/// A motion as the program has it, in mm, and the line it stands on.
struct ReadMove {
    FedMove fed;
    int line = 0;
};

/// What the program does between one operation's comment and the next.
struct ReadOperation {
    std::string id;  ///< "S1.O3", from the comment
    int line = 0;    ///< of the comment
    int tool_number = 0;
    double speed_rpm = 0;
    Coolant coolant = Coolant::Off;
    double dwell_s = 0;  ///< sum of its dwells
    /// A tool change comes before it, so that it starts where its first blocks say.
    bool after_tool_change = false;
    Vec3 start = Vec3::Zero();
    std::vector<ReadMove> moves;
};

struct ReadProgram {
    std::string file;
    std::vector<ReadOperation> operations;
};

/// Reads a program of ours back as the controller will: modal words, inches, absolute positions, drilling
/// cycles move by move (pecks come back to 0.254 mm over the last one's bottom, as LinuxCNC's do). Knows
/// nothing of how it was written. Feeds down are Plunge where they are straight, Ramp where they are not.
///
/// \throws Error(InvalidCatalog) with "file, line N" as subject for words no post of ours writes, motions
///         whose start is unknown, feeds without F or with the spindle off, arcs a controller would refuse,
///         motions outside an operation.
ReadProgram readProgram(std::string_view text, const std::string& file, Dialect dialect);

}  // namespace stepmill
