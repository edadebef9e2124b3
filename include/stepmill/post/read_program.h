#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stepmill/post/machine_state.h"
#include "stepmill/post/post.h"

namespace stepmill {

/// A motion as the program has it, in mm, and the line it stands on.
struct ReadMove {
    FedMove fed;
    int line = 0;
    std::size_t state = 0;  ///< index into ReadProgram::states
    /// How much nearer to its centre than to its start an arc ends; controllers take some of that [mm].
    double radii_differ_mm = 0;
    /// The way it goes with each turn of the spindle, coupled to that; 0: not coupled [mm].
    double pitch_mm = 0;
    /// Ends at the top of the machine's travel, for which the program's highest place stands.
    bool home = false;
};

/// A stop with the tool in place (G4, G82).
struct ReadDwell {
    double seconds = 0;
    int line = 0;
    double z_mm = 0;  ///< of the tip; infinite where that is not known
};

/// What the program does between one operation's comment and the next.
struct ReadOperation {
    std::string id;  ///< "S1.O3", from the comment
    int line = 0;    ///< of the comment
    Vec3 start = Vec3::Zero();
    /// From `start` on without a gap: where the tool was away (at a change, at home), a rapid at the
    /// program's highest place stands for the way.
    std::vector<ReadMove> moves;
    std::vector<ReadDwell> dwells;
};

/// A rapid that starts or ends where the program alone does not say: after a tool change, or to the machine's
/// own places (G28, G30, G53). Of its ends no more than the height is known.
struct ReadLeap {
    int line = 0;
    std::size_t state = 0;
    /// The last operation's comment before it, empty before the first.
    std::string operation;
    std::optional<double> from_z_mm;
    std::optional<double> to_z_mm;
    bool to_home = false;      ///< up to the top of the machine's travel
    bool across = false;       ///< x or y change
    bool names_place = false;  ///< ends, in some axis, at a place of the work offset's
};

/// A tool change or the end of the program, where the tool must be out of the way.
struct ReadStop {
    int line = 0;  ///< of the last motion before it, if any
    std::string operation;
    std::optional<double> z_mm;  ///< where the tool was left; nothing: at home, or not moved
    bool at_home = false;        ///< at the top of the machine's travel
    bool is_end = false;
};

/// A T word.
struct ReadToolWord {
    int line = 0;
    std::string operation;
    int tool = 0;
};

struct ReadProgram {
    std::string file;
    bool has_length_offsets = false;  ///< the controller takes a tool's length from a table (G43 H)
    bool blends_corners = false;      ///< it rounds corners unless the program forbids it (G61)
    std::vector<MachineState> states;
    std::vector<ReadOperation> operations;
    std::vector<ReadLeap> leaps;
    std::vector<ReadStop> stops;  ///< in the program's order
    std::vector<ReadToolWord> tool_words;
};

/// Reads a program as the controller will run it: an interpreter of RS274/NGC with its modal groups and order
/// of execution, in the dialect's variant. What it knows it obeys; it refuses everything else and skips
/// nothing. Cycles come move by move (pecks come back to 0.254 mm over the last one's bottom, as LinuxCNC's
/// do). Knows nothing of how the program was written. Feeds down are Plunge where they are straight, Ramp
/// where they are not.
///
/// \throws Error(InvalidCatalog) with "file, line N" as subject for words it does not know, words that a
///         controller refuses, feeds from a place that is not known, feeds without F, moves of an operation
///         without its comment.
/// \see docs/adr/0008-the-reader-is-a-controller.md for what is read and what is refused
ReadProgram readProgram(std::string_view text, const std::string& file, Dialect dialect);

}  // namespace stepmill
