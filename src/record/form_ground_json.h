#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "stepmill/feature/form_ground.h"

namespace stepmill::record {

/// An entry of `forms` in plan.json.
nlohmann::ordered_json formGroundJson(const FormGround& ground);

/// The reverse. \param pointer  of the entry in plan.json
/// \throws Error(InvalidCatalog) where bands leave gaps or regions are none
FormGround formGroundFrom(const nlohmann::ordered_json& json, const std::string& pointer);

}  // namespace stepmill::record
