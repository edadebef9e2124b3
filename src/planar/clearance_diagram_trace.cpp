#include "planar/clearance_diagram_trace.h"

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill::clearance {

namespace {

// Shorter pieces are rounding.
constexpr double kShort_mm = 3e-6;
// Loops on both sides of a closed neck keep this far from its node.
constexpr double kStepBack_mm = 1e-3;
// A joint farther off its curve than this does not lie on it.
constexpr double kOffCurve_mm = 1.5e-6;
// Pieces run backwards where the chords put two bisectors in the wrong order; never by more than this many
// sagittas.
constexpr double kBackwardChords = 100;

const Site& siteOf(const Graph& graph, int index) {
    return graph.set.sites[static_cast<std::size_t>(index)];
}

double ccwSweep(const Vec2& from, const Vec2& to) {
    const double a = std::atan2(cross(from, to), from.dot(to));
    return a < 0 ? a + 2 * kPi : a;
}

double sweepOf(const Piece& p) {
    const Vec2 a = p.from - p.curve.point, b = p.to - p.curve.point;
    return p.forward ? ccwSweep(a, b) : ccwSweep(b, a);
}

Vec2 travelDirection(const Piece& piece, const Vec2& at) {
    const Vec2 ahead = piece.curve.round ? leftNormal(at - piece.curve.point).normalized() : piece.curve.dir;
    return piece.forward ? ahead : Vec2(-ahead);
}

/// Points common to two offset curves; of curves that just miss each other, the point nearest to both.
std::vector<Vec2> commonPoints(const OffsetCurve& a, const OffsetCurve& b) {
    if (!a.round && !b.round) {
        const double det = cross(a.dir, b.dir);
        if (std::abs(det) < kSmoothKinkRad) return {};
        return {a.point + a.dir * (cross(b.point - a.point, b.dir) / det)};
    }
    Vec2 foot, along;
    double h2 = 0;
    if (a.round && b.round) {
        const Vec2 between = b.point - a.point;
        const double d = between.norm();
        if (d < kShort_mm) return {};
        const double x = (d * d + (a.radius - b.radius) * (a.radius + b.radius)) / (2 * d);
        foot = a.point + x / d * between;
        along = leftNormal(between) / d;
        h2 = (a.radius - x) * (a.radius + x);
    } else {
        const OffsetCurve &line = a.round ? b : a, &circle = a.round ? a : b;
        foot = project(line, circle.point);
        along = line.dir;
        h2 = circle.radius * circle.radius - (foot - circle.point).squaredNorm();
    }
    const Vec2 step = std::sqrt(std::max(0.0, h2)) * along;
    return {foot - step, foot + step};
}

/// Where the offset goes over from one piece to the next: points of large clearance form convex corners
/// there, so of two common points it is the one where the way turns left.
std::optional<Vec2> convexCorner(const Piece& before, const Piece& after, const Vec2& near) {
    std::optional<Vec2> best;
    double best_turn = 0;
    for (const Vec2& p : commonPoints(before.curve, after.curve)) {
        const double turn = cross(travelDirection(before, p), travelDirection(after, p));
        const bool better = std::abs(turn - best_turn) < 1e-9
                                ? best && (p - near).norm() < (*best - near).norm()
                                : turn > best_turn;
        if (best && !better) continue;
        best = p;
        best_turn = turn;
    }
    return best;
}

class Tracer {
  public:
    Tracer(const Graph& graph, Side side, double distance, double tie, double chord)
        : graph_(graph),
          side_(side),
          distance_(distance),
          level_(distance + kShort_mm),
          tie_(tie),
          chord_(chord) {}

    std::vector<TracedLoop> run();

  private:
    const HalfEdge& edge(int h) const { return graph_.edges[static_cast<std::size_t>(h)]; }
    const Node& node(int n) const { return graph_.nodes[static_cast<std::size_t>(n)]; }
    bool above(int n) const { return node(n).clearance > (node(n).neck ? distance_ + tie_ : level_); }
    bool goesDown(int h) const { return above(edge(h).from) && !above(edge(h).to); }
    bool goesUp(int h) const { return !above(edge(h).from) && above(edge(h).to); }

    Vec2 crossing(int h) const;
    Vec2 interpolated(const Node& low, const Node& high) const;
    Piece newPiece(int site) const;
    TracedLoop traceFrom(int start, std::vector<char>& visited) const;
    void addFullCircles(std::vector<TracedLoop>& loops) const;
    bool backwardOrShort(const Piece& piece) const;
    void dropShortPieces(TracedLoop& loop) const;
    void mergePieces(TracedLoop& loop) const;

    const Graph& graph_;
    Side side_;
    double distance_;
    double level_;
    double tie_;
    double chord_;
};

Vec2 Tracer::interpolated(const Node& low, const Node& high) const {
    if (!std::isfinite(high.clearance)) return low.point;
    const double t = (distance_ - low.clearance) / (high.clearance - low.clearance);
    return low.point + std::clamp(t, 0.0, 1.0) * (high.point - low.point);
}

/// Where the monotone bisector passes the level, computed from the true sites.
Vec2 Tracer::crossing(int half) const {
    const HalfEdge& e = edge(std::min(half, edge(half).twin));
    const bool rising = above(e.to);
    const Node& low = node(rising ? e.from : e.to);
    const Node& high = node(rising ? e.to : e.from);
    const int other = edge(e.twin).site;
    if (const auto ray = sharedNormal(graph_.set, e.site, other, side_, (low.point + high.point) / 2))
        return ray->from + distance_ * ray->normal;
    const Site &p = siteOf(graph_, e.site), &q = siteOf(graph_, other);
    const std::optional<Vec2> exact = equidistantPoint(p, q, side_, distance_, low.point, high.point);
    if (!exact) return interpolated(low, high);
    const double from_low = (*exact - low.point).norm();
    // In a neck closed by the tie rule the offset curves do not meet. End them across the bisector, a step
    // away from the node so that the loops on both sides of the neck keep apart.
    if (low.clearance > distance_ + kGridMm / 10 && (low.neck || from_low > tie_)) {
        const Vec2 out = high.point - low.point;
        return low.point + std::min(kStepBack_mm / out.norm(), 0.5) * out;
    }
    const double near = kBackwardChords * chord_;
    const bool on_edge =
        footBetween(p, low.point, high.point, *exact) || footBetween(q, low.point, high.point, *exact);
    if (!on_edge && from_low > near && (*exact - high.point).norm() > near) return interpolated(low, high);
    return *exact;
}

Piece Tracer::newPiece(int site) const {
    const Site& s = siteOf(graph_, site);
    Piece piece;
    piece.site = site;
    piece.curve = offsetCurve(s, side_, distance_);
    piece.forward = s.round() ? s.concaveOn(side_) : side_ == Side::Inside;
    return piece;
}

TracedLoop Tracer::traceFrom(int start, std::vector<char>& visited) const {
    TracedLoop loop;
    int h = start;
    Vec2 at = crossing(start);
    do {
        visited[static_cast<std::size_t>(h)] = 1;
        Piece piece = newPiece(edge(h).site);
        piece.from = at;
        const Vec2 out = piece.from - piece.curve.point;
        int up = h;
        std::size_t steps = 0;
        do {
            up = edge(up).prev;
            const Vec2 radial = node(edge(up).to).point - piece.curve.point;
            if (piece.curve.round && radial.dot(out) < 0.5 * radial.norm() * out.norm())
                piece.goes_round = true;
            STEPMILL_CHECK(++steps <= graph_.edges.size(), "an offset leaves every cell it enters");
        } while (!goesUp(up));
        h = edge(up).twin;
        at = h == start ? loop.pieces.empty() ? piece.from : loop.pieces.front().from : crossing(h);
        piece.to = at;
        loop.pieces.push_back(piece);
        STEPMILL_CHECK(loop.pieces.size() <= graph_.edges.size(), "offset loops close");
    } while (h != start);
    return loop;
}

/// Circles whose cell the offset never leaves.
void Tracer::addFullCircles(std::vector<TracedLoop>& loops) const {
    const std::vector<Site>& sites = graph_.set.sites;
    std::vector<char> bounded(sites.size(), 0), blocked(sites.size(), 0);
    for (const HalfEdge& e : graph_.edges) {
        if (e.side != side_) continue;
        bounded[static_cast<std::size_t>(e.site)] = 1;
        if (!above(e.from) || !above(e.to)) blocked[static_cast<std::size_t>(e.site)] = 1;
    }
    for (std::size_t k = 0; k < sites.size(); ++k) {
        if (!sites[k].full || blocked[k]) continue;
        if (sites[k].concaveOn(side_) && sites[k].radius <= level_) continue;
        if (!sites[k].concaveOn(side_) && !bounded[k]) continue;
        TracedLoop loop;
        loop.full_circle = true;
        Piece piece = newPiece(static_cast<int>(k));
        piece.goes_round = true;
        piece.from = piece.to = piece.curve.point + Vec2(piece.curve.radius, 0);
        loop.pieces.push_back(piece);
        loops.push_back(loop);
    }
}

bool Tracer::backwardOrShort(const Piece& piece) const {
    const Vec2 step = piece.to - piece.from;
    if (!piece.curve.round) return step.dot(piece.curve.dir) * (piece.forward ? 1 : -1) <= kShort_mm;
    if (piece.curve.radius <= kShort_mm) return true;
    if (piece.goes_round) return false;
    if (step.norm() <= kShort_mm) return true;
    const double missing = 2 * kPi - sweepOf(piece);
    return missing < kPi && missing * piece.curve.radius < kBackwardChords * chord_;
}

void Tracer::dropShortPieces(TracedLoop& loop) const {
    std::vector<Piece>& pieces = loop.pieces;
    for (std::size_t k = 0; k < pieces.size() && pieces.size() > 1;) {
        if (!backwardOrShort(pieces[k])) {
            ++k;
            continue;
        }
        const std::size_t n = pieces.size();
        Piece &before = pieces[(k + n - 1) % n], &after = pieces[(k + 1) % n];
        const Vec2 mid = (pieces[k].from + pieces[k].to) / 2;
        const double reach = 4 * (pieces[k].to - pieces[k].from).norm() + kShort_mm;
        Vec2 at = mid;
        if (const auto x = convexCorner(before, after, mid); x && (*x - mid).norm() < reach) at = *x;
        before.to = at;
        after.from = at;
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k));
        // The piece before may have become short in its turn.
        if (k > 0) --k;
    }
}

