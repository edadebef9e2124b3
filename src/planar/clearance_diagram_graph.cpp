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

class Builder {
  public:
    Builder(SiteSet&& set, double chord_mm) : chord_mm_(chord_mm) { graph_.set = std::move(set); }
    Graph build();

  private:
    const SiteSet& set() const { return graph_.set; }
    const Site& site(int index) const { return set().sites[static_cast<std::size_t>(index)]; }
    const Chord& chordOf(const Cell& cell) const { return set().chords[cell.source_index()]; }
    int siteOf(const Cell& cell) const;
    std::size_t indexOf(const VEdge* e) const {
        return static_cast<std::size_t>(e - diagram_.edges().data());
    }
    std::size_t indexOf(const VVertex* v) const {
        return static_cast<std::size_t>(v - diagram_.vertices().data());
    }
    bool kept(const VEdge* e) const { return kept_[indexOf(e)] != 0; }
    int cellSite(const VEdge* e) const {
        return site_of_cell_[static_cast<std::size_t>(e->cell() - diagram_.cells().data())];
    }
    Vec2 toMm(const VVertex* v) const { return set().toMm(v->x(), v->y()); }

    void construct();
    void findBoundaryVertices();
    std::optional<Vec2> boundaryCrossing(const VEdge* e) const;
    Side sideOf(const VVertex* v) const { return sidedness_[indexOf(v)] > 0 ? Side::Inside : Side::Outside; }
    void findSides();
    void findNodes();
    int makeNode(const VVertex* v);
    void followChains();
    void linkCells();
    const VEdge* nextKept(const VEdge* e) const;
    const VEdge* previousKept(const VEdge* e) const;

    Graph graph_;
    double chord_mm_;
    Diagram diagram_;
    std::vector<int> site_of_cell_;
    std::vector<char> kept_;              // per Voronoi half-edge
    std::vector<char> on_boundary_;       // per Voronoi vertex
    std::vector<double> sidedness_;       // per Voronoi vertex: > 0 inside
    std::vector<int> node_of_;            // per Voronoi vertex, -1 where none
    std::vector<int> edge_ending_;        // per Voronoi half-edge: graph half-edge whose chain ends with it
    std::vector<const VEdge*> first_of_;  // per graph half-edge: its first Voronoi half-edge
    std::vector<std::vector<Vec2>> courses_;  // per pair of graph half-edges: points between its ends
};

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
    for (const VEdge& e : diagram_.edges())
        kept_.push_back(cellSite(&e) != cellSite(e.twin()));
    for (const VEdge& e : diagram_.edges())
        if (kept(&e) && e.is_infinite())
            throw Error(ErrorCode::GeometryKernel, "clearance diagram", "a bisector escapes its frame");
}

void Builder::findBoundaryVertices() {
    for (const VVertex& v : diagram_.vertices()) {
        const Cell& cell = *v.incident_edge()->cell();
        const Chord& c = chordOf(cell);
        const auto near = [&](double x, double y) {
            return std::hypot(v.x() - x, v.y() - y) < kOnBoundaryUnits;
        };
        on_boundary_.push_back(near(c.x0, c.y0) || near(c.x1, c.y1));
    }
}

