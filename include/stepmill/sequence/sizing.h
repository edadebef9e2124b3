#pragma once

#include <optional>
#include <string>

#include "stepmill/catalog/fit.h"
#include "stepmill/catalog/hole_table.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/feature/feature.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// Holes that are made nearly as wide, and what they are to become.
struct SizingTask {
    Feature hole;  ///< as drawn
    Fit fit;
    double bored_to_z_mm = 0;  ///< their whole width before goes down to here; of a through hole the floor
    double retract_z_mm = 0;
};

/// How wide a bore may be before a reamer or a boring head brings it to this diameter: a reamer takes 0.05 mm
/// at least and 0.15 mm and 1.5 percent of the diameter at most, a boring head 0.1 to 1 mm.
DiameterRange boreBefore(const ToolAssembly& sizer, double bore_mm);

/// Why the tool cannot bring the holes to their fit; empty where it can: its diameter is outside the fit's
/// limits, it does not reach, shank or holder meet what stands beside.
/// \pre sizer.isSizer()
std::string sizingTrouble(const SizingTask& task, const ToolAssembly& sizer);

/// Does a step of that role and fit bring the holes to what the entry asks for?
/// \pre entry.fit
bool isSizedBy(Role role, const std::optional<Fit>& fit, const HoleEntry& entry);

/// Down to here the bore gets its whole width: the floor of a through hole; over the end of a blind one's
/// bore by the tool's lead.
double sizedToZ(const Feature& hole, const ToolAssembly& sizer, double bored_to_z_mm);

/// How deep the tip goes for that.
double sizerTipZ(const Feature& hole, const ToolAssembly& sizer, double sized_to_z_mm);

/// What stays of the ring round a blind hole's bore below sizedToZ() in all holes [mm3].
/// \param before_mm  width of the bore before
double leftByLeadMm3(const SizingTask& task, const ToolAssembly& sizer, double before_mm);

/// All holes brought to their fit: fed down and up again.
/// \pre sizingTrouble() is empty
SequenceStep sizingStep(const SizingTask& task, const ToolAssembly& sizer, const CuttingData& cutting,
                        const Machine& machine);

}  // namespace stepmill
