// From pieces of an arrangement back to loops of true lines and arcs.

#include "planar/boolean/loop_builder.h"

#include <algorithm>
#include <cmath>

#include "planar/boolean/junction.h"
#include "planar/intersection.h"
#include "planar/segment.h"
#include "stepmill/core/units.h"

namespace stepmill::planar {

namespace {

/// Circles closer than this are one circle that was rounded differently.
constexpr double kSameCircleMm = 3 * kGridMm;

// Walks --------------------------------------------------------------------------------------------------

/// Closed walks along the pieces with the inside always next to them on the left; a walk that comes back
/// to one of its nodes is split there, so that every loop is simple.
class Walker {
  public:
    Walker(const Arrangement& arrangement, const std::vector<Piece>& pieces)
        : arrangement_(arrangement), pieces_(pieces), used_(pieces.size(), false) {
        std::vector<int> begins;
        begins.reserve(pieces.size());
        int last = -1;
        for (const Piece& piece : pieces) {
            begins.push_back(piece.begin);
            last = std::max({last, piece.begin, piece.end});
        }
        leaving_ = Grouped(begins, at(last + 1));
        arriving_.assign(leaving_.count(), 0);
        for (const Piece& piece : pieces)
            ++arriving_[at(piece.end)];
    }

    bool closesUp() const {
        for (std::size_t i = 0; i < leaving_.count(); ++i)
            if (leaving_[i].size() != arriving_[i]) return false;
        return true;
    }

    /// Do more than two edges of the result meet at the node?
    bool touchesAt(int node) const { return leaving_[at(node)].size() > 1; }

    std::vector<std::vector<int>> loops() {
        std::vector<std::vector<int>> result;
        std::vector<int> place(leaving_.count(), -1);  // of a node in the walk
        for (std::size_t first = 0; first < pieces_.size(); ++first) {
            if (used_[first]) continue;
            std::vector<int> walk;
            int piece = static_cast<int>(first);
            while (piece >= 0) {
                used_[at(piece)] = true;
                place[at(pieces_[at(piece)].begin)] = static_cast<int>(walk.size());
                walk.push_back(piece);
                const int node = pieces_[at(piece)].end;
                if (place[at(node)] >= 0) {
                    const auto from = walk.begin() + place[at(node)];
                    result.emplace_back(from, walk.end());
                    for (auto it = from; it != walk.end(); ++it)
                        place[at(pieces_[at(*it)].begin)] = -1;
                    walk.erase(from, walk.end());
                    if (walk.empty()) break;
                }
                piece = next(piece);
            }
        }
        return result;
    }

  private:
    /// The first unused piece clockwise from the one we came on: between them lies the inside.
    int next(int piece) const {
        const int node = pieces_[at(piece)].end;
        if (leaving_[at(node)].size() == 1) {
            const int only = leaving_[at(node)].front();
            return used_[at(only)] ? -1 : only;
        }
        std::vector<int> choices;
        for (const int candidate : leaving_[at(node)])
            if (!used_[at(candidate)]) choices.push_back(candidate);
        if (choices.size() <= 1) return choices.empty() ? -1 : choices.front();
        std::vector<PieceEnd> ends{{&pieces_[at(piece)], false}};
        for (const int candidate : choices)
            ends.push_back({&pieces_[at(candidate)], true});
        const std::vector<std::size_t> order = counterClockwise(arrangement_, ends);
        const auto came = std::find(order.begin(), order.end(), std::size_t{0});
        const std::size_t clockwise = came == order.begin() ? order.back() : *(came - 1);
        return choices[clockwise - 1];
    }

    const Arrangement& arrangement_;
    const std::vector<Piece>& pieces_;
    std::vector<bool> used_;
    Grouped leaving_;                    // pieces by the node where they begin
    std::vector<std::size_t> arriving_;  // how many end at a node
};

// Edges --------------------------------------------------------------------------------------------------

/// An edge of the result with the line or circle it lies on.
struct BuiltEdge {
    Vec2 from;
    Segment segment;
    Vec2 carrier_from;  ///< the source line; its rounding is what positions go by
    Vec2 carrier_to;
    int curve = 0;
    double piece_mm = 0;       ///< length of the longest piece in it
    double sweep_rad = 0;      ///< of all its arcs, without sign
    std::vector<Vec2> passed;  ///< joints merged away
    bool touches = false;      ///< other edges of the result meet where this one starts