void Tracer::mergePieces(TracedLoop& loop) const {
    std::vector<Piece>& pieces = loop.pieces;
    const auto sameCurve = [](const Piece& a, const Piece& b) {
        if (a.curve.round != b.curve.round) return false;
        if (!a.curve.round) return a.site == b.site;
        return a.curve.point == b.curve.point && a.curve.radius == b.curve.radius && a.forward == b.forward;
    };
    for (std::size_t k = 0; k < pieces.size() && pieces.size() > 1;) {
        const std::size_t next = (k + 1) % pieces.size();
        if (!sameCurve(pieces[k], pieces[next])) {
            ++k;
            continue;
        }
        const bool round = pieces[k].goes_round || pieces[next].goes_round;
        pieces[k].to = pieces[next].to;
        pieces[k].goes_round = round;
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(next));
        if (next < k) --k;
    }
    if (pieces.size() == 1 && pieces[0].curve.round && pieces[0].goes_round) loop.full_circle = true;
}

std::vector<TracedLoop> Tracer::run() {
    std::vector<TracedLoop> loops;
    std::vector<char> visited(graph_.edges.size(), 0);
    for (std::size_t h = 0; h < graph_.edges.size(); ++h) {
        if (visited[h] || graph_.edges[h].side != side_ || !goesDown(static_cast<int>(h))) continue;
        TracedLoop loop = traceFrom(static_cast<int>(h), visited);
        dropShortPieces(loop);
        mergePieces(loop);
        const bool circle = loop.full_circle && loop.pieces[0].curve.radius > kShort_mm;
        if (loop.pieces.size() > 1 || circle) loops.push_back(std::move(loop));
    }
    addFullCircles(loops);
    return loops;
}

