#pragma once

#include <cstdint>
#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::clearance {

/// Which side of the boundary: the region lies on the left of every loop.
enum class Side : std::uint8_t { Inside, Outside };

enum class SiteKind : std::uint8_t { Line, Arc, Corner };

inline Vec2 leftNormal(const Vec2& direction) {
    return {-direction.y(), direction.x()};
}
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Kinks up to this angle count as tangent joints: over 100 mm of offset they move a curve by 0.13 nm [rad].
inline constexpr double kSmoothKinkRad = 1e-4;

/// A true piece of the boundary: a line, an arc, or a corner between two of them.
struct Site {
    SiteKind kind = SiteKind::Line;
    Vec2 start = Vec2::Zero();  ///< for a corner: the corner itself
    Vec2 end = Vec2::Zero();
    Vec2 dir = Vec2::Zero();     ///< line: unit direction
    Vec2 centre = Vec2::Zero();  ///< arc: its centre; corner: the corner
    double radius = 0;           ///< arc: its radius; corner: 0
    bool ccw = true;
    bool full = false;     ///< arc: full circle
    int start_joint = -1;  ///< index into SiteSet::joints; -1 for full circles; a corner's own
    int end_joint = -1;

    /// Does the circle's centre lie on that side? Then offsets to that side have smaller radii.
    bool concaveOn(Side side) const { return kind == SiteKind::Arc && ccw == (side == Side::Inside); }
    bool round() const { return kind == SiteKind::Arc || kind == SiteKind::Corner; }
};

/// Where one line or arc ends and the next begins.
struct Joint {
    Vec2 point = Vec2::Zero();
    Vec2 tangent_in = Vec2::Zero();
    Vec2 tangent_out = Vec2::Zero();
    int in = -1;      ///< site that ends here
    int out = -1;     ///< site that begins here
    int corner = -1;  ///< the corner's own site; -1 where the boundary goes on tangentially
};

/// One tessellated piece of the boundary in grid units, directed like the loop.
struct Chord {
    std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int site = -1;
    int start_site = -1;  ///< site that the point x0, y0 belongs to
    int end_site = -1;
};

/// A region's boundary as sites and as chords on an integer grid.
///
/// Chord vertices lie on the true arcs, at equal places on equal circles; end points of edges are kept
/// exactly while the grid unit is 1 nm. So a chord strays from its arc by at most the sagitta, to the side
/// of the centre.
struct SiteSet {
    std::vector<Site> sites;
    std::vector<Joint> joints;
    std::vector<Chord> chords;
    Vec2 origin = Vec2::Zero();
    double unit_mm = kGridMm;

    Vec2 toMm(double x, double y) const { return origin + unit_mm * Vec2(x, y); }
};

/// \throws Error(GeometryKernel) if boundaries cross beyond repair.
SiteSet makeSites(const Region& region, double chord_mm);

/// Splits chords until no two of them meet but at end points.
/// \throws Error(GeometryKernel) if that takes too many rounds.
void separateChords(SiteSet& set);

}  // namespace stepmill::clearance
