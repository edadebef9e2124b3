// Where a setup's coordinates lie in the part.

#include "setup/frame.h"

#include <charconv>

#include <fmt/format.h>

namespace stepmill {

namespace {

/// Directions closer than this are one (0.06 degrees): more than rounding in files, less than any draft.
constexpr double kSameAxisRad = 1e-3;
/// Of a unit vector and a box direction whose sections may be taken for each other's: rounding of doubles.
constexpr double kBoxDirection = 1e-9;
/// A direction that is asked for is none below this length.
constexpr double kNoDirection = 1e-9;

}  // namespace

namespace setup {

Vec3 cleanAxis(const Vec3& axis) {
    const Vec3 unit = axis.normalized();
    const Vec3 box = nearestBoxDirection(unit);
    return (unit - box).norm() < kBoxDirection ? box : unit;
}

Vec3 nearestBoxDirection(const Vec3& axis) {
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    Vec3 box = Vec3::Zero();
    box[largest] = axis[largest] < 0 ? -1 : 1;
    return box;
}

Eigen::Matrix3d rotationFor(const Vec3& axis) {
    Vec3 x = Vec3::UnitX();
    if (std::abs(axis.z()) < 1) x = Vec3::UnitZ().cross(axis).normalized();
    Eigen::Matrix3d rotation;
    rotation.row(0) = x;
    rotation.row(1) = axis.cross(x);
    rotation.row(2) = axis;
    return rotation;
}

Box3 turnedBox(const Box3& box, const Eigen::Matrix3d& rotation) {
    Box3 turned;
    for (int corner = 0; corner < 8; ++corner)
        turned.extend(Vec3(rotation * box.corner(static_cast<Box3::CornerType>(corner))));
    return turned;
}

Eigen::Isometry3d frameFor(const Vec3& axis, const Box3& turned_stock) {
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.linear() = rotationFor(axis);
    frame.translation() = -Vec3(turned_stock.min().x(), turned_stock.min().y(), turned_stock.max().z());
    return frame;
}

}  // namespace setup

/// Nobody writes a direction with larger numbers; the square of this is far from overflow.
static constexpr double kLargestAxisPart = 1e6;

std::optional<Vec3> parseAxis(const std::string& text) {
    if (text.size() == 2 && (text[0] == '+' || text[0] == '-') && text[1] >= 'x' && text[1] <= 'z') {
        Vec3 axis = Vec3::Zero();
        axis[text[1] - 'x'] = text[0] == '+' ? 1 : -1;
        return axis;
    }
    Vec3 axis = Vec3::Zero();
    const char* at = text.data();
    const char* end = at + text.size();
    for (int i = 0; i < 3; ++i) {
        if (i > 0 && (at == end || *at++ != ',')) return std::nullopt;
        if (at != end && *at == '+') ++at;
        const auto [next, error] = std::from_chars(at, end, axis[i]);
        if (error != std::errc() || !(std::abs(axis[i]) <= kLargestAxisPart)) return std::nullopt;
        at = next;
    }
    if (at != end || axis.norm() < kNoDirection) return std::nullopt;
    return setup::cleanAxis(axis);
}

bool isSameAxis(const Vec3& a, const Vec3& b) {
    return (a - b).norm() < kSameAxisRad;
}

std::string axisName(const Vec3& axis) {
    const Vec3 clean = setup::cleanAxis(axis);
    if (clean == setup::nearestBoxDirection(clean))
        for (int i = 0; i < 3; ++i)
            if (clean[i] != 0) return std::string(clean[i] > 0 ? "+" : "-") + "xyz"[i];
    // Adding zero turns -0 into 0.
    const auto rounded = [](double v) { return std::round(v * 1e4) / 1e4 + 0.0; };
    return fmt::format("{:.4f},{:.4f},{:.4f}", rounded(clean.x()), rounded(clean.y()), rounded(clean.z()));
}

}  // namespace stepmill
