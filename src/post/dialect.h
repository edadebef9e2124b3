#pragma once

#include <cstddef>
#include <string>

#include "stepmill/post/post.h"

namespace stepmill {

/// How a controller couples a motion to the spindle's turns.
enum class Tapping {
    None,
    G331,  ///< G33.1 with K, down and back up
    G84    ///< a cycle, after M29
};

/// What tells one controller's language from another's.
struct DialectRules {
    Tapping tapping;
    bool cycles;                ///< has G81, G82, G83
    bool tool_changer;          ///< M6 changes the tool; else the operator does, at an M0
    bool tool_lengths;          ///< G43 H takes the tool's length from a table
    bool percent;               ///< the program stands between two % signs
    HomeBy home_by;             ///< where the machine file does not say
    bool home_needs_axes;       ///< G28 without axis words is refused
    bool dwell_in_ms;           ///< P of G4 and G82 in milliseconds, else in seconds
    bool any_program_name;      ///< else O and a number
    bool own_words;             ///< LinuxCNC's own words: turns in arcs, G59.1 to G59.3, G61.1, G90.1
    bool blends_corners;        ///< rounds corners by as much as it likes unless G61, or G64 with P, is said
    bool sticks_to_point;       ///< a length without a decimal point may count last decimals (X50 is 0.05)
    bool semicolon_comments;    ///< else `;` ends a block
    std::size_t longest_block;  ///< characters of a line; of GRBL blanks and comments do not count
    const char* safe_start;     ///< modal words but units and work offset
    const char* extension;
};

const DialectRules& rulesOf(Dialect dialect);

}  // namespace stepmill
