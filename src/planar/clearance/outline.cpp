// Levels of the clearance drawn as loops of lines and arcs.

#include "planar/clearance/outline.h"

#include <numbers>

#include "planar/clearance/boundary_drawer.h"
#include "planar/segment.h"

namespace stepmill::clearance {

namespace {

/// The contact at a place, as a point of the wall.
Vec2 footOf(const Profile& profile, const Place& place) {
    return snapToGrid(contactAt(profile.sites()[place.site], place.u).foot);
}

/// The disc's arc in a corner it cannot reach into.
struct Cap {
    Vec2 centre;
    Vec2 from;
    Vec2 to;
    int run_before = kNone;
    int run_after = kNone;
};

/// Is the direction within the cap's arc, farther than `margin` from its ends? A negative margin takes in
/// what lies just beyond them.
bool insideCap(const Cap& cap, const Vec2& direction, double margin) {
    const Vec2 a = (cap.from - cap.centre).normalized(), b = (cap.to - cap.centre).normalized();
    const Vec2 u = direction.normalized();
    if (margin < 0 && ((u - a).norm() < -margin || (u - b).norm() < -margin)) return true;
    const bool after = cross(a, u) > margin, before = cross(u, b) > margin;
    return cross(a, b) < 0 ? after || before : after && before;
}

/// Do two arcs of equal radius cross, or lie on the same circle? Those on both sides of one run may meet at a
/// corner the run consists of.
bool capsCross(const Cap& a, const Cap& b, double radius) {
    constexpr double kMeetMm = 3 * kGridMm;
    const Vec2 d = b.centre - a.centre;
    const double distance = d.norm();
    if (distance > 2 * radius + kMeetMm) return false;
    if (distance < kMeetMm) return true;
    // Discs on both sides of the gap between two corners.
    if ((a.from - b.to).norm() < kMeetMm && (a.to - b.from).norm() < kMeetMm) return true;
    const double h = std::sqrt(std::max(0.0, radius * radius - distance * distance / 4));
    // Rounded centres turn the line between close discs, and with it the points where they cross.
    const double turned = kMeetMm / radius + kMeetMm / distance;
    const auto isCorner = [&](const Vec2& p, const Vec2& one, const Vec2& other) {
        return (one - other).norm() < kMeetMm && (p - one).norm() < 2 * radius * turned;
    };
    const auto meetsAtRun = [&](const Vec2& p) {
        return (a.run_after == b.run_before && isCorner(p, a.to, b.from)) ||
               (b.run_after == a.run_before && isCorner(p, b.to, a.from));
    };
    for (const double sign : {1.0, -1.0}) {
        const Vec2 x = d / 2 + sign * h / distance * leftOf(d);
        if (insideCap(a, x, -turned) && insideCap(b, x - d, -turned) && !meetsAtRun(a.centre + x))
            return true;
    }
    return false;
}

bool anyCapsCross(std::vector<Cap> caps, double radius) {
    std::sort(caps.begin(), caps.end(),
              [](const Cap& a, const Cap& b) { return a.centre.x() < b.centre.x(); });
    for (std::size_t i = 0; i < caps.size(); ++i)
        for (std::size_t j = i + 1; j < caps.size(); ++j) {
            if (caps[j].centre.x() - caps[i].centre.x() > 2 * radius + kTouchMm) break;
            if (capsCross(caps[i], caps[j], radius)) return true;
        }
    return false;
}

/// Do both walls at the end of a run see the same disc, and does no other wall reach into it?
bool isOneDisc(const Profile& profile, const Level& level, const Run& run) {
    constexpr double kOneDiscMm = 2e-4;
    const Vec2& here = run.end.centre;
    const Vec2& there = level.runs[run.next].begin.centre;
    if ((here - there).norm() > kOneDiscMm) return false;
    const Vec2 centre = (here + there) / 2;
    return profile.tree().distance(centre, level.distance) > level.distance - kNearerMm;
}

/// Corners that a disc does not reach into are no longer than this along both walls, in radii: those of 12
/// degrees and more.
constexpr double kCornerRadii = 20;
/// Where the walls of a strip are nearly parallel, rounding moves the place at which a disc just fits by
/// several of its radii; this many at most.
constexpr double kStripEndRadii = 10;

/// Length of the boundary from one place on to the other [mm]; no more than needed to tell that it is over
/// `limit`.
double lengthAlong(const std::vector<Site>& sites, const Place& from, const Place& to, double limit) {
    if (sites[from.site].loop != sites[to.site].loop) return kNever;
    const auto stretch = [&](int site, double u, double to_u) {
        return (to_u - u) * (sites[site].round() ? sites[site].radius : 1);
    };
    double sum = 0, u = from.u;
    int site = from.site;
    while (site != to.site || to.u < u) {
        sum += stretch(site, u, sites[site].extent);
        if (sum > limit) return sum;
        site = sites[site].next;
        u = 0;
    }
    return sum + stretch(site, u, to.u);
}

/// Visits the runs ring by ring: calls back with the runs of one ring, in order.
template <typename Callback>
void forEachRing(const Level& level, const Callback& callback) {
    std::vector<bool> seen(level.runs.size(), false);
    for (std::size_t first = 0; first < level.runs.size(); ++first) {
        if (seen[first]) continue;
        std::vector<int> ring;
        for (std::size_t i = first; !seen[i]; i = static_cast<std::size_t>(level.runs[i].next)) {
            seen[i] = true;
            ring.push_back(static_cast<int>(i));
        }
        callback(ring);
    }
}

/// The loop of one ring; nothing where rounding leaves none.
Region drawRing(const Level& level, const std::vector<int>& ring, const BoundaryDrawer& drawer,
                const std::vector<int>& first_sites) {
    LoopDrawer loop;
    const Run& first = level.runs[ring.front()];
    if (first.whole) {
        drawer.drawAll(first_sites[first.loop], loop);
    } else {
        loop.start(drawer.pointAt(level.runs[ring.back()].end));
        for (const int i : ring) {
            loop.bridgeTo(drawer.pointAt(level.runs[i].begin));
            drawer.draw(level.runs[i].begin, level.runs[i].end, loop);
        }
    }
    Region region;
    loop.closeInto(region);
    return region;
}

/// One ring along the walls: its runs, each joined to the next by `join(run, next, loop)`. Empty where
/// rounding leaves none.
template <typename Join>
Region drawWalls(const Profile& profile, const Level& level, const std::vector<int>& ring,
                 const std::vector<int>& first_sites, const Join& join) {
    const BoundaryDrawer drawer(profile, 0);
    LoopDrawer loop;
    const Run& first = level.runs[ring.front()];
    if (first.whole) {
        drawer.drawAll(first_sites[first.loop], loop);
    } else {
        loop.start(footOf(profile, first.begin));
        for (const int i : ring) {
            drawer.draw(level.runs[i].begin, level.runs[i].end, loop);
            join(i, level.runs[i].next, loop);
        }
    }
    Region region;
    loop.closeInto(region);
    return region;
}

}  // namespace

Region ringsOf(const Profile& profile, const Level& level) {
    const BoundaryDrawer drawer(profile, level.distance);
    const std::vector<int> first_sites = firstSites(profile);
    Region region;
    forEachRing(level, [&](const std::vector<int>& ring) {
        append(region, drawRing(level, ring, drawer, first_sites));
    });
    return region;
}

Level withoutEmptyRings(const Profile& profile, const Level& level) {
    constexpr double kWideMm = 1e-3;  // rings wider than this enclose something
    const BoundaryDrawer drawer(profile, level.distance);
    const std::vector<int> first_sites = firstSites(profile);
    std::vector<int> number(level.runs.size(), kNone);
    Level kept = level;
    kept.runs.clear();
    std::vector<bool> encloses(level.runs.size(), false);
    forEachRing(level, [&](const std::vector<int>& ring) {
        const Vec2& first = level.runs[ring.front()].end.centre;
        const bool wide = std::any_of(ring.begin(), ring.end(), [&](int i) {
            return !level.runs[i].whole && (level.runs[i].end.centre - first).norm() > kWideMm;
        });
        if (!wide && drawRing(level, ring, drawer, first_sites).empty()) return;
        for (const int i : ring)
            encloses[i] = true;
    });
    for (std::size_t i = 0; i < level.runs.size(); ++i) {
        if (!encloses[i]) continue;
        number[i] = static_cast<int>(kept.runs.size());
        kept.runs.push_back(level.runs[i]);
    }
    for (Run& run : kept.runs)
        run.next = number[run.next];
    return kept;
}

std::optional<Region> withoutStrips(const Profile& profile, const Level& level) {
    const bool paired = std::all_of(level.runs.begin(), level.runs.end(), [&](const Run& run) {
        const double apart_mm = run.whole ? 0 : (run.end.centre - level.runs[run.next].begin.centre).norm();
        return apart_mm <= kStripEndRadii * level.distance;
    });
    if (!paired) return std::nullopt;
    const BoundaryDrawer drawer(profile, 0);
    const std::vector<int> first_sites = firstSites(profile);
    const double corner_mm = kCornerRadii * level.distance;
    const auto join = [&](int run, int next, LoopDrawer& loop) {
        const Place& from = level.runs[run].end;
        const Place& to = level.runs[next].begin;
        if (lengthAlong(profile.sites(), from, to, corner_mm) <= corner_mm)
            drawer.draw(from, to, loop);
        else
            loop.lineTo(footOf(profile, to), kNone);
    };
    // Where a strip is hardly wider than the discs, its ends may pair to loops that are strips themselves.
    const auto isStrip = [&](const Region& piece) {
        return !piece.empty() &&
               std::abs(signedArea(piece.loops.front())) <= level.distance * perimeter(piece);
    };
    Region region;
    forEachRing(level, [&](const std::vector<int>& ring) {
        const Region piece = drawWalls(profile, level, ring, first_sites, join);
        if (level.runs[ring.front()].whole || !isStrip(piece)) append(region, piece);
    });
    return region;
}

std::optional<Swept> sweptBy(const Profile& profile, const Level& level) {
    for (const Run& run : level.runs)
        if (!run.whole && !isOneDisc(profile, level, run)) return std::nullopt;
    const std::vector<int> first_sites = firstSites(profile);
    // The discs found stand at the level's cut, which may lie a little above the distance asked for.
    const double radius = snapToGrid(level.cut);
    Swept swept;
    std::vector<Cap> caps;
    const auto join = [&](int i, int next_run, LoopDrawer& loop) {
        const Place& end = level.runs[i].end;
        const Place& next = level.runs[next_run].begin;
        const Cap cap{snapToGrid(Vec2((end.centre + next.centre) / 2)), footOf(profile, end),
                      footOf(profile, next), i, next_run};
        const double turn = turnRad(cap.from - cap.centre, cap.to - cap.centre);
        if (loop.arcTo(cap.to, {cap.centre, radius, true}, turn, kNone)) caps.push_back(cap);
    };
    forEachRing(level, [&](const std::vector<int>& ring) {
        append(swept.region, drawWalls(profile, level, ring, first_sites, join));
    });
    swept.overlapping = anyCapsCross(std::move(caps), radius);
    return swept;
}

}  // namespace stepmill::clearance
