#pragma once

#include <cstdint>
#include <vector>

#include "report/sheets/scene.h"
#include "stepmill/planar/box.h"

namespace stepmill::report {

/// A parallel view: x right, y up, z towards the viewer, with a frame of cells over it.
class Sight {
  public:
    /// \param shown  setup coordinates; all of it is in the frame
    /// \param cells  along the frame's longer side
    Sight(const Vec3& towards_viewer, const Vec3& right, const Box3& shown, int cells);

    /// In cells from the frame's upper left corner, y down; z towards the viewer [mm].
    Vec3 seen(const Vec3& p) const;
    /// A direction as the viewer sees it: x right, y up, z towards the viewer.
    Vec3 turned(const Vec3& direction) const { return axes_ * direction; }

    double cell_mm() const { return cell_mm_; }
    int columns() const { return columns_; }
    int rows() const { return rows_; }

  private:
    Eigen::Matrix3d axes_;
    Vec2 upper_left_;
    double cell_mm_ = 1;
    int columns_ = 1;
    int rows_ = 1;
};

/// What a cell of a picture shows.
enum class Shown : std::uint8_t { Nothing, Stock, CutHere, Fixture };

/// Small: a picture has half a million.
struct SeenCell {
    Shown what = Shown::Nothing;
    int surface = 0;      ///< of the image's normals
    double depth_mm = 0;  ///< towards the viewer
};

/// Row by row from above.
struct Image {
    int columns = 0;
    int rows = 0;
    std::vector<SeenCell> cells;
    std::vector<Vec3> normals;  ///< of surfaces, as the viewer sees them; the first, of nothing, is zero

    const Vec3& normalOf(const SeenCell& cell) const {
        return normals[static_cast<std::size_t>(cell.surface)];
    }
    const SeenCell& at(int column, int row) const {
        return cells[static_cast<std::size_t>(row) * columns + column];
    }
};

/// A setup's stock, before and after.
struct StockImages {
    Image arriving;  ///< raw without what was cut before; CutHere: what lies behind goes in this setup
    Image leaving;   ///< without what is cut here too; CutHere: surfaces that this setup made
};

/// Casts a ray through every cell: raw stock less cuts, with fixtures. The stock is no solid of the geometry
/// kernel (ADR 0005), and needs none here: what a ray meets is counted. Skins thinner than kThinnestMm, which
/// chords leave between neighbours, are not seen. O(patches x the cells they cover), the same for any number
/// of threads.
StockImages stockImages(const std::vector<Body>& bodies, const Sight& sight);

}  // namespace stepmill::report
