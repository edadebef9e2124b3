#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "plan/forms/form_site.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// A cutter that takes less than this, or than this share of what is there, is not worth its change [mm3].
inline constexpr double kLeastFormGainMm3 = 0.5;
inline constexpr double kLeastFormGainShare = 0.01;
inline double leastFormGainMm3(double there_mm3) {
    return std::max(kLeastFormGainMm3, kLeastFormGainShare * there_mm3);
}

/// What bands add to a leaning wall is at most so many scallops thick.
inline constexpr double kBandSkinScallops = 2;
/// Form cutters leave no more than this on walls that lean: the skin of a band, and ridges on it.
inline double leftOnLeaningMm(double scallop_mm) {
    return (1 + kBandSkinScallops) * scallop_mm;
}

/// What form operations are planned with.
struct FormShop {
    const ToolLibrary& library;
    const Machine& machine;
    const std::string& material;
    double scallop_mm = 0;
    double retract_mm = 0;  ///< the setup's (plan/operations/retract.h)
    FeatureCaution caution;
    /// Ids of the cutters that come, in their order; nothing: they are chosen.
    std::optional<std::vector<std::string>> cutters;
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
/// sequence of cutters that takes least time of those that take as much as any, or the one that is asked for.
/// Countersinks and chamfer mills come first.
/// Nothing where no cutter reaches anything.
/// \throws Error(TimedOut) soon after the deadline
std::optional<FormFinishing> finishForms(const FormSources& sources, const FormShop& shop);

}  // namespace stepmill
