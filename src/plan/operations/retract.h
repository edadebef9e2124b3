#pragma once

#include "stepmill/catalog/machine.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// Height for rapids between operations, over all that stands in the setup, as high as it may be [mm].
/// \param asked_mm  over the stock's top; 0: the machine's safe height
double retractMm(const Setup& setup, double asked_mm, const Machine& machine);

}  // namespace stepmill
