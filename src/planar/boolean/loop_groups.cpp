// Which loops of a Boolean have to do with each other.

#include "planar/boolean/loop_groups.h"

#include <algorithm>
#include <cmath>

#include "planar/boolean/curve_pairs.h"
#include "planar/boolean/loop_builder.h"
#include "planar/intersection.h"
#include "planar/segment.h"
#include "stepmill/core/groups.h"
#include "stepmill/planar/box_tree.h"

namespace stepmill::planar {

namespace {

std::vector<Curve> curvesOf(const OperandLoop& loop) {
    std::vector<Curve> curves;
    appendCurves(*loop.loop, loop.operand, 0, curves);
    return curves;
}

Groups groupsOf(const std::vector<OperandLoop>& loops, double apart_mm) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < loops.size(); ++i)
        appendCurves(*loops[i].loop, loops[i].operand, static_cast<int>(i), curves);
    Groups groups(loops.size());
    for (const auto& [i, j] : overlappingBoxes(curves, apart_mm)) {
        const Curve& a = curves[at(i)];
        const Curve& b = curves[at(j)];
        if (groups.of(a.loop) != groups.of(b.loop) && separation(a, b) <= apart_mm)
            groups.join(a.loop, b.loop);
    }
    return groups;
}

bool crossesItself(const std::vector<Curve>& curves, double apart_mm) {
    const auto cross = [&](const Curve& a, const Curve& b) {
        if (!adjacent(a, b)) return separation(a, b) <= apart_mm;
        const auto places = contacts(a, b, apart_mm);
        return std::any_of(places.begin(), places.end(),
                           [&](const Vec2& p) { return crossesBesideCorner(a, b, p); });
    };
    const std::vector<std::pair<int, int>> pairs = overlappingBoxes(curves, apart_mm);
    return std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
        return cross(curves[at(pair.first)], curves[at(pair.second)]);
    });
}

/// Two half arcs from the rightmost and the leftmost point, as Booleans draw circles.
bool isTidyCircle(const Loop& loop) {
    if (loop.segments.size() != 2 || !loop.segments[0].arc || loop.segments[0].arc != loop.segments[1].arc)
        return false;
    const Arc& arc = *loop.segments[0].arc;
    const Loop drawn = makeCircle(arc.centre, arc.radius_mm).loops.front();
    const Vec2& right = drawn.start;
    const Vec2& left = drawn.segments.front().to;
    return (loop.start == right && loop.segments[0].to == left) ||
           (loop.start == left && loop.segments[0].to == right);
}

bool isOnArc(const Vec2& p, const Segment& segment) {
    return !segment.arc || std::abs((p - segment.arc->centre).norm() - segment.arc->radius_mm) <= kOnCurveMm;
}

/// Two edges that follow each other at a corner that stays as it is.
bool isTidyCorner(const Edge& a, const Edge& b) {
    const Vec2& corner = b.from;
    if (snapToGrid(corner) != corner || !isOnArc(corner, a.segment) || !isOnArc(corner, b.segment))
        return false;
    if (a.segment.arc && b.segment.arc) return !sameCircle(*a.segment.arc, *b.segment.arc);
    if (a.segment.arc || b.segment.arc) return true;
    const Vec2 ahead = corner - a.from, on = b.to() - corner;
    // Straight on, or back over itself.
    return ahead.dot(on) >= 0 && std::abs(cross(ahead, on)) > kOnCurveMm * (ahead + on).norm();
}

}  // namespace

std::vector<LoopGroup> loopGroups(const std::vector<OperandLoop>& loops, double apart_mm) {
    Groups groups = groupsOf(loops, apart_mm);
    std::vector<LoopGroup> found;
    std::vector<int> place(loops.size(), -1);  // in `found`, of the group named after a loop
    for (std::size_t i = 0; i < loops.size(); ++i) {
        int& group = place[groups.of(i)];
        if (group < 0) {
            group = static_cast<int>(found.size());
            found.emplace_back();
        }
        found[at(group)].loops.push_back(loops[i]);
    }
    if (found.size() < 2) return found;
    std::vector<Box2> boxes;
    boxes.reserve(loops.size());
    for (const OperandLoop& one : loops)
        boxes.push_back(boundingBox(*one.loop));
    const BoxTree tree(std::move(boxes));
    for (std::size_t k = 0; k < found.size(); ++k) {
        const Vec2& p = found[k].loops.front().loop->start;
        tree.forEachNear(Box2(p, p), [&](std::size_t i) {
            if (place[groups.of(i)] != static_cast<int>(k))
                found[k].around[at(loops[i].operand)] += windingNumber(*loops[i].loop, p);
        });
    }
    return found;
}

bool isTidy(const OperandLoop& operand_loop, double apart_mm, double thin_mm) {
    const Loop& loop = *operand_loop.loop;
    if (isTidyCircle(loop)) return loop.segments.front().arc->radius_mm > apart_mm;
    if (loop.segments.size() < 3 || 2 * std::abs(signedArea(loop)) <= thin_mm * length(loop)) return false;
    const std::vector<Edge> edges = edgesOf(loop);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge& next = edges[i + 1 < edges.size() ? i + 1 : 0];
        if (length(edges[i]) <= apart_mm || !isTidyCorner(edges[i], next)) return false;
    }
    return !crossesItself(curvesOf(operand_loop), apart_mm);
}

}  // namespace stepmill::planar
