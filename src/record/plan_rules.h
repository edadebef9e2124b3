#pragma once

#include <nlohmann/json.hpp>

#include "stepmill/core/tolerances.h"
#include "stepmill/record/plan_record.h"

namespace stepmill::record {

/// What a schema cannot say of a plan.json: ids that name one thing each, features and operations that stand
/// in their setup's lists once, parents before children, bands one below the other that make up their
/// feature, tools whose type and corner agree, a program's name that follows from its setup.
/// \pre `plan` keeps schemas/plan.schema.json
/// \throws Error(InvalidCatalog) with "plan.json#/json/pointer" as subject
void checkPlanRules(const nlohmann::ordered_json& plan);

/// The same of a band once its regions are read: heights in order, areas and volumes those of the regions.
void checkBand(const RecordedFeature& recorded, const std::string& pointer);

/// An upright prism has its "top_z_mm" above its "bottom_z_mm".
void checkUpright(const nlohmann::ordered_json& prism, const std::string& pointer);

/// The books: each setup's features hold at least what it plans to cut, a setup that plans to cut has
/// operations, and stock minus part is what the volumes say.
void checkBooks(const nlohmann::ordered_json& plan, const Tolerances& tol);

/// \throws Error(InvalidCatalog) with "plan.json#/json/pointer" as subject
[[noreturn]] void failAt(const std::string& pointer, const std::string& what);

}  // namespace stepmill::record
