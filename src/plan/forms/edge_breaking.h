#pragma once

#include "plan/forms/form_finishing.h"

namespace stepmill {

/// Breaks the sharp edges that a setup sees from above with the library's chamfer mills of 90 degrees, by
/// `width_mm` sideways and down: wherever such a mill comes without touching what must stand. The ground's
/// `sharp` tells of edges that stay as they are; it has no operations where all do.
/// \return nothing where no edge is sharp.
/// \throws Error(TimedOut) soon after the deadline
std::optional<FormFinishing> breakEdges(const FormSources& sources, double width_mm, const FormShop& shop);

}  // namespace stepmill
