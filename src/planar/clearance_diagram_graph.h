#pragma once

#include <vector>

#include "planar/clearance_diagram_bisector.h"

namespace stepmill::clearance {

/// A point of the diagram where its edges meet, or where clearance along an edge turns.
struct Vertex {
    Vec2 point = Vec2::Zero();
    double clearance = 0;  ///< from the true sites; infinite at the far end of an unbounded edge
    bool neck = false;     ///< clearance rises on two sides, or stays level along a passage
};

/// One direction of a Voronoi edge along which clearance is monotone. `site`'s cell is on its left.
struct HalfEdge {
    int from = -1;
    int to = -1;
    int twin = -1;
    int site = -1;
    int cell = -1;
    Side side = Side::Inside;
};

/// The Voronoi diagram of the chords, with clearances of the true sites they stand for.
///
/// The half-edges of one cell follow each other counter-clockwise, so that their order by index is their
/// order around the cell. Whatever the clearances, a level of them crosses each cell's boundary as often
/// upwards as downwards: that is all that tracing relies on.
struct Graph {
    SiteSet set;
    std::vector<Vertex> vertices;
    std::vector<HalfEdge> edges;
};

/// O(n log n). \throws Error(GeometryKernel)
Graph buildGraph(SiteSet set, double chord_mm);

/// Moves a vertex of the chords' diagram to where the true sites around it are equally near and sets its
/// clearance there; where there is no such point close by, the vertex stays.
///
/// \param sites  of the cells around the vertex, in order, neighbours different
void settle(Vertex& vertex, const SiteSet& set, Side side, const std::vector<int>& sites, double chord_mm);

}  // namespace stepmill::clearance
