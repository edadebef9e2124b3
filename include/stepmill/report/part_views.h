#pragma once

#include <string>

#include "stepmill/part/part.h"

namespace stepmill {

/// A drawing of the part by hidden-line removal: visible edges solid, hidden ones thin and dashed.
struct View {
    std::string title;  ///< "Top", "Front", "Right", "Isometric"
    std::string svg;    ///< one <svg> element, sized in mm by its viewBox
};

/// Top, front, right and isometric views, to scale, in the setup's coordinates [mm].
/// \throws Error(GeometryKernel)
/// \note  Hidden lines are found edge against face: about quadratic in the number of faces.
std::vector<View> partViews(const Part& part, const Eigen::Isometry3d& part_to_setup);

/// Frame of smallPicture().
inline constexpr int kSmallPictureWidth = 96;
inline constexpr int kSmallPictureHeight = 72;

/// The visible edges from above one corner, as the data of an SVG path in whole units, y down: for tables of
/// many parts. Short edges are left out where there are many; empty where there is nothing to draw.
/// \throws Error(GeometryKernel)
std::string smallPicture(const Part& part);

}  // namespace stepmill
