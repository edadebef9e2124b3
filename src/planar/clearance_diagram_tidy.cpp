// From crossings of bisectors to loops of true lines and arcs.

#include "planar/clearance_diagram_trace.h"
#include "stepmill/core/units.h"

namespace stepmill::clearance {

namespace {

// A joint farther off its curve than this does not lie on it.
constexpr double kOffCurve_mm = 1.5e-6;

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
        constexpr double kSameTurn = 1e-9;
        const bool better = std::abs(turn - best_turn) < kSameTurn
                                ? best && (p - near).norm() < (*best - near).norm()
                                : turn > best_turn;
        if (best && !better) continue;
        best = p;
        best_turn = turn;
    }
    return best;
}

/// Direction from an arc's or corner's centre to the middle of its offsets.
Vec2 middleDirection(const Site& site, const SiteSet& set, Side side) {
    if (site.kind == SiteKind::Arc) {
        const Vec2 a = (site.start - site.centre).normalized(), b = (site.end - site.centre).normalized();
        const Vec2 chord = site.ccw ? Vec2(b - a) : Vec2(a - b);
        return -leftNormal(chord);
    }
    const Joint& joint = set.joints[static_cast<std::size_t>(site.start_joint)];
    const Vec2 normals = leftNormal(joint.tangent_in) + leftNormal(joint.tangent_out);
    // One of the two sums vanishes for a straight corner, the other for one that turns right back.
    return (side == Side::Inside ? normals : Vec2(-normals)) + joint.tangent_in - joint.tangent_out;
}

class Tidier {
  public:
    Tidier(TracedLoop& loop, const Graph& graph, Side side, double distance)
        : pieces_(loop.pieces), loop_(loop), set_(graph.set), side_(side), distance_(distance) {}
    void run();

  private:
    const Site& site(const Piece& p) const { return set_.sites[static_cast<std::size_t>(p.site)]; }
    double sweepOf(const Piece& piece) const;
    double signedLength(const Piece& piece) const;
    Vec2 meeting(const Piece& before, const Piece& after, const Vec2& near) const;
    int neighbour(int site, bool ahead) const;
    bool past(const Piece& piece, int neighbour, bool ahead) const;
    bool insertMissing(std::size_t k);
    bool joinSameCurve();
    void drop(std::size_t k);
    void dropBackward();

    std::vector<Piece>& pieces_;
    TracedLoop& loop_;
    const SiteSet& set_;
    Side side_;
    double distance_;
};

/// Angle swept in the piece's direction: an arc's own extent, or the rough sweep of a full circle, tells
/// which way round it goes.
double Tidier::sweepOf(const Piece& piece) const {
    const Vec2 a = piece.from - piece.curve.point, b = piece.to - piece.curve.point;
    const Site& s = site(piece);
    const double sign = piece.forward ? 1 : -1;
    if (s.full) {
        const double turn = sign * std::atan2(cross(a, b), a.dot(b));
        return turn + 2 * kPi * std::round((piece.rough_sweep - turn) / (2 * kPi));
    }
    const Vec2 m = middleDirection(s, set_, side_);
    return sign * (std::atan2(cross(m, b), m.dot(b)) - std::atan2(cross(m, a), m.dot(a)));
}

double Tidier::signedLength(const Piece& piece) const {
    if (!piece.curve.round) return (piece.to - piece.from).dot(piece.curve.dir) * (piece.forward ? 1 : -1);
    if (piece.curve.radius <= kShort_mm) return 0;
    return sweepOf(piece) * piece.curve.radius;
}

Vec2 Tidier::meeting(const Piece& before, const Piece& after, const Vec2& near) const {
    if (const auto ray = sharedNormal(set_, before.site, after.site, side_, near))
        return ray->from + distance_ * ray->normal;
    if (const auto corner = convexCorner(before, after, near)) return *corner;
    return near;
}

void Tidier::drop(std::size_t k) {
    const std::size_t n = pieces_.size();
    Piece &before = pieces_[(k + n - 1) % n], &after = pieces_[(k + 1) % n];
    const Vec2 at = meeting(before, after, (pieces_[k].from + pieces_[k].to) / 2);
    before.to = at;
    after.from = at;
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(k));
}

/// Makes the first two neighbours of one site one piece.
bool Tidier::joinSameCurve() {
    const std::size_t n = pieces_.size();
    for (std::size_t k = 0; n > 1 && k < n; ++k) {
        Piece &a = pieces_[k], &b = pieces_[(k + 1) % n];
        if (a.site != b.site) continue;
        a.to = b.to;
        a.rough_sweep += b.rough_sweep;
        pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>((k + 1) % n));
        return true;
    }
    return false;
}

/// The site that follows (or precedes) on the way round, -1 where offsets change over on a bisector.
int Tidier::neighbour(int index, bool ahead) const {
    const Site& s = set_.sites[static_cast<std::size_t>(index)];
    if (s.full) return -1;
    const bool along = ahead == (side_ == Side::Inside);
    const Joint& joint = set_.joints[static_cast<std::size_t>(along ? s.end_joint : s.start_joint)];
    const int beyond = along ? joint.out : joint.in;
    if (s.kind == SiteKind::Corner || joint.corner < 0) return beyond;
    const bool reflex = cross(joint.tangent_in, joint.tangent_out) * (side_ == Side::Inside ? 1 : -1) < 0;
    return reflex ? joint.corner : -1;
}

