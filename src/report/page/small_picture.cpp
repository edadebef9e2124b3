// Pictures for tables of many parts.

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>
#include <BRepMesh_IncrementalMesh.hxx>
#include <gp_Ax2.hxx>

#include "report/page/hidden_lines.h"
#include "stepmill/part/part_shape.h"
#include "stepmill/planar/box.h"
#include "stepmill/report/part_views.h"

namespace stepmill {
namespace {

using report::Polyline;

/// Coarse: a unit of the picture is about this share of the part.
constexpr double kDeflectionShare = 0.01;
constexpr double kAngularDeflection = 0.5;
/// Lines of a picture; more cannot be told apart.
constexpr std::size_t kMostLines = 300;

using Dot = std::array<int, 2>;
/// Its ends in order, so that a line drawn twice is one.
using Line = std::array<Dot, 2>;

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

    Dot dot(const Vec2& p) const {
        const Vec2 from_centre = (p - frame_.center()) * scale_;
        return {static_cast<int>(std::lround(kSmallPictureWidth / 2.0 + from_centre.x())),
                static_cast<int>(std::lround(kSmallPictureHeight / 2.0 - from_centre.y()))};
    }

  private:
    Box2 frame_;
    double scale_ = 1;
};

int squaredLength(const Line& line) {
    const int x = line[1][0] - line[0][0];
    const int y = line[1][1] - line[0][1];
    return x * x + y * y;
}

std::set<Line> linesOn(const Raster& raster, const std::vector<Polyline>& polylines) {
    std::set<Line> lines;
    for (const Polyline& polyline : polylines)
        for (std::size_t i = 1; i < polyline.size(); ++i) {
            Line line{raster.dot(polyline[i - 1]), raster.dot(polyline[i])};
            std::sort(line.begin(), line.end());
            if (line[0] != line[1]) lines.insert(line);
        }
    return lines;
}

std::set<Line> longest(const std::set<Line>& lines) {
    std::vector<Line> sorted(lines.begin(), lines.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Line& a, const Line& b) { return squaredLength(a) > squaredLength(b); });
    sorted.resize(std::min(sorted.size(), kMostLines));
    return {sorted.begin(), sorted.end()};
}

/// Takes lines out one after another, the next from where the last one ended while there is any.
class PenStrokes {
  public:
    explicit PenStrokes(const std::set<Line>& lines) {
        for (const Line& line : lines) {
            ends_[line[0]].insert(line[1]);
            ends_[line[1]].insert(line[0]);
        }
    }

    std::string path() {
        std::string data;
        while (!ends_.empty()) {
            Dot at = ends_.begin()->first;
            data += fmt::format("M{} {}", at[0], at[1]);
            while (ends_.contains(at)) {
                at = takeFrom(at);
                data += fmt::format(" {} {}", at[0], at[1]);
            }
        }
        return data;
    }

  private:
    Dot takeFrom(const Dot& from) {
        const Dot to = *ends_[from].begin();
        forget(from, to);
        forget(to, from);
        return to;
    }

    void forget(const Dot& from, const Dot& to) {
        ends_[from].erase(to);
        if (ends_[from].empty()) ends_.erase(from);
    }

    std::map<Dot, std::set<Dot>> ends_;
};

std::string drawSmall(const Part& part) {
    const double deflection_mm = kDeflectionShare * part.bbox_mm.diagonal().norm();
    const TopoDS_Shape solid = report::solidIn(part, Eigen::Isometry3d::Identity());
    const BRepMesh_IncrementalMesh facets(solid, deflection_mm, false, kAngularDeflection);
    const HLRAlgo_Projector from_above_a_corner(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, -1, 1), gp_Dir(1, 1, 0)));
    const std::vector<Polyline> visible =
        report::facetLines(solid, from_above_a_corner, deflection_mm).visible;
    return PenStrokes(longest(linesOn(Raster(visible), visible))).path();
}

}  // namespace

std::string smallPicture(const Part& part) {
    std::string path;
    guardOcct(ErrorCode::GeometryKernel, "picture of " + part.name, [&] { path = drawSmall(part); });
    return path;
}

}  // namespace stepmill
