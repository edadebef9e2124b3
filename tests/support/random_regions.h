#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::test {

/// Seeded numbers, the same with every standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double real(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    /// 0 ... n - 1
    int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
    Vec2 point(const Box2& box) {
        return {real(box.min().x(), box.max().x()), real(box.min().y(), box.max().y())};
    }

  private:
    std::mt19937_64 engine_;
};

/// No cutter is smaller than ten micrometres.
inline constexpr double kSmallestRadiusMm = 5e-3;

/// What makes a region hard.
enum class RegionKind {
    Scattered,  ///< rectangles, circles, rounded rectangles anywhere, united and subtracted
    Lattice,    ///< the same on a coarse lattice: equal radii, tangent arcs, walls in line
    Shifted,    ///< lattice shapes 1 nm to 1 um off: edges that just miss each other
    Filleted,   ///< polygons with fillets and islands; joints are tangent to within 1 nm of rounding
    Touching,   ///< islands tangent to walls and to each other
    Necks,      ///< rooms joined by necks of known widths: corridors, arcs, corners
    Stars,      ///< several rooms whose discs overlap in one place, round a small island or a star of corners
    Slivers,    ///< wedges of small angles, walls micrometres apart, crescents
    ManyEdges   ///< free forms of hundreds of short lines and arcs
};
inline constexpr RegionKind kRegionKinds[] = {
    RegionKind::Scattered, RegionKind::Lattice,  RegionKind::Shifted,
    RegionKind::Filleted,  RegionKind::Touching, RegionKind::Necks,
    RegionKind::Stars,     RegionKind::Slivers,  RegionKind::ManyEdges};
std::string name(RegionKind kind);

/// A valid region and the radii at which something happens in it exactly (half neck widths, corner radii).
struct RandomRegion {
    RegionKind kind;
    std::uint64_t seed;
    Region region;
    std::vector<double> tie_radii_mm;
    double size_mm = 0;  ///< shorter side of the bounding box

    /// A radius or distance that fits in about two of three cases, on the grid; no tie but by chance.
    double freeRadius(Random& random) const;
    /// One that ties, if the region has one.
    double tieRadius(Random& random) const;
};

/// Most regions are some tens of millimetres wide; one in eight is up to a metre, one in eight about one
/// millimetre.
RandomRegion randomRegion(RegionKind kind, std::uint64_t seed);

/// Turned by the angle about the origin, then moved; on the grid again, which shifts points by up to 0.7 nm.
Region turned(const Region& region, double angle_rad, const Vec2& then_by);
Region mirrored(const Region& region);
/// The same point set: loops start at another vertex and come in another order.
Region renumbered(const Region& region, Random& random);

}  // namespace stepmill::test
