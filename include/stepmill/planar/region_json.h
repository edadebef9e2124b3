#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "stepmill/planar/region.h"

namespace stepmill {

/// The region as plan.json has it, lengths in mm with six decimals, the grid's own:
///
///     {"loops": [{"hole": false, "start": [0, 0],
///                 "segments": [{"to": [10, 0]}, {"to": [0, 0], "centre": [5, 0], "ccw": true}]}]}
///
/// A segment with a centre is an arc, of the radius that its end has from there. `radius` is given only
/// where rounding makes the true one another. `hole` tells the sense for readers that do not integrate.
nlohmann::ordered_json regionToJson(const Region& region);

/// Reads it back, equal to the last digit. Unknown members are ignored.
/// \throws Error(InvalidRegion) naming `subject`, the loop and what was expected.
Region regionFromJson(const nlohmann::ordered_json& json, const std::string& subject);

}  // namespace stepmill
