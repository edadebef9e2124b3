#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "support/height_map.h"

/// What simulations of posted programs take of plan.json.
namespace stepmill::test {

/// The form of a tool's cutter.
CutterProfile cutterOf(const nlohmann::json& tool);

/// From the part's coordinates to the setup's.
Eigen::Isometry3d transformOf(const nlohmann::json& setup);

/// The raw stock's box around all its corners in a setup.
Box3 rawStockIn(const nlohmann::json& plan, const Eigen::Isometry3d& part_to_setup);

/// LinuxCNC's table of the plan's tools, all of no length.
std::string toolTableOf(const nlohmann::json& plan);

}  // namespace stepmill::test
