#include "stepmill/catalog/cutter_form.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

double halfAngleRad(const ToolAssembly& tool) {
    return degToRad(tool.included_angle_deg) / 2;
}

}  // namespace

CutterForm::CutterForm(const ToolAssembly& tool)
    : full_mm_(tool.isTap() ? coreRange(*tool.thread).least_mm / 2 : tool.radius_mm()),
      tip_mm_(full_mm_ - std::min(tool.corner_radius_mm, full_mm_)),
      corner_mm_(full_mm_ - tip_mm_),
      height_mm_(corner_mm_) {
    if (!tool.hasFlanks()) return;
    tip_mm_ = tool.tip_diameter_mm / 2;
    corner_mm_ = 0;
    height_mm_ = (full_mm_ - tip_mm_) / std::tan(halfAngleRad(tool));
}

double CutterForm::radiusAt(double height_mm) const {
    if (height_mm < 0) return 0;
    if (height_mm >= height_mm_) return full_mm_;
    if (corner_mm_ <= 0) return tip_mm_ + (full_mm_ - tip_mm_) * height_mm / height_mm_;
    const double below_mm = corner_mm_ - height_mm;
    return tip_mm_ + std::sqrt(std::max(0.0, corner_mm_ * corner_mm_ - below_mm * below_mm));
}

double CutterForm::heightUnder(double radius_mm) const {
    if (radius_mm >= full_mm_) return std::numeric_limits<double>::infinity();
    const double beyond_mm = radius_mm - tip_mm_;
    if (beyond_mm <= 0) return 0;
    if (corner_mm_ <= 0) return height_mm_ * beyond_mm / (full_mm_ - tip_mm_);
    return corner_mm_ - std::sqrt(corner_mm_ * corner_mm_ - beyond_mm * beyond_mm);
}

double flankLean(const ToolAssembly& tool) {
    return std::sin(halfAngleRad(tool));
}

}  // namespace stepmill
