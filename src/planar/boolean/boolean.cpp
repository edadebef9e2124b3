// Unions, intersections and differences of regions.

#include "stepmill/planar/boolean.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "planar/boolean/arrangement.h"
#include "planar/boolean/loop_builder.h"
#include "planar/boolean/loop_groups.h"
#include "planar/boolean/windings.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {

namespace {

using Rule = std::function<bool(int, int)>;

/// Chords of the second way [mm]. Its results differ from the true lines and arcs by about that.
constexpr double kChordMm = 1e-4;

Region overlayOnChords(const std::vector<planar::Curve>& curves, const Rule& inside, const Tolerances& tol) {
    const auto arrangement = planar::arrangeOnChords(curves, kChordMm);
    const auto pieces = planar::boundary(planar::labelled(arrangement), inside);
    auto region = planar::buildLoops(arrangement, pieces, tol.linear_mm);
    if (!region)
        throw Error(ErrorCode::GeometryKernel, "planar boolean", "the pieces of the result do not close up");
    return *std::move(region);
}

/// Points `inside` the rule, from all boundaries cut at each other.
Region overlayCurves(const std::vector<planar::Curve>& curves, const Rule& inside, const Tolerances& tol) {
    // Where several points crowd within the snapping distance, pieces may be pushed across nodes. Another
    // distance puts the points in other clusters; the first that contradicts itself nowhere is taken.
    std::optional<Region> doubtful;
    for (const double factor : {1.0, 0.3, 0.05, 2.5, 0.02, 6.0}) {
        const planar::Arrangement arrangement = planar::arrange(curves, factor * tol.linear_mm);
        const std::vector<planar::LabelledPiece> labels = planar::labelled(arrangement);
        const bool consistent = planar::consistent(arrangement, labels);
        if (!consistent && doubtful) continue;
        auto region = planar::buildLoops(arrangement, planar::boundary(labels, inside), tol.linear_mm);
        if (consistent && region) return *std::move(region);
        if (region) doubtful = std::move(region);
    }
    // Chords tell what is right. A result that contradicts itself somewhere is true to the lines and arcs
    // all the same, and stays where chords find as much area; they share no labels.
    Region region = overlayOnChords(curves, inside, tol);
    const double slack_mm2 = 2 * tol.linear_mm * perimeter(region);
    if (doubtful && std::abs(area(*doubtful) - area(region)) <= slack_mm2) return *std::move(doubtful);
    return region;
}

/// Loops farther apart than this do not meet: several times the widest snapping distance, as a multiple of
/// `linear_mm`.
constexpr double kApartShare = 20;

using OperandLoops = std::vector<planar::OperandLoop>;

/// The loop where the rule tells its two sides apart, turned so that the inside is on its left.
/// \pre isTidy()
Region overlayTidy(const planar::OperandLoop& one, const Rule& inside) {
    const int left = signedArea(*one.loop) > 0 ? 1 : 0;
    const auto isInside = [&](int windings) {
        return one.operand == 0 ? inside(windings, 0) : inside(0, windings);
    };
    const bool in_left = isInside(left);
    if (in_left == isInside(left - 1)) return {};
    return {{in_left ? *one.loop : reversed(*one.loop)}};
}

/// Do the loops bound nothing, as the other operand alone tells what is inside here?
bool boundsNothing(const planar::LoopGroup& group, const Rule& inside) {
    constexpr int kMany = 1'000'000;  // windings; rules only turn once from few to many
    const int operand = group.loops.front().operand;
    for (const planar::OperandLoop& one : group.loops)
        if (one.operand != operand) return false;
    const auto isInside = [&](int windings) {
        return operand == 0 ? inside(windings, 0) : inside(0, windings);
    };
    return isInside(-kMany) == isInside(kMany);
}

Region overlayGroup(const planar::LoopGroup& group, const Rule& inside, const Tolerances& tol) {
    const Rule inside_here = [&](int a, int b) { return inside(a + group.around[0], b + group.around[1]); };
    if (boundsNothing(group, inside_here)) return {};
    const OperandLoops& loops = group.loops;
    if (loops.size() == 1 && planar::isTidy(loops.front(), kApartShare * tol.linear_mm, tol.linear_mm))
        return overlayTidy(loops.front(), inside_here);
    std::vector<planar::Curve> curves;
    for (std::size_t i = 0; i < loops.size(); ++i)
        planar::appendCurves(*loops[i].loop, loops[i].operand, static_cast<int>(i), curves);
    return overlayCurves(curves, inside_here, tol);
}

/// Points `inside` the rule, group by group of loops that meet.
Region overlay(const OperandLoops& loops, const Rule& inside, const Tolerances& tol) {
    Region result;
    for (const planar::LoopGroup& group : planar::loopGroups(loops, kApartShare * tol.linear_mm))
        append(result, overlayGroup(group, inside, tol));
    return planar::ordered(std::move(result));
}

void appendLoops(const Region& region, int operand, OperandLoops& loops) {
    for (const Loop& loop : region.loops)
        loops.push_back({&loop, operand});
}

/// The loops whose boxes come near the box. No other loop can contain a point of the box.
Region near(const Region& region, const Box2& box) {
    Region result;
    for (const Loop& loop : region.loops)
        if (boundingBox(loop).intersects(box)) result.loops.push_back(loop);
    return result;
}

OperandLoops loopsOf(const Region& a, const Region& b) {
    OperandLoops loops;
    appendLoops(a, 0, loops);
    appendLoops(b, 1, loops);
    return loops;
}

struct Placed {
    const Region* region;
    Box2 box;
};

Region uniteAtOnce(std::span<const Placed> regions, const Tolerances& tol) {
    OperandLoops loops;
    Region apart;
    for (const Placed& one : regions) {
        const bool meets = std::any_of(regions.begin(), regions.end(), [&](const Placed& other) {
            return &other != &one && one.box.intersects(other.box);
        });
        if (meets)
            appendLoops(*one.region, 0, loops);
        else
            apart.loops.insert(apart.loops.end(), one.region->loops.begin(), one.region->loops.end());
    }
    if (loops.empty()) return apart;
    append(apart, overlay(
                      loops, [](int a, int) { return a > 0; }, tol));
    return apart;
}

constexpr std::size_t kAtOnce = 8;

std::vector<Placed> placedAll(std::span<const Region> regions, const Tolerances& tol) {
    std::vector<Placed> placed;
    for (const Region& region : regions)
        if (!region.empty()) placed.push_back({&region, grown(boundingBox(region), tol.linear_mm)});
    return placed;
}

/// Sorts them along the longer side of where they lie; the first half comes before the second.
std::pair<std::span<Placed>, std::span<Placed>> halved(std::span<Placed> regions) {
    Box2 all;
    for (const Placed& one : regions)
        all.extend((one.box.min() + one.box.max()) / 2);
    const int axis = all.sizes().x() >= all.sizes().y() ? 0 : 1;
    std::stable_sort(regions.begin(), regions.end(), [axis](const Placed& a, const Placed& b) {
        return a.box.min()[axis] + a.box.max()[axis] < b.box.min()[axis] + b.box.max()[axis];
    });
    const std::size_t half = regions.size() / 2;
    return {regions.first(half), regions.subspan(half)};
}

/// Many regions on top of each other cross far more often than their union does. So neighbours first: the
/// set is halved across its longer side until few are left. Sorts `regions`.
Region uniteNeighbours(std::span<Placed> regions, const Tolerances& tol) {
    if (regions.size() <= kAtOnce) return uniteAtOnce(regions, tol);
    const auto [first, second] = halved(regions);
    const Region halves[] = {uniteNeighbours(first, tol), uniteNeighbours(second, tol)};
    return uniteAtOnce(placedAll(halves, tol), tol);
}

/// Neighbours united, as long as more than a few regions would be left. Sorts `regions`.
void uniteToFew(std::span<Placed> regions, std::size_t few, const Tolerances& tol,
                std::vector<Region>& left) {
    if (few <= 1 || regions.size() <= kAtOnce) {
        left.push_back(uniteNeighbours(regions, tol));
        return;
    }
    const auto [first, second] = halved(regions);
    uniteToFew(first, few / 2, tol, left);
    uniteToFew(second, few / 2, tol, left);
}

}  // namespace

