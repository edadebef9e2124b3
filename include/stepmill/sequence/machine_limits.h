#pragma once

#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"

namespace stepmill {

/// Cutting data within the machine's speed and feed. A spindle that is too slow slows the feeds in
/// proportion, so that the chip stays as thick as the library asks. Without a plunge feed the cutting feed
/// stands for it. A limit of 0 is none.
CuttingData limitedBy(const Machine& machine, CuttingData cutting);

}  // namespace stepmill
