#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// A radius at which the discs that fit a region change.
struct ClearanceEvent {
    enum class Kind {
        Neck,          ///< walls opposite each other come closest, or run parallel: larger discs do not pass
        CornerRadius,  ///< centre of a concave wall arc: larger discs leave material in it
        Branch,        ///< a disc that touches three edges on its way into a corner: larger ones miss one
        Room           ///< the widest disc of a room: larger discs do not fit
    };
    Kind kind = Kind::Neck;
    double radius_mm = 0;
    Vec2 at = Vec2::Zero();  ///< the disc's centre
};

/// Centres of the discs that touch the boundary at two or more places, as a graph.
struct MedialAxis {
    struct Node {
        Vec2 point = Vec2::Zero();
        double clearance_mm = 0;
    };
    /// A stretch equally far from two boundary edges. Between its nodes the clearance rises or falls only,
    /// or stays the same.
    struct Edge {
        std::size_t from = 0;
        std::size_t to = 0;
    };
    std::vector<Node> nodes;
    std::vector<Edge> edges;
};

/// How large a disc fits at every point of a region's boundary: one diagram that answers every cutter.
///
/// A disc that touches the boundary at a point and grows into the region stops at the first other contact:
/// the point's clearance. As a function along lines, arcs and reflex corners it is piecewise analytic, its
/// pieces named by the edge that stops the disc; it holds the whole Voronoi diagram of lines and arcs. The
/// offset by d follows the boundary where the clearance exceeds d, the opening too; so arcs stay arcs,
/// walls are shared and nothing drifts, however many radii are asked. See
/// docs/algorithms/clearance-diagram.md and docs/adr/0004-clearance-profile.md.
///
/// Tie rule: a disc passes a neck when the neck is wider, by more than 2 nm (what rounding to the grid leaves
/// of equality); equal is not passable. A disc fills a concave arc of its own radius.
///
/// Each side is built when it is first asked for, O(n log n) for n edges; a query costs O(n). Offsets
/// and openings are kept by distance. Its answers never change; safe to share between threads.
class ClearanceDiagram {
  public:
    ClearanceDiagram(const Region& region, const Tolerances& tol);
    ~ClearanceDiagram();
    ClearanceDiagram(ClearanceDiagram&&) noexcept;
    ClearanceDiagram& operator=(ClearanceDiagram&&) noexcept;

    const Region& region() const;

    /// The region grown (distance > 0, round joins) or shrunk (distance < 0) by |distance|.
    /// Empty when nothing is left: a result, not an error. Every point is checked against the boundary; where
    /// that fails, Booleans between what a disc sweeps along each edge answer instead, hundreds of times
    /// slower.
    /// \throws Error(Internal) rather than return a boundary that comes closer than it should.
    Region offset(double distance_mm) const;

    /// offset(-first), offset(-(first + step)), ... until nothing is left.
    /// \pre step_mm > 0
    std::vector<Region> rings(double first_mm, double step_mm) const;

    /// Points a disc of that radius sweeps inside the region (morphological opening). Never outside
    /// the region.
    Region opening(double radius_mm) const;

    /// The region without stretches narrower than `width_mm`, as two areas leave them that should share a
    /// wall: cut off straight where they begin. Unlike in an opening corners of 12 degrees and more stay
    /// sharp, so that nothing gets arcs no wider than a strip. Never outside the region.
    Region withoutStrips(double width_mm) const;

    /// Centres a disc of radius `small` has left to visit after one of radius `large` has swept what it can:
    /// offset(-small) without the opening(large) shrunk by `small` [DSouza2006, Alg. 2, C = B_nn - B_mn].
    /// Exactly empty where the two openings are equal.
    /// \pre small <= large
    Region restCentres(double large_mm, double small_mm) const;

    /// Area of opening(radius) [mm2]. Between neighbouring events an analytic function of the radius.
    double accessibleArea(double radius_mm) const;
    /// Where that function jumps or bends, by rising radius; equal ones by place. Not among them: where discs
    /// on both sides of a closed neck stop overlapping.
    std::vector<ClearanceEvent> events() const;

    MedialAxis medialAxis() const;

    /// Largest disc inside the region; nothing for the empty region.
    struct Disc {
        Vec2 centre;
        double radius_mm = 0;
    };
    std::optional<Disc> largestInscribedDisc() const;

    /// Distance from p to the boundary [mm]; infinity for the empty region. O(log n) for ordinary regions.
    double distanceToBoundary(const Vec2& p) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// One offset of one region; the same as ClearanceDiagram(region, tol).offset(distance_mm).
/// Keep the diagram instead where several offsets are needed.
Region offset(const Region& region, double distance_mm, const Tolerances& tol);

}  // namespace stepmill
