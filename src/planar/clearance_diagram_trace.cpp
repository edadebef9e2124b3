#include "planar/clearance_diagram_trace.h"

#include <numeric>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill::clearance {

namespace {

// Parts whose largest clearance exceeds the distance by no more are nothing.
constexpr double kNothing_mm = 5e-6;
// Loops on both sides of a closed neck keep this far from its vertex.
constexpr double kStepBack_mm = 1e-3;

class Tracer {
  public:
    Tracer(const Graph& graph, Side side, double distance, double tie)
        : graph_(graph), side_(side), distance_(distance), tie_(tie) {}

    std::vector<TracedLoop> run();

  private:
    const HalfEdge& edge(int h) const { return graph_.edges[static_cast<std::size_t>(h)]; }
    const Vertex& vertex(int n) const { return graph_.vertices[static_cast<std::size_t>(n)]; }
    const Site& site(int k) const { return graph_.set.sites[static_cast<std::size_t>(k)]; }
    bool above(int n) const { return above_[static_cast<std::size_t>(n)] != 0; }

    void findAbove();
    void dropSpecks();
    void findCrossings();
    void pairUp();
    Vec2 rough(int h) const;
    Vec2 joint(int h) const;
    Piece newPiece(int site) const;
    std::optional<TracedLoop> follow(std::size_t start);

