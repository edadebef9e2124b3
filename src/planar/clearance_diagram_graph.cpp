#include "planar/clearance_diagram_graph.h"

#include <boost/polygon/voronoi_builder.hpp>
#include <boost/polygon/voronoi_diagram.hpp>

#include "stepmill/core/error.h"

namespace stepmill::clearance {

namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using Cell = Diagram::cell_type;
using VEdge = Diagram::edge_type;
using VVertex = Diagram::vertex_type;

// Voronoi vertices this close to a chord's end are that end.
constexpr double kOnBoundaryUnits = 3;
// Far ends of unbounded edges.
constexpr double kFarUnits = 1e10;
// Clearances closer than this are level.
constexpr double kLevel_mm = 1e-6;

/// A Voronoi edge of the chords and the vertices that split it.
struct Chain {
    std::vector<int> vertices;
    std::vector<Side> sides;  ///< of the stretches between them
    int first_half = -1;      ///< index of its first half-edge
};

class Builder {
  public:
    Builder(SiteSet&& set, double chord_mm) : chord_mm_(chord_mm) { graph_.set = std::move(set); }
    Graph build();

  private:
    const SiteSet& set() const { return graph_.set; }
    const Site& site(int index) const { return set().sites[static_cast<std::size_t>(index)]; }
    const Chord& chordOf(const Cell& cell) const { return set().chords[cell.source_index()]; }
    Vec2 sourcePoint(const Cell& cell) const;
    int siteOf(const Cell& cell) const;
    std::size_t indexOf(const VEdge* e) const {
        return static_cast<std::size_t>(e - diagram_.edges().data());
    }
    std::size_t indexOf(const VVertex* v) const {
        return static_cast<std::size_t>(v - diagram_.vertices().data());
    }
    int cellSite(const VEdge* e) const {
        return site_of_cell_[static_cast<std::size_t>(e->cell() - diagram_.cells().data())];
    }
    Side sideOf(const VVertex* v) const { return sidedness_[indexOf(v)] > 0 ? Side::Inside : Side::Outside; }
    Vec2 toUnits(const Vec2& mm) const { return (mm - set().origin) / set().unit_mm; }

    void construct();
    void findBoundaryVertices();
    Vec2 farDirection(const VEdge* e) const;
    std::pair<Vec2, Vec2> endsOf(const VEdge* e) const;
    std::optional<Vec2> boundaryCrossing(const VEdge* e) const;
    void findSides();
    void settleVertices();
    int addVertex(const Vec2& point, double clearance);
    Chain chainOf(const VEdge* e);
    void splitWhereClearanceTurns(const VEdge* e, Chain& chain);
    void layOutCells();
    void markNecks();