Region unite(const Region& a, const Region& b, const Tolerances& tol) {
    const Region both[] = {a, b};
    return unite(both, tol);
}

Region unite(std::span<const Region> regions, const Tolerances& tol) {
    std::vector<Placed> placed = placedAll(regions, tol);
    return planar::ordered(uniteNeighbours(placed, tol));
}

Region encircled(const Loop& loop, const Tolerances& tol) {
    return overlay(
        {{&loop, 0}}, [](int a, int) { return a > 0; }, tol);
}

Region intersect(const Region& a, const Region& b, const Tolerances& tol) {
    if (a.empty() || b.empty()) return {};
    const Region near_a = near(a, grown(boundingBox(b), tol.linear_mm));
    const Region near_b = near(b, grown(boundingBox(a), tol.linear_mm));
    if (near_a.empty() || near_b.empty()) return {};
    return overlay(
        loopsOf(near_a, near_b), [](int in_a, int in_b) { return in_a > 0 && in_b > 0; }, tol);
}

Region subtract(const Region& a, const Region& b, const Tolerances& tol) {
    if (a.empty()) return {};
    const Region near_b = near(b, grown(boundingBox(a), tol.linear_mm));
    if (near_b.empty()) return planar::ordered(a);
    return overlay(
        loopsOf(a, near_b), [](int in_a, int in_b) { return in_a > 0 && in_b <= 0; }, tol);
}

Region subtract(const Region& a, std::span<const Region> many, const Tolerances& tol) {
    if (a.empty()) return {};
    std::vector<Placed> near_a = placedAll(many, tol);
    const Box2 box = boundingBox(a);
    std::erase_if(near_a, [&](const Placed& one) { return !one.box.intersects(box); });
    if (near_a.empty()) return planar::ordered(a);
    // The last unions are the longest, and cross each other no more than `a`.
    std::vector<Region> few;
    uniteToFew(near_a, kAtOnce, tol, few);
    OperandLoops loops;
    appendLoops(a, 0, loops);
    for (const Region& one : few)
        appendLoops(one, 1, loops);
    return overlay(
        loops, [](int in_a, int in_b) { return in_a > 0 && in_b <= 0; }, tol);
}

}  // namespace stepmill
