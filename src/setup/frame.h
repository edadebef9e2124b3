#pragma once

#include "stepmill/setup/setup.h"

namespace stepmill::setup {

/// The axis as an exact box direction if it is one within rounding, else normalised.
Vec3 cleanAxis(const Vec3& axis);

/// The box direction (one entry +-1) nearest to the axis.
Vec3 nearestBoxDirection(const Vec3& axis);

/// Rows are the setup's x, y and z in part coordinates; z is the axis.
///
/// +z keeps the part's x and y; -z turns the part about its x axis, so x stays x and y is -y. Seen from a
/// side, the part's z points up on the screen: y is z (or as near to it as the axis allows) and x is
/// z cross axis: +y for +x, -y for -x, -x for +y, +x for -y. Box directions give entries of 0 and +-1
/// only, so that planes and circles keep their exact numbers.
Eigen::Matrix3d rotationFor(const Vec3& axis);

/// The box around a box, turned. Exact for box directions.
Box3 turnedBox(const Box3& box, const Eigen::Matrix3d& rotation);

/// Rotation for the axis, then the stock's least x and y and greatest z to zero.
Eigen::Isometry3d frameFor(const Vec3& axis, const Box3& turned_stock);

}  // namespace stepmill::setup