/// A joint may lie off a curve (see crossing()); the piece then starts at the nearest point of its curve.
Vec2 endOn(const OffsetCurve& curve, const Vec2& joint) {
    const Vec2 on = project(curve, joint);
    return snapToGrid((on - joint).norm() > kOffCurve_mm ? on : joint);
}

}  // namespace

Vec2 middle(const Piece& piece) {
    if (!piece.curve.round) return (piece.from + piece.to) / 2;
    const double sweep = piece.from == piece.to ? kPi : sweepOf(piece);
    const double turn = (piece.forward ? 0.5 : -0.5) * sweep;
    return piece.curve.point + Eigen::Rotation2Dd(turn) * (piece.from - piece.curve.point);
}

bool keepsDistance(const Graph& graph, const std::vector<TracedLoop>& loops, double distance_mm,
                   double slack_mm) {
    const double least = distance_mm - slack_mm;
    for (const TracedLoop& loop : loops) {
        const std::size_t n = loop.pieces.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Site& before = siteOf(graph, loop.pieces[(k + n - 1) % n].site);
            const Site& after = siteOf(graph, loop.pieces[(k + 1) % n].site);
            const Vec2 mid = middle(loop.pieces[k]);
            const Vec2& joint = loop.pieces[k].to;
            if (distanceToSite(before, mid) < least || distanceToSite(after, mid) < least ||
                distanceToSite(before, joint) < least || distanceToSite(after, joint) < least)
                return false;
        }
    }
    return true;
}