    Segment carrier() const { return {carrier_to, segment.arc}; }
};

bool oneLine(const BuiltEdge& a, const BuiltEdge& b) {
    const Vec2 whole = b.segment.to - a.from;
    if (whole.dot(a.segment.to - a.from) <= 0 || whole.dot(b.segment.to - b.from) <= 0) return false;
    if (a.curve == b.curve) return true;
    const Vec2 direction = whole.normalized();
    const auto on_line = [&](const Vec2& p) { return std::abs(cross(direction, p - a.from)) <= kOnCurveMm; };
    return on_line(b.from) && std::all_of(a.passed.begin(), a.passed.end(), on_line) &&
           std::all_of(b.passed.begin(), b.passed.end(), on_line);
}

bool mergeable(const BuiltEdge& a, const BuiltEdge& b) {
    if (a.segment.arc.has_value() != b.segment.arc.has_value()) return false;
    return a.segment.arc ? sameCircle(*a.segment.arc, *b.segment.arc) : oneLine(a, b);
}

void absorb(BuiltEdge& a, const BuiltEdge& b) {
    a.passed.push_back(b.from);
    a.passed.insert(a.passed.end(), b.passed.begin(), b.passed.end());
    a.segment.to = b.segment.to;
    a.sweep_rad += b.sweep_rad;
    // The longer piece knows the direction better; a short one may have been bent to a node.
    if (b.piece_mm <= a.piece_mm) return;
    a.piece_mm = b.piece_mm;
    a.carrier_from = b.carrier_from;
    a.carrier_to = b.carrier_to;
    a.curve = b.curve;
}

std::vector<BuiltEdge> mergedEdges(std::vector<BuiltEdge> edges) {
    // Start where an edge of the result starts.
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (mergeable(edges[(i + edges.size() - 1) % edges.size()], edges[i])) continue;
        std::rotate(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(i), edges.end());
        break;
    }
    std::vector<BuiltEdge> merged;
    for (const BuiltEdge& edge : edges) {
        if (!merged.empty() && mergeable(merged.back(), edge))
            absorb(merged.back(), edge);
        else
            merged.push_back(edge);
    }
    return merged;
}

/// Does the edge run along the line or circle of the other, to within slack?
bool runsAlong(const BuiltEdge& edge, const BuiltEdge& other, double slack_mm) {
    const auto near = [&](const Vec2& p) {
        return distanceToCarrier(p, other.carrier_from, other.carrier()) <= slack_mm;
    };
    const Vec2 middle = pointAt(edge.from, edge.segment, 0.5);
    return near(edge.from) && near(edge.segment.to) && near(middle) &&
           std::all_of(edge.passed.begin(), edge.passed.end(), near);
}

/// Where two curves run within a chord of each other, chords take turns in coming from one and the other.
/// The longer stretch takes over the shorter one next to it.
std::vector<BuiltEdge> withoutSwitches(std::vector<BuiltEdge> edges, double slack_mm) {
    for (std::size_t i = 0, unchanged = 0; unchanged < edges.size() && edges.size() > 2;) {
        const std::size_t next = (i + 1) % edges.size();
        BuiltEdge& a = edges[i];
        BuiltEdge& b = edges[next];
        const double la = length(a.from, a.segment);
        const double lb = length(b.from, b.segment);
        const bool a_stays = la >= lb;
        BuiltEdge& longer = a_stays ? a : b;
        const BuiltEdge& shorter = a_stays ? b : a;
        const Vec2 whole = b.segment.to - a.from;
        if (!mergeable(a, b) &&
            (!runsAlong(shorter, longer, slack_mm) || whole.norm() < std::max(la, lb) / 2)) {
            i = next;
            ++unchanged;
            continue;
        }
        if (longer.segment.arc) {
            const Vec2 centre = longer.segment.arc->centre;
            const Vec2 u = shorter.from - centre;
            const Vec2 v = shorter.segment.to - centre;
            const double turn = turnRad(u, v);
            longer.sweep_rad += longer.segment.arc->ccw ? turn : -turn;
        }
        longer.passed.push_back(b.from);
        longer.passed.insert(longer.passed.end(), shorter.passed.begin(), shorter.passed.end());
        if (a_stays)
            a.segment.to = b.segment.to;
        else
            b.from = a.from;
        edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(a_stays ? next : i));
        unchanged = 0;
        i = edges.empty() ? 0 : i % edges.size();
    }
    return edges;
}