/// Between two chords in one line the Voronoi edge through their common end goes on to the other side
/// without a vertex at the boundary. Returns that end.
std::optional<Vec2> Builder::boundaryCrossing(const VEdge* e) const {
    if (e->is_primary() || e->is_infinite()) return std::nullopt;
    const VEdge* s = e->cell()->contains_segment() ? e : e->twin();
    if (!s->cell()->contains_segment()) return std::nullopt;
    const Chord& c = chordOf(*s->cell());
    const Vec2 start(c.x0, c.y0), end(c.x1, c.y1);
    const Vec2 u = (end - start).normalized();
    const Vec2 a(e->vertex0()->x(), e->vertex0()->y()), b(e->vertex1()->x(), e->vertex1()->y());
    const double ha = cross(u, a - start), hb = cross(u, b - start);
    if (ha * hb >= 0 || std::min(std::abs(ha), std::abs(hb)) <= kOnBoundaryUnits) return std::nullopt;
    return u.dot(a - start) < u.dot(end - a) ? start : end;
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

void Builder::findNodes() {
    node_of_.assign(diagram_.vertices().size(), -1);
    for (const VVertex& v : diagram_.vertices()) {
        int degree = 0;
        const VEdge* e = v.incident_edge();
        do {
            degree += kept(e);
            e = e->rot_next();
        } while (e != v.incident_edge());
        if (degree >= 3 || (degree > 0 && on_boundary_[indexOf(&v)])) makeNode(&v);
    }
}

int Builder::makeNode(const VVertex* v) {
    Node node;
    node.on_boundary = on_boundary_[indexOf(v)] != 0;
    node.point = node.on_boundary ? set().toMm(std::round(v->x()), std::round(v->y())) : toMm(v);
    node_of_[indexOf(v)] = static_cast<int>(graph_.nodes.size());
    graph_.nodes.push_back(node);
    return node_of_[indexOf(v)];
}

const VEdge* Builder::nextKept(const VEdge* e) const {
    const VEdge* n = e->next();
    while (!kept(n))
        n = n->twin()->next();
    return n;
}

const VEdge* Builder::previousKept(const VEdge* e) const {
    const VEdge* n = e->prev();
    while (!kept(n))
        n = n->twin()->prev();
    return n;
}

void Builder::followChains() {
    edge_ending_.assign(diagram_.edges().size(), -1);
    std::vector<char> done(diagram_.edges().size(), 0);
    const auto follow = [&](const VEdge* first) {
        std::vector<const VEdge*> chain{first};
        while (node_of_[indexOf(chain.back()->vertex1())] < 0)
            chain.push_back(nextKept(chain.back()));
        for (const VEdge* e : chain)
            done[indexOf(e)] = done[indexOf(e->twin())] = 1;
        const int p = cellSite(first), q = cellSite(first->twin());
        int from = node_of_[indexOf(chain.front()->vertex0())];
        std::vector<Vec2> course;
        Side side = Side::Outside;
        int last = -1;
        // One pair of half-edges for each stretch between boundary crossings.
        const auto addPair = [&](int to) {
            const int forward = static_cast<int>(graph_.edges.size());
            graph_.edges.push_back({from, to, p, forward + 1, last, -1, side});
            graph_.edges.push_back({to, from, q, forward, -1, -1, side});
            first_of_.push_back(last < 0 ? first : nullptr);
            first_of_.push_back(nullptr);
            if (last >= 0) graph_.edges[static_cast<std::size_t>(last) + 1].prev = forward + 1;
            courses_.push_back(std::move(course));
            course.clear();
            from = to;
            last = forward;
        };
        edge_ending_[indexOf(first->twin())] = static_cast<int>(graph_.edges.size()) + 1;
        for (const VEdge* e : chain) {
            if (!on_boundary_[indexOf(e->vertex0())]) side = sideOf(e->vertex0());
            if (e != first) course.push_back(toMm(e->vertex0()));
            if (const std::optional<Vec2> end = boundaryCrossing(e)) {
                Node node;
                node.on_boundary = true;
                node.point = set().toMm(end->x(), end->y());
                graph_.nodes.push_back(node);
                addPair(static_cast<int>(graph_.nodes.size()) - 1);
            }
            if (!on_boundary_[indexOf(e->vertex1())]) side = sideOf(e->vertex1());
        }
        addPair(node_of_[indexOf(chain.back()->vertex1())]);
        edge_ending_[indexOf(chain.back())] = last;
        first_of_.back() = chain.back()->twin();
    };
    for (const VEdge& e : diagram_.edges())
        if (kept(&e) && !done[indexOf(&e)] && node_of_[indexOf(e.vertex0())] >= 0) follow(&e);
    // What is left are closed bisectors, between a circle and what is inside it.
    for (const VEdge& e : diagram_.edges()) {
        if (!kept(&e) || done[indexOf(&e)]) continue;
        makeNode(e.vertex0());
        follow(&e);
    }
}

void Builder::linkCells() {
    for (std::size_t k = 0; k < graph_.edges.size(); ++k) {
        int& prev = graph_.edges[k].prev;
        if (first_of_[k]) prev = edge_ending_[indexOf(previousKept(first_of_[k]))];
        STEPMILL_CHECK(prev >= 0, "cell boundaries close");
        graph_.edges[static_cast<std::size_t>(prev)].next = static_cast<int>(k);
    }
}

Graph Builder::build() {
    construct();
    findBoundaryVertices();
    findSides();
    findNodes();
    followChains();
    linkCells();
    refineGraph(graph_, courses_, chord_mm_);
    return std::move(graph_);
}

}  // namespace

Graph buildGraph(SiteSet set, double chord_mm) {
    return Builder(std::move(set), chord_mm).build();
}

}  // namespace stepmill::clearance
