#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "stepmill/planar/region.h"

namespace stepmill::record {

/// The loops as written, checked: a region that crosses itself or runs the wrong way proves anything.
/// \throws Error(InvalidCatalog) with "plan.json#/json/pointer" as subject
Region readRegion(const nlohmann::ordered_json& json, const std::string& pointer);

}  // namespace stepmill::record
