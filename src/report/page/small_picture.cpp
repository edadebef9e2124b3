// Pictures for tables of many parts.

#include <algorithm>
#include <cmath>
#include <set>

#include <gp_Ax2.hxx>

#include "report/page/hidden_lines.h"
#include "report/page/strokes.h"
#include "stepmill/part/part_shape.h"
#include "stepmill/planar/box.h"
#include "stepmill/report/part_views.h"

namespace stepmill {
namespace {

using report::Polyline;
using report::Stroke;

/// Coarse: a unit of the picture is about this share of the part.
constexpr double kDeflectionShare = 0.01;
constexpr double kAngularDeflection = 0.5;
/// Lines of a picture; more cannot be told apart.
constexpr std::size_t kMostLines = 300;

/// Puts points of a view on the picture's units.
class Raster {
  public:
    explicit Raster(const std::vector<Polyline>& lines) {
        for (const Polyline& line : lines)
            for (const Vec2& p : line)
                frame_.extend(p);
        const Vec2 size = frame_.sizes().cwiseMax(1e-9);
        scale_ = std::min((kSmallPictureWidth - 2) / size.x(), (kSmallPictureHeight - 2) / size.y());
    }

    SvgDot dot(const Vec2& p) const {
        const Vec2 from_centre = (p - frame_.center()) * scale_;
        return {std::lround(kSmallPictureWidth / 2.0 + from_centre.x()),
                std::lround(kSmallPictureHeight / 2.0 - from_centre.y())};
    }

  private:
    Box2 frame_;
    double scale_ = 1;
};

std::int64_t squaredLength(const Stroke& stroke) {
    const std::int64_t x = stroke[1][0] - stroke[0][0];
    const std::int64_t y = stroke[1][1] - stroke[0][1];
    return x * x + y * y;
}

std::set<Stroke> longest(const std::set<Stroke>& strokes) {
    std::vector<Stroke> sorted(strokes.begin(), strokes.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Stroke& a, const Stroke& b) { return squaredLength(a) > squaredLength(b); });
    sorted.resize(std::min(sorted.size(), kMostLines));
    return {sorted.begin(), sorted.end()};
}

std::string drawSmall(const Part& part) {
    const double deflection_mm = kDeflectionShare * part.bbox_mm.diagonal().norm();
    const TopoDS_Shape solid = report::solidIn(part, Eigen::Isometry3d::Identity());
    makeFacets(solid, deflection_mm, kAngularDeflection);
    const HLRAlgo_Projector from_above_a_corner(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, -1, 1), gp_Dir(1, 1, 0)));
    const std::vector<Polyline> visible =
        report::hiddenLines(solid, from_above_a_corner, deflection_mm).visible;
    const Raster raster(visible);
    const std::set<Stroke> strokes = report::strokesOf(visible, [&](const Vec2& p) { return raster.dot(p); });
    SvgPath path(1);
    for (const std::vector<SvgDot>& line : report::joined(longest(strokes)))
        path.add(line);
    return path.text();
}

}  // namespace

std::string smallPicture(const Part& part) {
    std::string path;
    guardOcct(ErrorCode::GeometryKernel, "picture of " + part.name, [&] { path = drawSmall(part); });
    return path;
}

}  // namespace stepmill
