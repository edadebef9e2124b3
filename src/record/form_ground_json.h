#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "record/feature_json.h"
#include "record/read_features.h"
#include "stepmill/feature/form_ground.h"

namespace stepmill::record {

/// An entry of `forms` in plan.json.
/// \param tables  get what it refers to
nlohmann::ordered_json formGroundJson(const FormGround& ground, FeatureTables& tables);

/// The reverse.
/// \param pointer  of the entry in plan.json
/// \throws Error(InvalidCatalog) where its bands leave gaps or numbers name nothing
FormGround formGroundFrom(const nlohmann::ordered_json& json, const std::string& pointer, ReadTables& tables);

}  // namespace stepmill::record