    Graph graph_;
    double chord_mm_;
    Diagram diagram_;
    std::vector<int> site_of_cell_;
    std::vector<char> on_boundary_;  // per Voronoi vertex
    std::vector<double> sidedness_;  // per Voronoi vertex: > 0 inside
};

Vec2 Builder::sourcePoint(const Cell& cell) const {
    const Chord& c = chordOf(cell);
    return cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT ? Vec2(c.x0, c.y0)
                                                                                         : Vec2(c.x1, c.y1);
}

int Builder::siteOf(const Cell& cell) const {
    const Chord& chord = chordOf(cell);
    if (cell.contains_segment()) return chord.site;
    return cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT ? chord.start_site
                                                                                         : chord.end_site;
}

void Builder::construct() {
    boost::polygon::voronoi_builder<std::int32_t> builder;
    for (const Chord& c : set().chords)
        builder.insert_segment(c.x0, c.y0, c.x1, c.y1);
    builder.construct(&diagram_);
    for (const Cell& cell : diagram_.cells())
        site_of_cell_.push_back(siteOf(cell));
}

void Builder::findBoundaryVertices() {
    for (const VVertex& v : diagram_.vertices()) {
        const Chord& c = chordOf(*v.incident_edge()->cell());
        const auto near = [&](double x, double y) {
            return std::hypot(v.x() - x, v.y() - y) < kOnBoundaryUnits;
        };
        on_boundary_.push_back(near(c.x0, c.y0) || near(c.x1, c.y1));
    }
}

/// Direction in which an unbounded edge runs from its cell on the left and its twin's on the right.
Vec2 Builder::farDirection(const VEdge* e) const {
    const Cell &left = *e->cell(), &right = *e->twin()->cell();
    const auto middle = [&](const Cell& cell) -> Vec2 {
        if (!cell.contains_segment()) return sourcePoint(cell);
        const Chord& c = chordOf(cell);
        return {(static_cast<double>(c.x0) + c.x1) / 2, (static_cast<double>(c.y0) + c.y1) / 2};
    };
    const Vec2 across = middle(right) - middle(left);
    if (!left.contains_segment() && !right.contains_segment()) return leftNormal(across).normalized();
    const Chord& c = chordOf(left.contains_segment() ? left : right);
    const Vec2 along(static_cast<double>(c.x1) - c.x0, static_cast<double>(c.y1) - c.y0);
    return (along.dot(across) > 0 ? 1 : -1) * leftNormal(along).normalized();
}

/// Both ends in grid units, far away where the edge is unbounded.
std::pair<Vec2, Vec2> Builder::endsOf(const VEdge* e) const {
    const VVertex *a = e->vertex0(), *b = e->vertex1();
    if (a && b) return {{a->x(), a->y()}, {b->x(), b->y()}};
    const Vec2 far = kFarUnits * farDirection(e);
    if (a) return {{a->x(), a->y()}, Vec2(a->x(), a->y()) + far};
    if (b) return {Vec2(b->x(), b->y()) - far, {b->x(), b->y()}};
    const Cell& cell = e->cell()->contains_segment() ? *e->twin()->cell() : *e->cell();
    const Vec2 at = sourcePoint(cell);
    return {at - far, at + far};
}

/// Between two chords in one line the Voronoi edge through their common end goes on to the other side
/// without a vertex at the boundary. Returns that end.
std::optional<Vec2> Builder::boundaryCrossing(const VEdge* e) const {
    if (e->is_primary()) return std::nullopt;
    const VEdge* s = e->cell()->contains_segment() ? e : e->twin();
    if (!s->cell()->contains_segment()) return std::nullopt;
    const Chord& c = chordOf(*s->cell());
    const Vec2 start(c.x0, c.y0), end(c.x1, c.y1);
    const Vec2 u = (end - start).normalized();
    const auto [a, b] = endsOf(s);
    const double ha = cross(u, a - start), hb = cross(u, b - start);
    if (ha * hb >= 0 || std::min(std::abs(ha), std::abs(hb)) <= kOnBoundaryUnits) return std::nullopt;
    const Vec2& near = std::abs(ha) < std::abs(hb) ? a : b;
    return u.dot(near - start) < u.dot(end - near) ? start : end;
}

/// Floods the diagram from vertex to vertex without passing the boundary; each flooded part lies on one
/// side, told by where its vertices lie from the segments they belong to.
void Builder::findSides() {
    sidedness_.assign(diagram_.vertices().size(), 0);
    std::vector<char> seen(diagram_.vertices().size(), 0);
    std::vector<const VVertex*> part;
    for (const VVertex& seed : diagram_.vertices()) {
        if (seen[indexOf(&seed)] || on_boundary_[indexOf(&seed)]) continue;
        part.assign(1, &seed);
        seen[indexOf(&seed)] = 1;
        double vote = 0;
        for (std::size_t k = 0; k < part.size(); ++k) {
            const VEdge* e = part[k]->incident_edge();
            do {
                if (e->cell()->contains_segment()) {
                    const Chord& c = chordOf(*e->cell());
                    const Vec2 u(static_cast<double>(c.x1) - c.x0, static_cast<double>(c.y1) - c.y0);
                    vote += cross(u, Vec2(part[k]->x() - c.x0, part[k]->y() - c.y0)) / u.norm();
                }
                const VVertex* to = e->vertex1();
                if (to && !seen[indexOf(to)] && !on_boundary_[indexOf(to)] && !boundaryCrossing(e)) {
                    seen[indexOf(to)] = 1;
                    part.push_back(to);
                }
                e = e->rot_next();
            } while (e != part[k]->incident_edge());
        }
        for (const VVertex* v : part)
            sidedness_[indexOf(v)] = vote;
    }
}

int Builder::addVertex(const Vec2& point, double clearance) {
    graph_.vertices.push_back({point, clearance, false});
    return static_cast<int>(graph_.vertices.size()) - 1;
}

void Builder::settleVertices() {
    std::vector<int> sites;
    for (const VVertex& v : diagram_.vertices()) {
        const int index = addVertex(set().toMm(v.x(), v.y()), 0);
        if (on_boundary_[indexOf(&v)]) continue;
        sites.clear();
        const VEdge* e = v.incident_edge();
        do {
            const int s = cellSite(e);
            if (sites.empty() || sites.back() != s) sites.push_back(s);
            e = e->rot_next();
        } while (e != v.incident_edge());
        if (sites.size() > 1 && sites.front() == sites.back()) sites.pop_back();
        settle(graph_.vertices[static_cast<std::size_t>(index)], set(), sideOf(&v), sites, chord_mm_);
    }
}

/// Clearance along the bisector of two sites has its extrema on their axis of symmetry.
void Builder::splitWhereClearanceTurns(const VEdge* e, Chain& chain) {
    const int p = cellSite(e), q = cellSite(e->twin());
    const Vec2 from = graph_.vertices[static_cast<std::size_t>(chain.vertices.front())].point;
    const Vec2 to = graph_.vertices[static_cast<std::size_t>(chain.vertices.back())].point;
    const std::optional<Axis> axis = axisOf(site(p), site(q));
    if (!axis) return;
    const double ha = cross(axis->dir, from - axis->point), hb = cross(axis->dir, to - axis->point);
    if ((ha > 0) == (hb > 0)) return;
    if (sharedNormal(set(), p, q, chain.sides.front(), from)) return;
    const Vec2 near = from + ha / (ha - hb) * (to - from);
    std::optional<Vec2> best;
    for (const Vec2& m : criticalPoints(site(p), site(q), chain.sides.front()))
        if (!best || (m - near).norm() < (*best - near).norm()) best = m;
    if (!best || (*best - near).norm() > (to - from).norm() + 4 * chord_mm_) return;
    const double clearance = std::abs(signedDistance(site(p), chain.sides.front(), *best));
    // On the circle, but is it on the arc?
    if (std::max(distanceToSite(site(p), *best), distanceToSite(site(q), *best)) > clearance + chord_mm_)
        return;
    chain.vertices.insert(chain.vertices.begin() + 1, addVertex(*best, clearance));
    chain.sides.push_back(chain.sides.front());
}

Chain Builder::chainOf(const VEdge* e) {
    const auto [a, b] = endsOf(e);
    const VVertex *v0 = e->vertex0(), *v1 = e->vertex1();
    const auto endVertex = [&](const VVertex* v, const Vec2& at) {
        constexpr double kFar = std::numeric_limits<double>::infinity();
        return v ? static_cast<int>(indexOf(v)) : addVertex(set().toMm(at.x(), at.y()), kFar);
    };
    const auto sideAt = [&](const VVertex* v, const VVertex* other) {
        if (v && !on_boundary_[indexOf(v)]) return sideOf(v);
        return v && other && !on_boundary_[indexOf(other)] ? sideOf(other) : Side::Outside;
    };
    Chain chain;
    chain.vertices = {endVertex(v0, a), endVertex(v1, b)};
    if (const std::optional<Vec2> end = boundaryCrossing(e)) {
        chain.vertices.insert(chain.vertices.begin() + 1, addVertex(set().toMm(end->x(), end->y()), 0));
        chain.sides = {sideAt(v0, nullptr), sideAt(v1, nullptr)};
        return chain;
    }
    chain.sides = {sideAt(v0, v1)};
    if (cellSite(e) != cellSite(e->twin())) splitWhereClearanceTurns(e, chain);
    return chain;
}

/// Numbers the half-edges cell by cell, counter-clockwise.
void Builder::layOutCells() {
    std::vector<Chain> chains(diagram_.edges().size());
    for (const VEdge& e : diagram_.edges()) {
        const std::size_t k = indexOf(&e), t = indexOf(e.twin());
        if (t < k) {
            chains[k].vertices.assign(chains[t].vertices.rbegin(), chains[t].vertices.rend());
            chains[k].sides.assign(chains[t].sides.rbegin(), chains[t].sides.rend());
        } else {
            chains[k] = chainOf(&e);
        }
    }
    int cell_index = 0;
    for (const Cell& cell : diagram_.cells()) {
        const VEdge* e = cell.incident_edge();
        if (!e) continue;
        do {
            Chain& chain = chains[indexOf(e)];
            chain.first_half = static_cast<int>(graph_.edges.size());
            for (std::size_t k = 0; k < chain.sides.size(); ++k)
                graph_.edges.push_back(
                    {chain.vertices[k], chain.vertices[k + 1], -1, cellSite(e), cell_index, chain.sides[k]});
            e = e->next();
        } while (e != cell.incident_edge());
        ++cell_index;
    }
    for (const VEdge& e : diagram_.edges()) {
        const Chain &chain = chains[indexOf(&e)], &twin = chains[indexOf(e.twin())];
        STEPMILL_CHECK(chain.first_half >= 0, "every Voronoi edge belongs to a cell");
        const int n = static_cast<int>(chain.sides.size());
        for (int k = 0; k < n; ++k)
            graph_.edges[static_cast<std::size_t>(chain.first_half + k)].twin = twin.first_half + n - 1 - k;
    }
}

void Builder::markNecks() {
    std::vector<char> ways_on(graph_.vertices.size(), 0);
    for (const HalfEdge& e : graph_.edges) {
        if (e.site == graph_.edges[static_cast<std::size_t>(e.twin)].site) continue;
        const Vertex &from = graph_.vertices[static_cast<std::size_t>(e.from)],
                     &to = graph_.vertices[static_cast<std::size_t>(e.to)];
        if (to.clearance > from.clearance - kLevel_mm)
            ways_on[static_cast<std::size_t>(e.from)] =
                static_cast<char>(std::min(2, ways_on[static_cast<std::size_t>(e.from)] + 1));
    }
    for (std::size_t k = 0; k < ways_on.size(); ++k)
        graph_.vertices[k].neck = ways_on[k] > 1;
}

Graph Builder::build() {
    construct();
    findBoundaryVertices();
    findSides();
    settleVertices();
    layOutCells();
    markNecks();
    return std::move(graph_);
}

}  // namespace

Graph buildGraph(SiteSet set, double chord_mm) {
    return Builder(std::move(set), chord_mm).build();
}

}  // namespace stepmill::clearance
