#pragma once

#include <string>
#include <vector>

#include "stepmill/report/inspection.h"

namespace stepmill {

/// "0.50" or "sharp", "-" where there is no inner corner.
std::string cornerWords(const FeatureMeasures& measures);
/// "2.10 x 14.0" (thickness by height) with "!" where it is thin, "-" where there is none.
std::string wallWords(const FeatureMeasures& measures);

/// Names of the coarse threads that the hole's narrowest bore could be tapped with: a hint, for STEP says
/// nothing of threads.
std::vector<std::string> tapCoreOf(const Hole& hole);

/// Holes that are the same but for their place.
struct HoleGroup {
    std::string name;   ///< "countersunk through hole"
    std::string steps;  ///< "Ø6.000 to 20.00, Ø10.000 cone to 22.00"
    std::vector<std::string> tap_core_of;
    std::vector<const Hole*> holes;
};
/// By rising diameter, then name.
std::vector<HoleGroup> groupHoles(const std::vector<Hole>& holes);

/// "chamfer" -> 4: edges and odd faces by class, only what there is.
struct FormCount {
    std::string name;
    int count = 0;
};
std::vector<FormCount> countForms(const std::vector<PartForm>& forms);

/// Notes on the whole part: what makes it costly, one sentence each.
std::vector<std::string> notesOn(const Inspection& inspection);

}  // namespace stepmill