/// Where two edges that follow each other meet, near their common node.
Vec2 jointOf(const BuiltEdge& a, const BuiltEdge& b, double thin_mm) {
    // Where boundaries touch, intersections of different pairs lie micrometres apart if the edges meet at
    // small angles, and loops would overlap: there the joint stays at the node.
    double reach_mm = b.touches ? thin_mm : 100 * thin_mm;
    const Vec2 node = b.from;
    const auto off = [&](const BuiltEdge& edge, const Vec2& p) {
        return distanceToCarrier(p, edge.carrier_from, edge.carrier());
    };
    if (off(a, node) <= kOnCurveMm && off(b, node) <= kOnCurveMm) return node;
    Vec2 best = node;
    // Beyond a part of the shorter edge the intersection is that of another joint.
    const double shorter = std::min(length(a.from, a.segment), length(b.from, b.segment));
    reach_mm = std::min(reach_mm, shorter / 4);
    double distance = reach_mm;
    for (const Vec2& p :
         carrierIntersections(a.carrier_from, a.carrier(), b.carrier_from, b.carrier(), kRounded)) {
        if ((p - node).norm() >= distance) continue;
        distance = (p - node).norm();
        best = p;
    }
    if (distance < reach_mm) return snapToGrid(best);
    // Tangent or nearly so. A line may turn a little, an arc may not leave its circle.
    const BuiltEdge& firm = b.segment.arc && !a.segment.arc ? b : a;
    return snapToGrid(projectOnCarrier(node, firm.carrier_from, firm.carrier()));
}

Loop circleLoop(const Arc& arc) {
    const Loop loop = makeCircle(arc.centre, arc.radius_mm).loops.front();
    return arc.ccw ? loop : reversed(loop);
}

/// Appends the edge; where a joint had to stay off an arc's circle, a short line leads there.
void append(Loop& loop, const BuiltEdge& edge, const Vec2& to) {
    if (!edge.segment.arc) {
        if (loop.end() != to) loop.segments.push_back({to, std::nullopt});
        return;
    }
    const auto onCircle = [&](const Vec2& p) {
        if (distanceToCarrier(p, edge.carrier_from, edge.carrier()) <= kOnCurveMm) return p;
        return snapToGrid(projectOnCarrier(p, edge.carrier_from, edge.carrier()));
    };
    const Vec2 begin = onCircle(loop.end());
    const Vec2 end = onCircle(to);
    if (begin != loop.end()) loop.segments.push_back({begin, std::nullopt});
    // Ends moved past each other turn next to nothing into a full turn or the other way round.
    const double sweep = std::abs(sweepAngle(begin, end, *edge.segment.arc));
    if (std::abs(sweep - edge.sweep_rad) < kPi)
        loop.segments.push_back({end, edge.segment.arc});
    else if (edge.sweep_rad > kPi)
        loop.segments.push_back({begin, edge.segment.arc});
    if (loop.end() != end) loop.segments.push_back({end, std::nullopt});
    if (end != to) loop.segments.push_back({to, std::nullopt});
}

Loop loopOf(const std::vector<BuiltEdge>& edges, double thin_mm) {
    if (edges.size() == 1) {
        if (!edges.front().segment.arc) return {};
        return circleLoop(*edges.front().segment.arc);
    }
    std::vector<Vec2> joints;  // joint i: end of edge i
    for (std::size_t i = 0; i < edges.size(); ++i)
        joints.push_back(jointOf(edges[i], edges[(i + 1) % edges.size()], thin_mm));
    Loop loop{joints.back(), {}};
    for (std::size_t i = 0; i < edges.size(); ++i)
        append(loop, edges[i], joints[i]);
    return loop;
}

