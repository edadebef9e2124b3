// Booleans of regions that differ in few places.

#include "layers/slab/local_boolean.h"

#include <algorithm>

#include "layers/indexed_region.h"
#include "layers/section/tidy_loop.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill::layers {

namespace {

/// Loops whose boxes come closer than this belong to one place [mm].
constexpr double kApartMm = 0.01;
/// Of a frame from the loops in it [mm].
constexpr double kFrameMm = 1;

bool equal(const Loop& a, const Loop& b) {
    if (a.start != b.start || a.segments.size() != b.segments.size()) return false;
    for (std::size_t i = 0; i < a.segments.size(); ++i)
        if (a.segments[i].to != b.segments[i].to || a.segments[i].arc != b.segments[i].arc) return false;
    return true;
}

bool before(const Loop* a, const Loop* b) {
    if (a->start.x() != b->start.x()) return a->start.x() < b->start.x();
    if (a->start.y() != b->start.y()) return a->start.y() < b->start.y();
    return a->segments.size() < b->segments.size();
}

std::vector<const Loop*> sortedLoops(const Region& region) {
    std::vector<const Loop*> loops;
    for (const Loop& loop : region.loops)
        loops.push_back(&loop);
    std::stable_sort(loops.begin(), loops.end(), before);
    return loops;
}

struct OwnedLoop {
    const Loop* loop = nullptr;
    bool in_a = false;
    bool in_b = false;
    Box2 box;
};

/// Loops of both regions, equal ones once.
std::vector<OwnedLoop> pairUp(const Region& a, const Region& b) {
    const std::vector<const Loop*> of_b = sortedLoops(b);
    std::vector<bool> paired(of_b.size(), false);
    std::vector<OwnedLoop> all;
    for (const Loop* loop : sortedLoops(a)) {
        OwnedLoop owned{loop, true, false, boundingBox(*loop)};
        const auto [first, last] = std::equal_range(of_b.begin(), of_b.end(), loop, before);
        for (auto it = first; it != last && !owned.in_b; ++it) {
            const auto index = static_cast<std::size_t>(it - of_b.begin());
            if (paired[index] || !equal(*loop, **it)) continue;
            owned.in_b = paired[index] = true;
        }
        all.push_back(owned);
    }
    for (std::size_t i = 0; i < of_b.size(); ++i)
        if (!paired[i]) all.push_back({of_b[i], false, true, boundingBox(*of_b[i])});
    return all;
}

Box2 joined(const Box2& a, const Box2& b) {
    Box2 box = a;
    box.extend(b);
    return box;
}

bool boundaryEnters(const Loop& loop, const Box2& box) {
    for (const auto& [from, segment] : eachEdge(loop))
        if (boundingBox(Path{from, {segment}}).intersects(box)) return true;
    return false;
}

struct Place {
    Box2 box;
    std::vector<int> loops;
};

void mergeOverlapping(std::vector<Place>& places) {
    for (bool again = true; again;) {
        again = false;
        for (std::size_t i = 0; i < places.size(); ++i) {
            for (std::size_t j = i + 1; j < places.size();) {
                if (!grown(places[i].box, kApartMm).intersects(places[j].box)) {
                    ++j;
                    continue;
                }
                places[i].box = joined(places[i].box, places[j].box);
                places[i].loops.insert(places[i].loops.end(), places[j].loops.begin(), places[j].loops.end());
                places.erase(places.begin() + static_cast<std::ptrdiff_t>(j));
                again = true;
            }
        }
    }
}

/// A shared loop that runs through a place belongs to it; true if any did.
bool takeIn(std::vector<OwnedLoop>& loops, std::vector<bool>& free, std::vector<Place>& places) {
    bool any = false;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (!free[i]) continue;
        for (Place& place : places) {
            const Box2 near = grown(place.box, kApartMm);
            if (!loops[i].box.intersects(near) || !boundaryEnters(*loops[i].loop, near)) continue;
            place.box = joined(place.box, loops[i].box);
            place.loops.push_back(static_cast<int>(i));
            free[i] = false;
            any = true;
            break;
        }
    }
    return any;
}

