#pragma once

#include <vector>

#include "planar/clearance_diagram_bisector.h"

namespace stepmill::clearance {

/// A point where three or more sites are equally near, where clearance along a bisector has an extremum, or
/// the foot of a bisector on the boundary.
struct Node {
    Vec2 point = Vec2::Zero();
    double clearance = 0;  ///< from the true lines and arcs
    bool neck = false;     ///< clearance rises on two sides, or stays level along a passage
    bool on_boundary = false;
    bool exact = true;  ///< false: taken from the chords, right to about a sagitta
};

/// One direction of a bisector along which clearance is monotone. `site`'s cell is on its left.
struct HalfEdge {
    int from = -1;
    int to = -1;
    int site = -1;
    int twin = -1;
    int prev = -1;  ///< the half-edges before and after it around its site's cell
    int next = -1;
    Side side = Side::Inside;
};

/// The Voronoi diagram of true lines, arcs and corners: cells of chords that stand for one site joined,
/// chains of edges between the same two sites made one, split where clearance turns.
struct Graph {
    SiteSet set;
    std::vector<Node> nodes;
    std::vector<HalfEdge> edges;
};

/// \throws Error(GeometryKernel)
Graph buildGraph(SiteSet set, double chord_mm);

/// Makes a graph of the chords' diagram one of the true sites: moves nodes to where the true sites are
/// equally near, exchanges edges whose order the chords got wrong, and splits bisectors where clearance
/// turns. `courses` holds for each pair of half-edges the points between its ends, along the even one.
void refineGraph(Graph& graph, const std::vector<std::vector<Vec2>>& courses, double chord_mm);

}  // namespace stepmill::clearance