/// Cuts off where a line runs back over the one before it, to within `thin_mm`.
void removeSpikes(Loop& loop, double thin_mm) {
    for (std::size_t i = 0; i < loop.segments.size() && loop.segments.size() > 2;) {
        const std::size_t count = loop.segments.size();
        const std::size_t next = (i + 1) % count;
        const Vec2 from = loop.segments[(i + count - 1) % count].to;
        const Vec2 tip = loop.segments[i].to;
        const Vec2 to = loop.segments[next].to;
        const bool lines = !loop.segments[i].arc && !loop.segments[next].arc;
        const bool back =
            (tip - from).dot(to - tip) < 0 && std::min(distanceTo(to, from, {tip, std::nullopt}),
                                                       distanceTo(from, tip, {to, std::nullopt})) <= thin_mm;
        if (!lines || !back) {
            ++i;
            continue;
        }
        loop.segments[i].to = to;
        loop.segments.erase(loop.segments.begin() + static_cast<std::ptrdiff_t>(next));
        if (from == to) {
            const std::size_t here = next == 0 ? i - 1 : i;
            loop.segments.erase(loop.segments.begin() + static_cast<std::ptrdiff_t>(here));
        }
        i = 0;
    }
    if (!loop.segments.empty()) loop.start = loop.end();
}

bool lowerLeft(const Vec2& a, const Vec2& b) {
    return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
}

}  // namespace

bool sameCircle(const Arc& a, const Arc& b) {
    return a.ccw == b.ccw &&
           (a.centre - b.centre).norm() + std::abs(a.radius_mm - b.radius_mm) <= kSameCircleMm;
}

std::optional<Region> buildLoops(const Arrangement& arrangement, const std::vector<Piece>& pieces,
                                 double thin_mm) {
    Walker walker(arrangement, pieces);
    if (!walker.closesUp()) return std::nullopt;
    Region region;
    for (const std::vector<int>& walk : walker.loops()) {
        std::vector<BuiltEdge> edges;
        for (const int index : walk) {
            const Piece& piece = pieces[at(index)];
            const Curve& curve = arrangement.curves[at(piece.curve)];
            const Vec2& from = arrangement.place(piece.begin);
            const Segment segment = arrangement.onCurve(piece);
            if (from == segment.to) continue;
            const double piece_mm = (segment.to - from).norm();
            edges.push_back({from,
                             segment,
                             curve.from,
                             curve.segment.to,
                             piece.curve,
                             piece_mm,
                             0,
                             {},
                             walker.touchesAt(piece.begin)});
            if (segment.arc) edges.back().sweep_rad = std::abs(sweepAngle(from, segment.to, *segment.arc));
        }
        if (edges.empty()) continue;
        edges = mergedEdges(std::move(edges));
        if (arrangement.chord_mm > 0) edges = withoutSwitches(std::move(edges), 2 * arrangement.chord_mm);
        Loop loop = loopOf(edges, thin_mm);
        removeSpikes(loop, thin_mm);
        if (loop.segments.size() == 1 && loop.segments[0].arc) loop = circleLoop(*loop.segments[0].arc);
        if (loop.segments.size() < 2) continue;
        // Width of a long thin loop: area over half its perimeter.
        if (2 * std::abs(signedArea(loop)) <= thin_mm * length(loop)) continue;
        region.loops.push_back(std::move(loop));
    }
    return ordered(std::move(region));
}

Region ordered(Region region) {
    for (Loop& loop : region.loops) {
        std::size_t lowest = loop.segments.size() - 1;
        for (std::size_t i = 0; i < loop.segments.size(); ++i)
            if (lowerLeft(loop.segments[i].to, loop.segments[lowest].to)) lowest = i;
        loop.start = loop.segments[lowest].to;
        std::rotate(loop.segments.begin(), loop.segments.begin() + static_cast<std::ptrdiff_t>(lowest) + 1,
                    loop.segments.end());
    }
    std::vector<std::pair<double, std::size_t>> keys;
    for (std::size_t i = 0; i < region.loops.size(); ++i)
        keys.emplace_back(signedArea(region.loops[i]), i);
    std::stable_sort(keys.begin(), keys.end(), [&](const auto& a, const auto& b) {
        const Vec2& p = region.loops[a.second].start;
        const Vec2& q = region.loops[b.second].start;
        if (p != q) return lowerLeft(p, q);
        return a.first > b.first;
    });
    Region result;
    for (const auto& key : keys)
        result.loops.push_back(std::move(region.loops[key.second]));
    return result;
}

}  // namespace stepmill::planar