DifferentPlace cutOut(const std::vector<OwnedLoop>& loops, const std::vector<bool>& free,
                      const Place& place) {
    DifferentPlace out;
    for (const int i : place.loops) {
        if (loops[i].in_a) out.a.loops.push_back(*loops[i].loop);
        if (loops[i].in_b) out.b.loops.push_back(*loops[i].loop);
    }
    int winding = 0;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (!free[i] || !loops[i].box.intersects(place.box)) continue;
        Loop outer = *loops[i].loop;
        const bool ccw = signedArea(outer) > 0;
        if (!ccw) outer = reversed(outer);
        if (contains(Region{{outer}}, place.box.min())) winding += ccw ? 1 : -1;
    }
    out.framed = winding > 0;
    if (!out.framed) return out;
    const Box2 frame = grown(place.box, kFrameMm);
    const Loop loop = makeRectangle(frame.min(), frame.max()).loops.front();
    out.a.loops.push_back(loop);
    out.b.loops.push_back(loop);
    return out;
}

/// The union of a place in the form of sections, its frame taken away again: the one loop that reaches
/// farthest.
std::vector<Loop> withoutFrame(Region region, bool framed) {
    for (Loop& loop : region.loops) {
        Loop tidy = tidyLoop(loop.segments);
        if (!tidy.segments.empty()) loop = std::move(tidy);
    }
    if (!framed) return std::move(region.loops);
    const auto frame = std::min_element(
        region.loops.begin(), region.loops.end(),
        [](const Loop& a, const Loop& b) { return boundingBox(a).min().x() < boundingBox(b).min().x(); });
    if (frame != region.loops.end()) region.loops.erase(frame);
    return std::move(region.loops);
}

/// The union. Where boundaries that nearly coincide leave it with edges on top of each other, once more
/// with other points to snap to: the result with one of the two, then with coarser points, up to half the
/// gouge budget.
Region soundUnion(const Region& a, const Region& b, const Tolerances& tol) {
    const Region united = unite(a, b, tol);
    if (!diagnose(united)) return united;
    for (const double share : {0.0, 0.2, 0.5}) {
        Tolerances coarser = tol;
        coarser.linear_mm = std::max(tol.linear_mm, share * tol.gouge_mm);
        for (const Region* again : {&a, &b}) {
            const Region repeated = unite(united, *again, coarser);
            if (!diagnose(repeated)) return repeated;
        }
    }
    return united;
}

/// Does a point of b's boundary lie plainly outside a? Found at corners and middles of edges, it saves the
/// boolean that would only say no.
bool sticksOut(const Region& a, const Region& b, const Tolerances& tol) {
    const IndexedRegion indexed(a);
    const auto outside = [&](const Vec2& p) { return indexed.isBeyond(p, 2 * tol.linear_mm); };
    for (const auto& [from, segment] : eachEdge(b))
        if (outside(segment.to) || outside(pointAt(from, segment, 0.5))) return true;
    return false;
}

bool plainlyCovers(const Region& a, const Region& b, const Tolerances& tol) {
    return !sticksOut(a, b, tol) && covers(a, b, tol.linear_mm, tol);
}

Region uniteKeeping(const Region& a, const Region& b, const Tolerances& tol) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    if (plainlyCovers(a, b, tol)) return a;
    if (plainlyCovers(b, a, tol)) return b;
    return soundUnion(a, b, tol);
}

}  // namespace

SharedLoops compareLoops(const Region& a, const Region& b) {
    std::vector<OwnedLoop> loops = pairUp(a, b);
    std::vector<bool> free(loops.size(), true);
    std::vector<Place> places;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (loops[i].in_a && loops[i].in_b) continue;
        free[i] = false;
        places.push_back({loops[i].box, {static_cast<int>(i)}});
    }
    mergeOverlapping(places);
    while (takeIn(loops, free, places))
        mergeOverlapping(places);
    SharedLoops out;
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (free[i]) out.shared.push_back(*loops[i].loop);
    for (const Place& place : places)
        out.places.push_back(cutOut(loops, free, place));
    return out;
}

Region uniteLocally(const Region& a, const Region& b, const Tolerances& tol) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    SharedLoops compared = compareLoops(a, b);
    Region united{std::move(compared.shared)};
    for (const DifferentPlace& place : compared.places)
        for (Loop& loop : withoutFrame(uniteKeeping(place.a, place.b, tol), place.framed))
            united.loops.push_back(std::move(loop));
    sortLoops(united);
    return united;
}

}  // namespace stepmill::layers