/// Does the piece run past the end of its site that it shares with that neighbour?
bool Tidier::past(const Piece& piece, int other, bool ahead) const {
    const Vec2& end = ahead ? piece.to : piece.from;
    const auto ray = sharedNormal(set_, piece.site, other, side_, end);
    if (!ray) return false;
    const Vec2 on_curve = ray->from + distance_ * ray->normal;
    constexpr double kPast_mm = 2 * kShort_mm;
    const double sign = piece.forward == ahead ? 1 : -1;
    if (!piece.curve.round) return sign * piece.curve.dir.dot(end - on_curve) > kPast_mm;
    const Vec2 m = middleDirection(site(piece), set_, side_);
    const auto angle = [&](const Vec2& p) {
        const Vec2 r = p - piece.curve.point;
        return std::atan2(cross(m, r), m.dot(r));
    };
    // An arc shrunk to its centre counts by how far its ends still are apart.
    if (piece.curve.radius < -kShort_mm) return false;
    const Vec2& bound = site(piece).kind == SiteKind::Corner ? on_curve : ray->from;
    const double overrun = sign * angle(end) - std::abs(angle(bound));
    return overrun * (end - piece.curve.point).norm() > kPast_mm;
}

/// Chords meet at an angle where their arcs go on smoothly. That tilts the cells beside, so that a narrow one
/// may end too early: then the pieces before or after run past the end of their sites.
bool Tidier::insertMissing(std::size_t k) {
    const std::size_t next = (k + 1) % pieces_.size();
    for (const bool ahead : {true, false}) {
        const Piece& runner = pieces_[ahead ? k : next];
        const int missing = neighbour(runner.site, ahead);
        if (missing < 0 || missing == pieces_[ahead ? next : k].site || !past(runner, missing, ahead))
            continue;
        Piece piece = runner;
        piece.site = missing;
        const Site& s = set_.sites[static_cast<std::size_t>(missing)];
        piece.curve = offsetCurve(s, side_, distance_);
        piece.forward = s.round() ? s.concaveOn(side_) : side_ == Side::Inside;
        if (piece.curve.round && piece.curve.radius <= kShort_mm) continue;
        const Vec2 near = pieces_[k].to;
        pieces_[k].to = piece.from = meeting(pieces_[k], piece, near);
        pieces_[next].from = piece.to = meeting(piece, pieces_[next], near);
        pieces_.insert(pieces_.begin() + static_cast<std::ptrdiff_t>(k + 1), piece);
        return true;
    }
    return false;
}

void Tidier::dropBackward() {
    for (bool changed = true; changed && pieces_.size() > 1;) {
        changed = false;
        std::size_t worst = 0;
        double least = kShort_mm;
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            const double length = signedLength(pieces_[k]);
            if (length > least) continue;
            least = length;
            worst = k;
            changed = true;
        }
        if (changed) drop(worst);
        changed = joinSameCurve() || changed;
    }
}

void Tidier::run() {
    if (loop_.full_circle) {
        if (pieces_[0].curve.radius <= kShort_mm) loop_ = {};
        return;
    }
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) {
        const std::size_t limit = 2 * pieces_.size() + 8;
        bool inserted = false;
        for (std::size_t k = 0; pieces_.size() > 1 && k < pieces_.size() && pieces_.size() < limit;)
            if (insertMissing(k))
                inserted = true;
            else
                ++k;
        if (round > 0 && !inserted) break;
        dropBackward();
    }
    if (pieces_.size() != 1) return;
    const Piece& last = pieces_[0];
    if (site(last).full && last.curve.radius > kShort_mm && last.rough_sweep > kPi) loop_.full_circle = true;
}

/// A joint may lie off a curve (a neck closed by a tie); the piece then starts at the nearest point of its
/// curve.
Vec2 endOn(const OffsetCurve& curve, const Vec2& joint) {
    const Vec2 on = project(curve, joint);
    return snapToGrid((on - joint).norm() > kOffCurve_mm ? on : joint);
}

Arc arcOf(const Piece& piece) {
    return {piece.curve.point, snapToGrid(piece.curve.radius), piece.forward};
}

Loop circleLoop(const Piece& piece) {
    const Arc arc = arcOf(piece);
    const Vec2 r(arc.radius_mm, 0);
    const Vec2 right = snapToGrid(Vec2(arc.centre + r)), left = snapToGrid(Vec2(arc.centre - r));
    return {right, {{left, arc}, {right, arc}}};
}

}  // namespace

void tidy(TracedLoop& loop, const Graph& graph, Side side, double distance_mm) {
    Tidier(loop, graph, side, distance_mm).run();
}

std::optional<Loop> toLoop(const TracedLoop& traced) {
    if (traced.full_circle) return circleLoop(traced.pieces[0]);
    Loop loop;
    loop.start = endOn(traced.pieces[0].curve, traced.pieces[0].from);
    Vec2 at = loop.start;
    for (const Piece& p : traced.pieces) {
        const Vec2 from = endOn(p.curve, p.from), to = endOn(p.curve, p.to);
        if (from != at) loop.segments.push_back({from, std::nullopt});
        const bool whole = p.curve.round && p.rough_sweep > kPi;
        if (from != to || whole)
            loop.segments.push_back({to, p.curve.round ? std::optional<Arc>(arcOf(p)) : std::nullopt});
        at = to;
    }
    if (at != loop.start) loop.segments.push_back({loop.start, std::nullopt});
    constexpr double kNothing_mm2 = 1e-9;
    if (loop.segments.size() < 2 || std::abs(signedArea(loop)) < kNothing_mm2) return std::nullopt;
    return loop;
}

}  // namespace stepmill::clearance
