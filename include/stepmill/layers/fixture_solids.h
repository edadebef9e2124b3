#pragma once

#include <filesystem>
#include <vector>

#include "stepmill/catalog/fixture.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/part/part.h"

namespace stepmill {

/// A fixture's solid as upright blocks, one on the other from the top down: each holds every section of the
/// solid at its heights [layers/layer_stack.h], so cutters and holders keep off all of it. All are named as
/// the solid. \param to_setup  upright: of the solid's coordinates \throws Error(GeometryKernel)
std::vector<Fixture> fixtureBlocks(const std::string& name, const Part& solid,
                                   const Eigen::Isometry3d& to_setup, const Tolerances& tol);

/// Reads a fixture file and the STEP files it names; blocks of their solids stand after the fixtures of their
/// setup.
/// \throws Error(InvalidCatalog) naming the place in the fixture file and what is wrong with the STEP file,
///         and what readFixtures() throws
FixtureFile readFixturesWithSolids(const std::filesystem::path& path, std::uintmax_t max_bytes,
                                   const Tolerances& tol);

}  // namespace stepmill
