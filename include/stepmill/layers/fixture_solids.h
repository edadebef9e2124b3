#pragma once

#include <filesystem>
#include <vector>

#include "stepmill/catalog/fixture.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/part/part.h"

namespace stepmill {

/// A fixture's solid as upright blocks, one on the other from the top down: each holds every section of the
/// solid at its heights [layers/layer_stack.h], so cutters and holders keep off all of it. All are named as
/// the solid. Never empty.
/// \param to_setup  upright: of the solid's coordinates
/// \throws Error(GeometryKernel)
/// \note  Costs as much as slicing a part.
std::vector<Fixture> fixtureBlocks(const std::string& name, const Part& solid,
                                   const Eigen::Isometry3d& to_setup, const Tolerances& tol);

/// Reads a fixture file and the STEP files it names; blocks of their solids stand after the fixtures of their
/// setup.
/// \throws Error(InvalidCatalog) naming the place in the fixture file and what is wrong with the STEP file: not
///         readable, in doubt, without a unit, a solid used twice, more than 500 blocks; and what
///         readFixtures() throws
FixtureFile readFixturesWithSolids(const std::filesystem::path& path, std::uintmax_t max_bytes,
                                   const Tolerances& tol);

}  // namespace stepmill
