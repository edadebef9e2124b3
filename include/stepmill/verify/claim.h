#pragma once

#include <optional>
#include <vector>

#include "stepmill/verify/verify.h"

namespace stepmill {

/// The files a plan says it was made from.
/// \pre each is the recorded one, by its sha-256
struct ClaimSources {
    Part part;
    ToolLibrary library;
    std::optional<Part> stock;
    FixtureFile fixtures;
    HoleTable holes;
};

/// The claim of a plan.json, derived anew from the files: setups and stock from axes, margins and part;
/// layers, features with targets, obstructions and obstacles by slicing the stock as each setup's
/// predecessors leave it; fixtures from the vise or the file; threads, fits, and holes that are left
/// or drilled alone, from the hole table. What the record has otherwise, beyond rounding, is a failure with
/// its place: a removed feature, a smaller obstruction, a larger target, a lower fixture.
///
/// What tools leave is taken from the record: programs are proven to leave no more, and the stock of later
/// setups follows from it. After the first setup that differs no later one is compared.
/// \throws Error(InvalidCatalog) for a record without a request; what chooseSetups and SetupWalk::next do
std::vector<ProofFailure> compareWithPart(const PlanRecord& record, const ClaimSources& sources,
                                          const Tolerances& tol);

/// The record's tools against those of the library: number, type, every dimension, stick-out within its
/// range; and the operations' feeds, speeds and step-downs against the cutting data.
std::vector<ProofFailure> compareWithLibrary(const PlanRecord& record, const ToolLibrary& library);

/// What the plan says of its machine (feeds, travel, clearances, spindle nose, all fields) against the
/// machine itself.
std::vector<ProofFailure> compareWithMachine(const RecordedPlan& plan, const Machine& machine);

}  // namespace stepmill
