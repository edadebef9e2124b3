#include <Eigen/Dense>

#include "planar/clearance_diagram_graph.h"

namespace stepmill::clearance {

namespace {

// Equal distances may differ by the grid's rounding of end points, magnified where bisectors are flat.
constexpr double kEquidistant_mm = 1e-5;

struct Pair {
    int p, q;
    std::optional<Ray> ray;
};

class Refiner {
  public:
    Refiner(Graph& graph, const std::vector<std::vector<Vec2>>& courses, double chord_mm)
        : graph_(graph), courses_(courses), chord_mm_(chord_mm) {}
    void run();

  private:
    const Site& site(int index) const { return graph_.set.sites[static_cast<std::size_t>(index)]; }
    const SiteSet& set() const { return graph_.set; }
    HalfEdge& edge(int h) { return graph_.edges[static_cast<std::size_t>(h)]; }
    Node& node(int n) { return graph_.nodes[static_cast<std::size_t>(n)]; }

    void refineAll();
    void refine(Node& node, Side side, const std::vector<int>& cells) const;
    void exchangeEdges();
    bool tryExchange(int half);
    bool invades(const Node& node, int other) const;
    void splitAtExtrema(int half);
    int splitEdge(int half, const Node& at);
    void markNecks();

    Graph& graph_;
    const std::vector<std::vector<Vec2>>& courses_;
    double chord_mm_;
    std::vector<int> degree_;
};

void Refiner::refineAll() {
    std::vector<std::vector<int>> cells(graph_.nodes.size());
    std::vector<Side> sides(graph_.nodes.size(), Side::Outside);
    degree_.assign(graph_.nodes.size(), 0);
    std::vector<char> seen(graph_.edges.size(), 0);
    for (std::size_t h = 0; h < graph_.edges.size(); ++h) {
        const int n = graph_.edges[h].from;
        if (seen[h] || node(n).on_boundary) continue;
        // Once around the node: the cells that meet there, in order.
        for (int k = static_cast<int>(h); !seen[static_cast<std::size_t>(k)]; k = edge(edge(k).prev).twin) {
            seen[static_cast<std::size_t>(k)] = 1;
            cells[static_cast<std::size_t>(n)].push_back(edge(k).site);
            ++degree_[static_cast<std::size_t>(n)];
        }
        sides[static_cast<std::size_t>(n)] = graph_.edges[h].side;
    }
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n)
        if (!graph_.nodes[n].on_boundary) refine(graph_.nodes[n], sides[n], cells[n]);
}

/// Gauss-Newton on the true bisectors of neighbouring cells at the node.
void Refiner::refine(Node& node, Side side, const std::vector<int>& cells) const {
    std::vector<Pair> pairs;
    bool at_frame = false;
    double largest_radius = 0;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const int p = cells[k], q = cells[(k + 1) % cells.size()];
        at_frame = at_frame || p == set().frame_site;
        largest_radius = std::max(largest_radius, site(p).radius);
        pairs.push_back({p, q, sharedNormal(set(), p, q, side, node.point)});
    }
    node.exact = true;
    const auto trueClearance = [&](const Vec2& at) {
        double least = std::numeric_limits<double>::infinity();
        for (const Pair& pair : pairs)
            least = std::min(least, distanceToSite(site(pair.p), at));
        return least;
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
    constexpr double kResidual_mm = 3e-6;  // end points lie up to 1 nm off their arcs
    const double slack = 4 * std::max(chord_mm_, set().unit_mm);
    const double reach = 12 * std::sqrt(2 * slack * std::max(largest_radius, rough)) + slack;
    double clearance = trueClearance(at);
    double farthest = 0;
    for (const Pair& pair : pairs)
        farthest = std::max(farthest, distanceToSite(site(pair.p), at));
    const bool equidistant = residual < kResidual_mm && farthest - clearance < kEquidistant_mm;
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

bool Refiner::invades(const Node& n, int other) const {
    if (other == set().frame_site) return false;
    return distanceToSite(site(other), n.point) < n.clearance - kEquidistant_mm;
}

/// Chords a sagitta off can put the vertices at both ends of an edge in the wrong order. As in a Delaunay
/// triangulation the edge then gives way to the one between its end cells, if that mends more than it breaks.
///
///      A              A
///   C --- D   from    |    to     the edge separates A and B at first, C and D afterwards
///      B              B
bool Refiner::tryExchange(int e) {
    const int t = edge(e).twin;
    const int u = edge(e).from, v = edge(e).to;
    if (u == v || node(u).on_boundary || node(v).on_boundary) return false;
    if (degree_[static_cast<std::size_t>(u)] != 3 || degree_[static_cast<std::size_t>(v)] != 3) return false;
    const int pa = edge(e).prev, na = edge(e).next, pb = edge(t).prev, nb = edge(t).next;
    const int a = edge(e).site, b = edge(t).site, c = edge(edge(pa).twin).site, d = edge(edge(na).twin).site;
    const int frame = set().frame_site;
    if (c == d || a == frame || b == frame || c == frame || d == frame) return false;
    if (pa == na || pb == nb) return false;
    const auto faults = [&](const Node& first, int other_first, const Node& second, int other_second) {
        return int(!first.exact) + int(!second.exact) + int(invades(first, other_first)) +
               int(invades(second, other_second));
    };
    const int before = faults(node(u), d, node(v), c);
    if (before == 0) return false;
    Node top, bottom;
    top.point = bottom.point = (node(u).point + node(v).point) / 2;
    refine(top, edge(e).side, {a, c, d});
    refine(bottom, edge(e).side, {b, d, c});
    if (faults(top, b, bottom, a) >= before) return false;
    node(u) = top;
    node(v) = bottom;
    edge(e).from = v, edge(e).to = u, edge(e).site = c;
    edge(t).from = u, edge(t).to = v, edge(t).site = d;
    const int pa_twin = edge(pa).twin, na_twin = edge(na).twin, pb_twin = edge(pb).twin,
              nb_twin = edge(nb).twin;
    edge(na).from = edge(na_twin).to = u;
    edge(nb).from = edge(nb_twin).to = v;
    const auto link = [&](int first, int second) {
        edge(first).next = second;
        edge(second).prev = first;
    };
    link(pa, na);
    link(pb, nb);
    link(nb_twin, e);
    link(e, pa_twin);
    link(na_twin, t);
    link(t, pb_twin);
    return true;
}

void Refiner::exchangeEdges() {
    constexpr int kRounds = 8;
    bool changed = true;
    for (int round = 0; round < kRounds && changed; ++round) {
        changed = false;
        for (std::size_t h = 0; h < graph_.edges.size(); h += 2)
            changed |= tryExchange(static_cast<int>(h));
    }
}

/// Puts a node on the edge; returns the new half-edge from there to where the old one went.
int Refiner::splitEdge(int h, const Node& at) {
    const int m = static_cast<int>(graph_.nodes.size());
    graph_.nodes.push_back(at);
    const int h2 = static_cast<int>(graph_.edges.size()), t2 = h2 + 1, t = edge(h).twin;
    graph_.edges.push_back(edge(h));
    graph_.edges.push_back(edge(t));
    edge(h2).from = edge(t2).to = m;
    edge(h2).twin = t2;
    edge(t2).twin = h2;
    edge(h).to = edge(t).from = m;
    const auto link = [&](int first, int second) {
        edge(first).next = second;
        edge(second).prev = first;
    };
    const int after = edge(h).next, before = edge(t).prev;
    link(h2, after);
    link(h, h2);
    link(before, t2);
    link(t2, t);
    return h2;
}

void Refiner::splitAtExtrema(int half) {
    const int ip = edge(half).site, iq = edge(edge(half).twin).site;
    if (ip == set().frame_site || iq == set().frame_site) return;
    const Site &p = site(ip), &q = site(iq);
    if (!p.round() && !q.round()) return;
    const Side side = edge(half).side;
    std::vector<Vec2> course{node(edge(half).from).point};
    const std::vector<Vec2>& between = courses_[static_cast<std::size_t>(half) / 2];
    course.insert(course.end(), between.begin(), between.end());
    course.push_back(node(edge(half).to).point);
    if (sharedNormal(set(), ip, iq, side, (course.front() + course.back()) / 2)) return;
    struct Split {
        std::size_t link;
        double along;
        Vec2 point;
    };
    std::vector<Split> splits;
    for (const Vec2& m : criticalPoints(p, q, side)) {
        for (std::size_t k = 0; k + 1 < course.size(); ++k) {
            const Vec2 &a = course[k], &b = course[k + 1];
            if (!footBetween(p, a, b, m) || !footBetween(q, a, b, m)) continue;
            splits.push_back({k, (m - a).dot(b - a), m});
            break;
        }
    }
    std::sort(splits.begin(), splits.end(), [](const Split& a, const Split& b) {
        return a.link != b.link ? a.link < b.link : a.along < b.along;
    });
    for (const Split& s : splits) {
        Node extremum;
        extremum.point = s.point;
        extremum.clearance = std::max(0.0, signedDistance(p, side, s.point));
        half = splitEdge(half, extremum);
    }
}

void Refiner::markNecks() {
    constexpr double kLevel_mm = 1e-4;    // clearance changes less along a passage of one width
    constexpr double kPassage_mm = 1e-2;  // shorter ones are not worth the name
    std::vector<int> rising(graph_.nodes.size(), 0);
    for (const HalfEdge& e : graph_.edges) {
        Node& from = graph_.nodes[static_cast<std::size_t>(e.from)];
        Node& to = graph_.nodes[static_cast<std::size_t>(e.to)];
        if (to.clearance > from.clearance + 1e-9) ++rising[static_cast<std::size_t>(e.from)];
        if (std::abs(to.clearance - from.clearance) < kLevel_mm &&
            (to.point - from.point).norm() > kPassage_mm)
            from.neck = to.neck = true;
    }
    for (std::size_t k = 0; k < rising.size(); ++k)
        if (rising[k] >= 2) graph_.nodes[k].neck = true;
}

void Refiner::run() {
    refineAll();
    exchangeEdges();
    const std::size_t count = graph_.edges.size();
    for (std::size_t h = 0; h < count; h += 2)
        splitAtExtrema(static_cast<int>(h));
    markNecks();
}

}  // namespace

void refineGraph(Graph& graph, const std::vector<std::vector<Vec2>>& courses, double chord_mm) {
    Refiner(graph, courses, chord_mm).run();
}

}  // namespace stepmill::clearance
