#include "planar/clearance_diagram_graph.h"

#include <boost/polygon/voronoi_builder.hpp>
#include <boost/polygon/voronoi_diagram.hpp>
#include <Eigen/Dense>

#include "stepmill/core/error.h"

namespace stepmill::clearance {

namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using Cell = Diagram::cell_type;
using VEdge = Diagram::edge_type;
using VVertex = Diagram::vertex_type;

// Voronoi vertices this close to a chord's end are that end.
constexpr double kOnBoundaryUnits = 0.25;

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
    void findSides();
    void findNodes();
    int makeNode(const VVertex* v);
    void refine(Node& node, const VVertex* v) const;
    void followChains();
    void splitAtExtrema(std::vector<int>& chain_nodes, const std::vector<const VEdge*>& chain, Side side);
    void linkPrevious();
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
    std::vector<const VEdge*> first_of_;  // per graph half-edge: its first Voronoi half-edge, or null
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
                if (to && !seen[indexOf(to)] && !on_boundary_[indexOf(to)]) {
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
    if (on_boundary_[indexOf(v)]) {
        node.point = set().toMm(std::round(v->x()), std::round(v->y()));
    } else {
        node.point = toMm(v);
        refine(node, v);
    }
    node_of_[indexOf(v)] = static_cast<int>(graph_.nodes.size());
    graph_.nodes.push_back(node);
    return node_of_[indexOf(v)];
}

/// Gauss-Newton on the true bisectors that meet at the node.
void Builder::refine(Node& node, const VVertex* v) const {
    const Side side = sidedness_[indexOf(v)] > 0 ? Side::Inside : Side::Outside;
    struct Pair {
        int p, q;
        std::optional<Ray> ray;
    };
    std::vector<Pair> pairs;
    bool at_frame = false;
    double largest_radius = 0;
    const VEdge* e = v->incident_edge();
    do {
        if (kept(e)) {
            const int p = cellSite(e), q = cellSite(e->twin());
            at_frame = at_frame || p == set().frame_site || q == set().frame_site;
            largest_radius = std::max(largest_radius, site(p).radius);
            pairs.push_back({p, q, sharedNormal(set(), p, q, side, node.point)});
        }
        e = e->rot_next();
    } while (e != v->incident_edge());
    const auto trueClearance = [&](const Vec2& at) {
        double least = std::numeric_limits<double>::infinity();
        for (const Pair& pair : pairs)
            least = std::min(least, signedDistance(site(pair.p), side, at));
        return std::max(0.0, least);
    };
    if (at_frame) {
        // Nobody asks for offsets that reach the frame.
        node.clearance = std::numeric_limits<double>::infinity();
        return;
    }
    const Vec2 start = node.point;
    const double rough = trueClearance(start);
    Vec2 at = start;
    double residual = 0;
    constexpr int kMaxSteps = 50;
    constexpr double kConverged_mm = 1e-11;
    for (int step = 0; step < kMaxSteps; ++step) {
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Vec2 rhs = Vec2::Zero();
        residual = 0;
        const auto add = [&](const Vec2& gradient, double value) {
            normal += gradient * gradient.transpose();
            rhs -= gradient * value;
            residual = std::max(residual, std::abs(value));
        };
        const auto gradient = [&](const Site& s) -> Vec2 {
            if (s.kind == SiteKind::Line)
                return side == Side::Inside ? leftNormal(s.dir) : Vec2(-leftNormal(s.dir));
            const Vec2 r = at - s.centre;
            const double n = r.norm();
            if (n < 1e-12) return Vec2::Zero();
            return s.concaveOn(side) ? Vec2(-r / n) : Vec2(r / n);
        };
        for (const Pair& pair : pairs) {
            const Site &p = site(pair.p), &q = site(pair.q);
            if (pair.ray) {
                const Vec2 tangent = leftNormal(pair.ray->normal);
                add(tangent, tangent.dot(at - pair.ray->from));
            } else if (p.kind == SiteKind::Arc && q.kind == SiteKind::Arc && p.concaveOn(side) &&
                       q.concaveOn(side) && p.centre == q.centre && p.radius == q.radius) {
                add(Vec2::UnitX(), at.x() - p.centre.x());
                add(Vec2::UnitY(), at.y() - p.centre.y());
            } else {
                add(gradient(p) - gradient(q), signedDistance(p, side, at) - signedDistance(q, side, at));
            }
        }
        const double trace = normal.trace();
        if (trace <= 0) break;
        normal.diagonal().array() += 1e-13 * trace;
        const Vec2 move = normal.ldlt().solve(rhs);
        at += move;
        if (residual < kConverged_mm || move.norm() < kConverged_mm) break;
    }
    // Where a circle's centre is near, chords of one sagitta s shift a vertex by up to sqrt(2 R s).
    constexpr double kResidual_mm = 1e-8;
    const double slack = 4 * std::max(chord_mm_, set().unit_mm);
    const double reach = 4 * std::sqrt(2 * slack * std::max(largest_radius, rough)) + slack;
    double clearance = trueClearance(at);
    double farthest = 0;
    for (const Pair& pair : pairs)
        farthest = std::max(farthest, distanceToSite(site(pair.p), at));
    const bool equidistant = residual < kResidual_mm && farthest - clearance < slack;
    for (const Pair& pair : pairs)
        if (pair.ray) clearance = pair.ray->normal.dot(at - pair.ray->from);
    if (equidistant && (at - start).norm() < reach && clearance >= 0) {
        node.point = at;
        node.clearance = clearance;
    } else {
        node.clearance = rough;
        node.exact = false;
    }
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
        double vote = 0;
        for (const VEdge* e : chain)
            for (const VVertex* v : {e->vertex0(), e->vertex1()})
                if (!on_boundary_[indexOf(v)]) vote = sidedness_[indexOf(v)];
        const Side side = vote > 0 ? Side::Inside : Side::Outside;
        std::vector<int> nodes{node_of_[indexOf(chain.front()->vertex0())],
                               node_of_[indexOf(chain.back()->vertex1())]};
        splitAtExtrema(nodes, chain, side);
        const int base = static_cast<int>(graph_.edges.size());
        const int pieces = static_cast<int>(nodes.size()) - 1;
        for (int k = 0; k < pieces; ++k) {
            const int a = nodes[static_cast<std::size_t>(k)], b = nodes[static_cast<std::size_t>(k) + 1];
            const int forward = base + 2 * k, backward = forward + 1;
            graph_.edges.push_back({a, b, p, backward, k > 0 ? forward - 2 : -1, side});
            graph_.edges.push_back({b, a, q, forward, k + 1 < pieces ? backward + 2 : -1, side});
            first_of_.push_back(k > 0 ? nullptr : first);
            first_of_.push_back(k + 1 < pieces ? nullptr : chain.back()->twin());
        }
        edge_ending_[indexOf(chain.back())] = base + 2 * (pieces - 1);
        edge_ending_[indexOf(first->twin())] = base + 1;
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

void Builder::splitAtExtrema(std::vector<int>& nodes, const std::vector<const VEdge*>& chain, Side side) {
    const int ip = cellSite(chain.front()), iq = cellSite(chain.front()->twin());
    if (ip == set().frame_site || iq == set().frame_site) return;
    const Site &p = site(ip), &q = site(iq);
    if (!p.round() && !q.round()) return;
    const Vec2 from = graph_.nodes[static_cast<std::size_t>(nodes.front())].point;
    const Vec2 to = graph_.nodes[static_cast<std::size_t>(nodes.back())].point;
    if (sharedNormal(set(), ip, iq, side, (from + to) / 2)) return;
    struct Split {
        std::size_t link;
        double along;
        Vec2 point;
    };
    std::vector<Split> splits;
    for (const Vec2& m : criticalPoints(p, q, side)) {
        for (std::size_t k = 0; k < chain.size(); ++k) {
            const Vec2 a = k == 0 ? from : toMm(chain[k]->vertex0());
            const Vec2 b = k + 1 == chain.size() ? to : toMm(chain[k]->vertex1());
            if (!footBetween(p, a, b, m) || !footBetween(q, a, b, m)) continue;
            splits.push_back({k, (m - a).dot(b - a), m});
            break;
        }
    }
    std::sort(splits.begin(), splits.end(), [](const Split& a, const Split& b) {
        return a.link != b.link ? a.link < b.link : a.along < b.along;
    });
    for (const Split& s : splits) {
        nodes.insert(nodes.end() - 1, static_cast<int>(graph_.nodes.size()));
        graph_.nodes.push_back({s.point, std::max(0.0, signedDistance(p, side, s.point)), true});
    }
}

void Builder::linkPrevious() {
    for (std::size_t k = 0; k < graph_.edges.size(); ++k) {
        if (!first_of_[k]) continue;
        graph_.edges[k].prev = edge_ending_[indexOf(previousKept(first_of_[k]))];
        STEPMILL_CHECK(graph_.edges[k].prev >= 0, "cell boundaries close");
    }
}

Graph Builder::build() {
    construct();
    findBoundaryVertices();
    findSides();
    findNodes();
    followChains();
    linkPrevious();
    return std::move(graph_);
}

}  // namespace

Graph buildGraph(SiteSet set, double chord_mm) {
    return Builder(std::move(set), chord_mm).build();
}

}  // namespace stepmill::clearance
