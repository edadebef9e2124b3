#pragma once

#include <string>

#include "stepmill/post/post.h"

namespace stepmill {

/// What tells one controller's language from another's.
struct DialectRules {
    bool cycles;             ///< has G81, G82, G83
    bool tool_changer;       ///< M6 changes the tool; else the operator does, at an M0
    bool tool_lengths;       ///< G43 H takes the tool's length from a table
    bool percent;            ///< the program stands between two % signs
    bool goes_home;          ///< G28 before tool changes and at the end
    bool dwell_in_ms;        ///< P of G4 and G82 in milliseconds, else in seconds
    bool any_program_name;   ///< else O and a number
    const char* safe_start;  ///< modal words but units and work offset
    const char* extension;
};

const DialectRules& rulesOf(Dialect dialect);

}  // namespace stepmill
