// Which face is in front, on a raster.

#include "report/page/shading.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/page/facets.h"
#include "stepmill/part/part.h"

namespace stepmill {

namespace {

/// Columns or rows of the raster, along the longer side of the picture.
constexpr int kCells = 300;
constexpr int kNothing = -1;

/// A facet as the viewer sees it: x right, y up, z towards the viewer.
struct Facet {
    std::array<Vec3, 3> corners;
    int tint = kNothing;
};

std::vector<Facet> facetsOf(const TopoDS_Shape& solid, const gp_Ax2& plane, const std::vector<int>& tints) {
    const auto vector = [](const auto& xyz) { return Vec3(xyz.X(), xyz.Y(), xyz.Z()); };
    Eigen::Matrix3d axes;
    axes << vector(plane.XDirection()).transpose(), vector(plane.YDirection()).transpose(),
        vector(plane.Direction()).transpose();
    const Vec3 origin = vector(plane.Location());
    const auto seen = [&](const Vec3& at) -> Vec3 { return axes * (at - origin); };
    std::vector<Facet> facets;
    for (const report::SolidFacet& facet : report::facetsOf(solid)) {
        Facet& shown = facets.emplace_back();
        shown.tint = tints.at(facet.face);
        std::transform(facet.corners.begin(), facet.corners.end(), shown.corners.begin(), seen);
    }
    return facets;
}

class Raster {
  public:
    explicit Raster(const std::vector<Facet>& facets) {
        for (const Facet& facet : facets)
            for (const Vec3& p : facet.corners)
                frame_.extend(p.head<2>());
        cell_ = frame_.sizes().maxCoeff() / kCells;
        columns_ = std::max(1, static_cast<int>(std::ceil(frame_.sizes().x() / cell_)));
        rows_ = std::max(1, static_cast<int>(std::ceil(frame_.sizes().y() / cell_)));
        height_.assign(static_cast<std::size_t>(columns_) * rows_, std::numeric_limits<double>::lowest());
        tint_.assign(height_.size(), kNothing);
        for (const Facet& facet : facets)
            draw(facet);
    }

    Shading patches() const {
        Shading shading;
        std::map<std::array<int, 3>, int> begun;  // (from, to, tint) of the row before -> its first row
        for (int row = 0; row <= rows_; ++row) {
            std::map<std::array<int, 3>, int> runs;
            if (row < rows_)
                for (const std::array<int, 3>& run : runsOf(row)) {
                    const auto known = begun.find(run);
                    runs[run] = known == begun.end() ? row : known->second;
                }
            for (const auto& [run, first] : begun)
                if (runs.count(run) == 0) shading[run[2]].push_back(rectangle(run[0], run[1], first, row));
            begun = std::move(runs);
        }
        return shading;
    }

  private:
    void draw(const Facet& facet) {
        std::array<Vec3, 3> p = facet.corners;
        Box2 box;
        for (Vec3& corner : p) {
            corner.head<2>() = (corner.head<2>() - frame_.min()) / cell_;
            box.extend(corner.head<2>());
        }
        const Vec3 u = p[1] - p[0];
        const Vec3 v = p[2] - p[0];
        const double det = u.x() * v.y() - u.y() * v.x();
        if (std::abs(det) < 1e-12) return;
        for (int row = std::max(0, static_cast<int>(box.min().y()));
             row <= std::min(rows_ - 1, static_cast<int>(box.max().y())); ++row)
            for (int column = std::max(0, static_cast<int>(box.min().x()));
                 column <= std::min(columns_ - 1, static_cast<int>(box.max().x())); ++column) {
                const double dx = column + 0.5 - p[0].x();
                const double dy = row + 0.5 - p[0].y();
                const double s = (dx * v.y() - dy * v.x()) / det;
                const double t = (u.x() * dy - u.y() * dx) / det;
                if (s < 0 || t < 0 || s + t > 1) continue;
                const double height = p[0].z() + s * u.z() + t * v.z();
                const std::size_t cell = static_cast<std::size_t>(row) * columns_ + column;
                if (height <= height_[cell]) continue;
                height_[cell] = height;
                tint_[cell] = facet.tint;
            }
    }

    /// Runs of one tint in a row: from, to, tint.
    std::vector<std::array<int, 3>> runsOf(int row) const {
        std::vector<std::array<int, 3>> runs;
        const auto at = [&](int column) { return tint_[static_cast<std::size_t>(row) * columns_ + column]; };
        for (int from = 0; from < columns_;) {
            int to = from + 1;
            while (to < columns_ && at(to) == at(from))
                ++to;
            if (at(from) >= 0) runs.push_back({from, to, at(from)});
            from = to;
        }
        return runs;
    }

    std::vector<Vec2> rectangle(int from, int to, int first, int last) const {
        const auto corner = [&](int column, int row) {
            return Vec2(frame_.min() + cell_ * Vec2(column, row));
        };
        return {corner(from, first), corner(to, first), corner(to, last), corner(from, last)};
    }

    Box2 frame_;
    double cell_ = 1;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<double> height_;
    std::vector<int> tint_;
};

}  // namespace

Shading shade(const TopoDS_Shape& solid, const gp_Ax2& plane, const std::vector<int>& tints) {
    return Raster(facetsOf(solid, plane, tints)).patches();
}

}  // namespace stepmill
