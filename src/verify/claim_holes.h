#pragma once

#include <string>
#include <vector>

#include "stepmill/plan/hole_wishes.h"
#include "stepmill/verify/verify.h"

namespace stepmill::verify {

/// A feature as the part's file has it, in its setup, and what the record says of its tools' work: the
/// residuals and how far down they go.
struct DerivedHole {
    const PlannedFeature& planned;
    const Setup& setup;  ///< with its fixtures
};

/// What the hole table asks of a feature against the record's operations on it: a failure where a hole that
/// is to be left is cut, where one to be drilled is made by any other tool, where a tap goes into a hole that
/// the table does not choose, cuts another thread or less of it, where a bore gets a fit that the table does
/// not ask for.
/// \return  how many holes are to get a thread or a fit and get none
int compareHole(const PlanRecord& record, const HoleWishes& wishes, const DerivedHole& hole,
                const Tolerances& tol, std::vector<ProofFailure>& failures);

}  // namespace stepmill::verify