    const Graph& graph_;
    Side side_;
    double distance_;
    double tie_;
    std::vector<char> above_;           // per vertex
    std::vector<int> crossed_;          // half-edges, ordered: cell by cell, counter-clockwise
    std::vector<std::size_t> leaving_;  // for each that goes down: where the offset leaves its cell again
    std::vector<char> done_;
};

void Tracer::findAbove() {
    for (const Vertex& v : graph_.vertices)
        above_.push_back(v.clearance > distance_ + (v.neck ? std::max(tie_, kShort_mm) : kShort_mm));
    dropSpecks();
}

/// What is nowhere farther from the boundary than rounding is nothing: else its opening, hardly more than the
/// disc itself, could be opened again or not as rounding decides.
void Tracer::dropSpecks() {
    // Parts that hang together are sets with a root; the root knows the largest clearance.
    std::vector<int> parent(graph_.vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int n) {
        while (parent[static_cast<std::size_t>(n)] != n) {
            int& up = parent[static_cast<std::size_t>(n)];
            up = parent[static_cast<std::size_t>(up)];
            n = up;
        }
        return n;
    };
    for (const HalfEdge& e : graph_.edges) {
        if (e.side != side_ || e.from > e.to || !above(e.from) || !above(e.to)) continue;
        const int a = root(e.from), b = root(e.to);
        const bool a_higher = vertex(a).clearance >= vertex(b).clearance;
        parent[static_cast<std::size_t>(a_higher ? b : a)] = a_higher ? a : b;
    }
    for (std::size_t n = 0; n < above_.size(); ++n)
        if (above_[n] && vertex(root(static_cast<int>(n))).clearance <= distance_ + kNothing_mm)
            above_[n] = 0;
}

void Tracer::findCrossings() {
    for (std::size_t h = 0; h < graph_.edges.size(); ++h) {
        const HalfEdge& e = graph_.edges[h];
        if (e.side == side_ && above(e.from) != above(e.to)) crossed_.push_back(static_cast<int>(h));
    }
}

/// Larger clearance is on the offset's left: it enters a cell where the way around it goes down, and leaves
/// where that way last went up.
void Tracer::pairUp() {
    leaving_.assign(crossed_.size(), 0);
    for (std::size_t first = 0; first < crossed_.size();) {
        std::size_t end = first;
        while (end < crossed_.size() && edge(crossed_[end]).cell == edge(crossed_[first]).cell)
            ++end;
        for (std::size_t k = first; k < end; ++k) {
            const std::size_t before = k == first ? end - 1 : k - 1;
            STEPMILL_CHECK(above(edge(crossed_[k]).to) != above(edge(crossed_[before]).to),
                           "clearance rises and falls in turn around a cell");
            leaving_[k] = before;
        }
        first = end;
    }
}

Vec2 Tracer::rough(int h) const {
    const Vertex &a = vertex(edge(h).from), &b = vertex(edge(h).to);
    if (!std::isfinite(a.clearance)) return b.point;
    if (!std::isfinite(b.clearance)) return a.point;
    const double t = (distance_ - a.clearance) / (b.clearance - a.clearance);
    return a.point + std::clamp(t, 0.0, 1.0) * (b.point - a.point);
}

/// Where the bisector of two true sites passes the level.
Vec2 Tracer::joint(int h) const {
    // The same point for both directions.
    const HalfEdge& e = edge(std::min(h, edge(h).twin));
    const bool rising = above(e.to);
    const Vertex &low = vertex(rising ? e.from : e.to), &high = vertex(rising ? e.to : e.from);
    const int other = edge(e.twin).site;
    const Vec2 near = rough(h);
    if (const auto ray = sharedNormal(graph_.set, e.site, other, side_, near))
        return ray->from + distance_ * ray->normal;
    const std::optional<Vec2> exact =
        equidistantPoint(site(e.site), site(other), side_, distance_, low.point, high.point);
    if (!exact) return near;
    // In a neck closed by the tie rule the offset curves do not meet. End them across the bisector, a step
    // away from its middle so that the loops on both sides of the neck keep apart.
    if (low.neck && low.clearance > distance_ + kShort_mm) {
        const Vec2 out = high.point - low.point;
        return low.point + std::min(kStepBack_mm / out.norm(), 0.5) * out;
    }
    return *exact;
}

Piece Tracer::newPiece(int index) const {
    const Site& s = site(index);
    Piece piece;
    piece.site = index;
    piece.curve = offsetCurve(s, side_, distance_);
    piece.forward = s.round() ? s.concaveOn(side_) : side_ == Side::Inside;
    return piece;
}

std::optional<TracedLoop> Tracer::follow(std::size_t start) {
    const auto indexOf = [&](int h) {
        return static_cast<std::size_t>(std::lower_bound(crossed_.begin(), crossed_.end(), h) -
                                        crossed_.begin());
    };
    std::vector<int> entered;
    for (std::size_t k = start; !done_[k]; k = indexOf(edge(crossed_[leaving_[k]]).twin)) {
        done_[k] = 1;
        entered.push_back(crossed_[k]);
    }
    const std::size_t n = entered.size();
    const auto changesSite = [&](std::size_t k) {
        return edge(entered[k]).site != edge(edge(entered[k]).twin).site;
    };
    TracedLoop loop;
    std::size_t first = 0;
    while (first < n && !changesSite(first))
        ++first;
    if (first == n) {
        // Never leaves its site: a whole circle.
        if (!site(edge(entered[0]).site).full) return std::nullopt;
        loop.full_circle = true;
        Piece piece = newPiece(edge(entered[0]).site);
        piece.from = piece.to = piece.curve.point + Vec2(piece.curve.radius, 0);
        piece.rough_sweep = 2 * kPi;
        loop.pieces.push_back(piece);
        return loop;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const int h = entered[(first + i) % n];
        if (changesSite((first + i) % n)) {
            const Vec2 at = joint(h);
            if (!loop.pieces.empty()) loop.pieces.back().to = at;
            loop.pieces.push_back(newPiece(edge(h).site));
            loop.pieces.back().from = at;
        }
        Piece& piece = loop.pieces.back();
        if (!site(piece.site).full) continue;
        const Vec2 a = rough(h) - piece.curve.point;
        const Vec2 b = rough(entered[(first + i + 1) % n]) - piece.curve.point;
        piece.rough_sweep += (piece.forward ? 1 : -1) * std::atan2(cross(a, b), a.dot(b));
    }
    loop.pieces.back().to = loop.pieces.front().from;
    return loop;
}

std::vector<TracedLoop> Tracer::run() {
    findAbove();
    findCrossings();
    pairUp();
    done_.assign(crossed_.size(), 0);
    std::vector<TracedLoop> loops;
    for (std::size_t k = 0; k < crossed_.size(); ++k) {
        if (done_[k] || above(edge(crossed_[k]).to)) continue;
        std::optional<TracedLoop> loop = follow(k);
        if (!loop) continue;
        tidy(*loop, graph_, side_, distance_);
        if (loop->pieces.size() > 1 || loop->full_circle) loops.push_back(std::move(*loop));
    }
    return loops;
}

}  // namespace

std::vector<TracedLoop> trace(const Graph& graph, Side side, double distance_mm, double tie_mm) {
    return Tracer(graph, side, distance_mm, tie_mm).run();
}

}  // namespace stepmill::clearance
