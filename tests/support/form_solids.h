#pragma once

#include <vector>

#include <TopoDS_Shape.hxx>

namespace stepmill::test {

/// Solids that shops cut with form cutters, or in steps; lengths in mm. \throws Error(GeometryKernel) where
/// the kernel makes none
struct Rounded {
    double x0 = 0;
    double y0 = 0;
    double x1 = 0;
    double y1 = 0;
    double radius = 0;  ///< of the corners; 0: sharp
};

/// Over the rectangle at the floor; its sides, conical corners among them, lean outwards on the way up.
TopoDS_Shape drafted(const Rounded& floor, double floor_z, double top_z, double draft_deg);

/// Upright sides, and a fillet all around the floor. \pre fillet < half the smaller side
TopoDS_Shape roundFloored(const Rounded& outline, double floor_z, double top_z, double fillet);

/// A channel along x as a ball mill leaves it: a half cylinder with upright sides over it.
TopoDS_Shape channel(double x0, double x1, double y, double diameter, double bottom_z, double top_z);

/// The lowest part of a ball.
TopoDS_Shape dimple(double x, double y, double radius, double bottom_z);

/// Upright or leaning sides over a closed spline around (x, y); `reaches` are its distances from there, even
/// in angle. At the top it is `top_share` as wide as at the floor.
TopoDS_Shape splineSided(double x, double y, const std::vector<double>& reaches, double floor_z, double top_z,
                         double top_share);

/// Upright ends at y0 and y1, and a floor that is a spline from (x0, heights[0]) to (x1, the last one).
TopoDS_Shape splineFloored(double x0, double x1, double y0, double y1, const std::vector<double>& heights,
                           double top_z);

}  // namespace stepmill::test
