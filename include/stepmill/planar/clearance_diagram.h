#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// One segment Voronoi diagram of a region's boundary, inside and outside, that answers every offset.
///
/// Arcs enter as chords of `tol.chord_mm` laid into the free side, each tagged with the edge it stands
/// for; the diagram decides which boundary pieces meet, the pieces themselves are offset as true lines
/// and arcs and their joints recomputed. So arcs stay arcs and nothing drifts, however many offsets are
/// taken. See docs/algorithms/clearance-diagram.md and docs/adr/0001-planar-kernel.md.
///
/// Build O(n log n) in tessellated edges, one offset O(n). Immutable; safe to share between threads.
class ClearanceDiagram {
  public:
    /// \throws Error(GeometryKernel) if the diagram cannot be built.
    ClearanceDiagram(const Region& region, const Tolerances& tol);
    ~ClearanceDiagram();
    ClearanceDiagram(ClearanceDiagram&&) noexcept;
    ClearanceDiagram& operator=(ClearanceDiagram&&) noexcept;

    const Region& region() const;

    /// The region grown (distance > 0, round joins) or shrunk (distance < 0) by |distance|.
    ///
    /// Tie rule: a neck exactly 2 |distance| wide (within `tol.linear_mm`) is not passable when shrinking
    /// and is closed when growing. Empty when nothing is left: a result, not an error.
    Region offset(double distance_mm) const;

    /// offset(-first), offset(-(first + step)), ... until nothing is left. \pre step_mm > 0
    std::vector<Region> rings(double first_mm, double step_mm) const;

    /// Points a disc of that radius sweeps inside the region (morphological opening). Never outside
    /// the region.
    Region opening(double radius_mm) const;

    /// Largest disc inside the region; nothing for the empty region.
    struct Disc {
        Vec2 centre;
        double radius_mm = 0;
    };
    std::optional<Disc> largestInscribedDisc() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// One offset of one region; the same as ClearanceDiagram(region, tol).offset(distance_mm).
/// Keep the diagram instead where several offsets are needed.
Region offset(const Region& region, double distance_mm, const Tolerances& tol);

}  // namespace stepmill
