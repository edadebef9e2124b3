#include "stepmill/setup/stock_growth.h"

#include <cmath>

#include "setup/frame.h"

namespace stepmill {
namespace {

/// A top closer to the raw one is raw: heights in plan.json have six decimals [mm].
constexpr double kRawTopMm = 1e-4;
/// Entries of a rotation closer to 0 or 1 are those.
constexpr double kSquare = 1e-9;

/// Does the rotation take box directions to box directions?
bool isSquare(const Eigen::Matrix3d& rotation) {
    return ((rotation.array().abs() < kSquare) || ((rotation.array().abs() - 1).abs() < kSquare)).all();
}

}  // namespace

StockGrowth growthOf(const Stock& stock, const Eigen::Isometry3d& part_to_setup) {
    StockGrowth growth;
    if (stock.tolerance_mm <= 0) return growth;
    const Eigen::Matrix3d rotation = part_to_setup.linear();
    Box3 raw = setup::turnedBox(stock.raw_bbox_mm, rotation);
    raw.translate(Vec3(part_to_setup.translation()));
    const bool upright = stock.kind == Stock::Kind::Box && isSquare(rotation);
    // A box whose every face moves out by t reaches t |a|_1 farther along a direction a.
    const Vec3 reach_mm = stock.tolerance_mm * rotation.cwiseAbs().rowwise().sum();
    growth.side_mm = upright ? stock.tolerance_mm : reach_mm.head<2>().maxCoeff();
    if (upright) growth.raw_sides_mm = Box2(Vec2(raw.min().head<2>()), Vec2(raw.max().head<2>()));
    const bool raw_top = std::abs(raw.max().z()) < kRawTopMm;
    // Of leaning sides some are left, whatever was cut off the highest corner.
    growth.top_mm = !upright ? reach_mm.z() : raw_top ? stock.tolerance_mm : 0;
    return growth;
}

}  // namespace stepmill
