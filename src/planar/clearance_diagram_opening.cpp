#include "planar/clearance_diagram_opening.h"

#include "stepmill/planar/boolean.h"

namespace stepmill::clearance {

namespace {

// A contact this close to the end of its edge is that end.
constexpr double kWeld_mm = 3e-6;

/// The disc's arc in a corner it cannot reach into.
struct Cap {
    Vec2 centre;
    Vec2 from;
    Vec2 to;
    std::size_t piece_before;  ///< pieces of the traced loops, numbered through, that the arc joins
    std::size_t piece_after;
};

Vec2 contact(const Site& site, const Vec2& centre) {
    const Vec2 foot = footOn(site, centre);
    if ((foot - site.start).norm() < kWeld_mm) return site.start;
    if ((foot - site.end).norm() < kWeld_mm) return site.end;
    return snapToGrid(foot);
}

bool insideCap(const Cap& cap, const Vec2& direction, double margin) {
    const Vec2 a = (cap.from - cap.centre).normalized(), b = (cap.to - cap.centre).normalized();
    const Vec2 u = direction.normalized();
    const bool wide = cross(a, b) < 0;
    if (margin < 0 && ((u - a).norm() < -margin || (u - b).norm() < -margin)) return true;
    const bool after = cross(a, u) > margin, before = cross(u, b) > margin;
    return wide ? after || before : after && before;
}

/// Do the two arcs of equal radius cross, or lie on the same circle? Arcs on both sides of one reflex corner
/// meet there and nowhere else.
bool capsCross(const Cap& a, const Cap& b, double radius) {
    const Vec2 d = b.centre - a.centre;
    const double distance = d.norm();
    if (distance > 2 * radius + kWeld_mm) return false;
    if (distance < kWeld_mm) return true;
    const bool neighbours = a.piece_after == b.piece_before || b.piece_after == a.piece_before;
    const double h = std::sqrt(std::max(0.0, radius * radius - distance * distance / 4));
    const double margin = (neighbours ? kWeld_mm : -kWeld_mm) / radius;
    for (double sign : {1.0, -1.0}) {
        const Vec2 x = d / 2 + sign * h / distance * leftNormal(d);
        if (insideCap(a, x, margin) && insideCap(b, x - d, margin)) return true;
    }
    return false;
}

class Contacts {
  public:
    Contacts(const SiteSet& set, double radius) : set_(set), radius_(snapToGrid(radius)) {}

    void add(const TracedLoop& traced);
    bool crossing() const;
    Region take() { return std::move(region_); }

  private:
    const Site& site(const Piece& p) const { return set_.sites[static_cast<std::size_t>(p.site)]; }
    void addCircle(const Site& circle);
    void addWall(Loop& loop, const Piece& piece, const Vec2& to) const;
    void addCap(Loop& loop, const Vec2& joint, const Vec2& to, std::size_t before, std::size_t after);

    const SiteSet& set_;
    double radius_;
    Region region_;
    std::vector<Cap> caps_;
    std::size_t pieces_ = 0;  // of the loops added so far
};

void Contacts::addCircle(const Site& circle) {
    const Arc arc{circle.centre, circle.radius, circle.ccw};
    const Vec2 r(circle.radius, 0);
    const Vec2 right = snapToGrid(Vec2(circle.centre + r)), left = snapToGrid(Vec2(circle.centre - r));
    region_.loops.push_back({right, {{left, arc}, {right, arc}}});
}

void Contacts::addWall(Loop& loop, const Piece& piece, const Vec2& to) const {
    const Site& s = site(piece);
    if (s.kind == SiteKind::Corner || to == loop.end()) return;
    std::optional<Arc> arc;
    if (s.kind == SiteKind::Arc) arc = Arc{s.centre, s.radius, s.ccw};
    loop.segments.push_back({to, arc});
}

void Contacts::addCap(Loop& loop, const Vec2& joint, const Vec2& to, std::size_t before, std::size_t after) {
    if (to == loop.end()) return;
    const Vec2 centre = snapToGrid(joint);
    // A disc turns by less than half a circle at a joint; more is a tiny turn that rounding reversed.
    const Vec2 out = loop.end() - centre, in = to - centre;
    const bool reversed_turn = cross(out, in) < 0 && out.dot(in) > 0;
    if (reversed_turn || (to - loop.end()).norm() < kWeld_mm) {
        loop.segments.push_back({to, std::nullopt});
        return;
    }
    caps_.push_back({centre, loop.end(), to, before, after});
    loop.segments.push_back({to, Arc{centre, radius_, true}});
}

void Contacts::add(const TracedLoop& traced) {
    if (traced.full_circle && site(traced.pieces[0]).kind == SiteKind::Arc) {
        addCircle(site(traced.pieces[0]));
        return;
    }
    Loop loop;
    loop.start = contact(site(traced.pieces[0]), traced.pieces[0].from);
    for (std::size_t k = 0; k < traced.pieces.size(); ++k) {
        const Piece& piece = traced.pieces[k];
        const Piece& next = traced.pieces[(k + 1) % traced.pieces.size()];
        addWall(loop, piece, contact(site(piece), piece.to));
        addCap(loop, piece.to, contact(site(next), next.from), pieces_ + k,
               pieces_ + (k + 1) % traced.pieces.size());
    }
    pieces_ += traced.pieces.size();
    constexpr double kNothing_mm2 = 1e-9;
    if (loop.segments.size() > 1 && std::abs(signedArea(loop)) > kNothing_mm2) region_.loops.push_back(loop);
}

bool Contacts::crossing() const {
    for (std::size_t i = 0; i < caps_.size(); ++i)
        for (std::size_t j = i + 1; j < caps_.size(); ++j)
            if (capsCross(caps_[i], caps_[j], radius_)) return true;
    return false;
}

}  // namespace

Region sweptByContacts(const SiteSet& set, const std::vector<TracedLoop>& loops, double radius_mm,
                       const Tolerances& tol) {
    Contacts contacts(set, radius_mm);
    for (const TracedLoop& loop : loops)
        contacts.add(loop);
    const bool overlapping = contacts.crossing();
    Region swept = contacts.take();
    if (!overlapping) return swept;
    const Box2 box = boundingBox(swept).grown(radius_mm);
    return intersect(swept, makeRectangle(box.min, box.max), tol);
}

}  // namespace stepmill::clearance
