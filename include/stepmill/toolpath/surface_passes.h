#pragma once

#include <vector>

#include "stepmill/toolpath/shallow_ground.h"
#include "stepmill/toolpath/standing_stairs.h"

namespace stepmill::toolpath {

/// How far apart lines over the surface lie.
struct LineSpacing {
    double scallop_mm = 0;    ///< of the ridges between them
    double step_over_mm = 0;  ///< they are no farther apart, whatever the ridges
};

/// Parallel lines over shallow ground, to and fro, the tip as low as FormFloor lets it: each patch in the
/// direction in which its lines are fewest.
///
/// Where a corner of radius c at the rim of a cutter of radius R goes up a slope a it leaves ridges as a disc
/// of radius (R - c) / sin a + c would, and as one of radius c where it goes along it; between these
/// 1 / r = sin^2 p / c + cos^2 p / ((R - c) / sin a + c), p between the line and the slope. Ground that
/// bulges adds its curvature. Lines are 2 sqrt(2 r s - s^2) apart in all but a twentieth of a patch's cells.
std::vector<SurfaceWay> surfacePasses(const ShallowGround& ground, const FormFloor& floor,
                                      const CutterForm& form, const LineSpacing& spacing,
                                      const Tolerances& tol);

/// How long they are, about, with what it takes to turn round [mm].
double surfacePassesMm(const ShallowGround& ground, const CutterForm& form, const LineSpacing& spacing);

}  // namespace stepmill::toolpath
