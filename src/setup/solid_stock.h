#pragma once

#include "stepmill/setup/setup.h"

namespace stepmill::setup {

/// The part's box with margins, top and bottom along the axis (for other axes than box directions, along
/// the nearest of these), rounded up to sizes where the request has some: what that adds along the axis lies
/// below the part, of sides half on each. Without a shape: addBoxShape makes it.
Stock boxStock(const Part& part, const SetupRequest& request, const Vec3& axis);
void addBoxShape(Stock& stock);

/// The solid of a file.
Stock stepStock(const Part& stock_part);

}  // namespace stepmill::setup
