#pragma once

#include <string>

#include "stepmill/proven/proven_plan.h"

namespace stepmill::report {

/// The setup's program; null where none is written.
const PostedProgram* programOf(const ProvenPlan& proven, const PlannedSetup& setup);

/// Where an operation starts in a program; null where it does not.
/// \param program  null: none
const StartBlock* startOf(const PostedProgram* program, const std::string& operation_id);

/// Where an operation starts in its setup's program, for people.
struct ProgramPlace {
    std::string file;
    int line = 0;      ///< of its first block, from 1; 0: there is no program
    std::string text;  ///< that block and some after it
};
ProgramPlace placeOf(const PostedProgram* program, const std::string& operation_id);

}  // namespace stepmill::report