std::vector<TracedLoop> trace(const Graph& graph, Side side, double distance_mm, double tie_mm,
                              double chord_mm) {
    return Tracer(graph, side, distance_mm, tie_mm, chord_mm).run();
}

std::optional<Loop> toLoop(const TracedLoop& traced) {
    Loop loop;
    const auto arcOf = [](const Piece& p) {
        return Arc{p.curve.point, snapToGrid(p.curve.radius), p.forward};
    };
    if (traced.full_circle) {
        const Arc arc = arcOf(traced.pieces[0]);
        const Vec2 r(arc.radius_mm, 0);
        loop.start = arc.centre + r;
        loop.segments = {{snapToGrid(Vec2(arc.centre - r)), arc}, {loop.start, arc}};
        loop.start = loop.segments[1].to = snapToGrid(loop.start);
        return loop;
    }
    loop.start = endOn(traced.pieces[0].curve, traced.pieces[0].from);
    Vec2 at = loop.start;
    for (const Piece& p : traced.pieces) {
        const Vec2 from = endOn(p.curve, p.from), to = endOn(p.curve, p.to);
        if (from != at) loop.segments.push_back({from, std::nullopt});
        if (from != to || p.goes_round)
            loop.segments.push_back({to, p.curve.round ? std::optional<Arc>(arcOf(p)) : std::nullopt});
        at = to;
    }
    if (at != loop.start) loop.segments.push_back({loop.start, std::nullopt});
    constexpr double kNothing_mm2 = 1e-9;
    if (loop.segments.size() < 2 || std::abs(signedArea(loop)) < kNothing_mm2) return std::nullopt;
    return loop;
}

}  // namespace stepmill::clearance
