#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/part/part.h"

namespace stepmill {

/// Raw stock in part coordinates.
struct Stock {
    enum class Kind { Box, Step };
    Kind kind = Kind::Box;
    Box3 bbox_mm;
    double volume_mm3 = 0;
    std::shared_ptr<const PartShape> shape;
};

/// Extra material of a box stock over the part's bounding box, seen from the spindle of the (first)
/// setup [mm].
struct StockMargin {
    double side_mm = 0;
    double top_mm = 0;
    double bottom_mm = 0;
};

/// What to plan on and from where.
struct SetupRequest {
    /// Tool axes asked for, unit vectors in part coordinates; empty: choose.
    std::vector<Vec3> axes;
    StockMargin margin;
    /// A solid to start from instead of a box, in the part's coordinates.
    std::optional<Part> stock_part;
};

/// One clamping of the part.
///
/// Setup coordinates: z = 0 at the top of the stock as it arrives, pointing along the tool axis out of the
/// part; x = y = 0 at the stock's lower-left corner seen from the spindle (work offset G54).
struct Setup {
    std::string id;             ///< "S1"
    Vec3 axis = Vec3::UnitZ();  ///< in part coordinates
    Eigen::Isometry3d part_to_setup = Eigen::Isometry3d::Identity();
    Part part;
    Stock stock;         ///< as it arrives, in part coordinates
    Box3 stock_bbox_mm;  ///< in setup coordinates: min.z = -height, max.z = 0
    /// Share of (stock - part) that is open to a tool along the axis, from the height map [0..1].
    double reachable_share = 0;
};

/// The setups to machine a part in, in order. One at a time for now: the axis asked for, or of the six box
/// directions the one that reaches most of stock - part (ties: +z, -z, +x, -x, +y, -y).
///
/// Reach is measured on a height map of the part's facets; it decides the order only, no area or volume of
/// the plan comes from it.
/// \throws Error(Usage) if the stock does not contain the part, with where it sticks out and by how much.
std::vector<Setup> chooseSetups(const Part& part, const SetupRequest& request);

/// "+z" ... "-x", or "x,y,z" numbers; nothing when the text is neither.
std::optional<Vec3> parseAxis(const std::string& text);
/// "+z" and so on for box directions, "x,y,z" with 4 decimals for others.
std::string axisName(const Vec3& axis);

}  // namespace stepmill
