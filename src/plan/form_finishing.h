#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plan/form_site.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// What form operations are planned with.
struct FormShop {
    const ToolLibrary& library;
    const Machine& machine;
    const std::string& material;
    double scallop_mm = 0;
    double retract_mm = 0;  ///< the setup's (plan/retract.h)
    FeatureCaution caution;
    Deadline deadline;  ///< forms that are not chosen by then are not cut
    const Tolerances& tol;
};

/// Form operations of a setup, and the ground they work on.
struct FormFinishing {
    FormGround ground;
    std::vector<Operation> operations;  ///< in their order, without ids; none where no cutter gains anything
    std::vector<Prism> removed;         ///< what they take, in setup coordinates
};

/// Are there cutters for leaning walls at all?
bool hasFormCutters(const ToolLibrary& library, const std::string& material);

/// Takes off with the library's form cutters what flat layers leave over the leaning walls of a setup: the
/// sequence of cutters that takes least time of those that take as much as any. A chamfer mill comes first.
/// Nothing where no cutter reaches anything.
/// \throws Error(TimedOut) soon after the deadline
std::optional<FormFinishing> finishForms(const FormSources& sources, const FormShop& shop);

}  // namespace stepmill
