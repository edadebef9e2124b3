#pragma once

#include "stepmill/setup/setup.h"

namespace stepmill::setup {

/// +z, -z, +x, -x, +y, -y.
std::vector<Vec3> boxDirections();

/// Tool axes worth asking about: the box directions, then outward normals of planes and both senses of
/// cylinder and cone axes that are none of these, largest face area first, at most a few dozen. Without
/// forbidden ones.
/// \throws Error(Usage) when nothing is left
std::vector<Vec3> candidateAxes(const Part& part, const std::vector<Vec3>& forbidden);

}  // namespace stepmill::setup
