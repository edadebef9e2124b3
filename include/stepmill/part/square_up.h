#pragma once

#include "stepmill/part/part.h"

namespace stepmill {

/// Remark on a part that was turned.
inline constexpr const char* kTurned = "turned";

/// A part that stands askew in its file, turned so that its largest flat faces and holes lie along the axes;
/// a remark says so. A part of which faces look along two of the file's axes stays as it is, and one whose
/// faces look along one of them and to many sides across it; one without flat faces and holes too.
///
/// The frame is that of the largest area of planes and of the axes of cylinders and cones, and of the largest
/// across it; of its 24 ways to lie along the axes the one that turns the part least. Takes milliseconds.
Part squaredUp(Part part);

/// The other solid, which is told in the coordinates of the part's file, turned as the part was.
Part turnedLike(Part other, const Part& part);

}  // namespace stepmill
