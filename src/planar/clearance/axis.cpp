#include "planar/clearance/axis.h"

#include <map>
#include <numeric>

#include "stepmill/core/groups.h"

namespace stepmill::clearance {

namespace {

/// Nodes closer than this are one; the same vertex comes from all sites around it [mm].
constexpr double kSameNodeMm = 1e-5;
/// A disc of one edge is known to be the disc of another by the order of the pieces. Rounding of short arcs'
/// ends turns normals and moves its centre, the more the larger it is; beyond this share of its radius the
/// clearance jumps, and the two are none.
constexpr double kJointShare = 0.05;
constexpr std::size_t kNoNode = std::numeric_limits<std::size_t>::max();
/// Clearances along an edge that differ by less are equal [mm].
constexpr double kLevelMm = kTouchMm;

/// Points, with equal ones among them.
class Nodes {
  public:
    std::size_t add(const Vec2& point, double clearance) {
        raw_.push_back({point, clearance});
        return raw_.size() - 1;
    }

    /// Two points that should be one, unless the clearance jumps between them.
    void joinIfNear(std::size_t a, std::size_t b) {
        if (distance(a, b) <= kSameNodeMm + kJointShare * raw_[a].clearance_mm) joints_.push_back({a, b});
    }
    double distance(std::size_t a, std::size_t b) const { return (raw_[a].point - raw_[b].point).norm(); }

    const MedialAxis::Node& operator[](std::size_t i) const { return raw_[i]; }

    /// Merges what lies together; returns for every added point the one that stands for it.
    std::vector<std::size_t> merge() const {
        std::vector<std::size_t> order(raw_.size()), standing(raw_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return raw_[a].point.x() < raw_[b].point.x(); });
        Groups same(raw_.size());
        for (const auto& [a, b] : joints_)
            same.join(a, b);
        for (std::size_t k = 0; k < order.size(); ++k) {
            for (std::size_t j = k + 1; j < order.size(); ++j) {
                const Vec2 apart = raw_[order[j]].point - raw_[order[k]].point;
                if (apart.x() > kSameNodeMm) break;
                if (apart.norm() <= kSameNodeMm) same.join(order[k], order[j]);
            }
        }
        // The widest disc of each group: nothing near is wider than a room.
        std::vector<std::size_t> widest(raw_.size(), kNoNode);
        for (std::size_t i = 0; i < raw_.size(); ++i) {
            std::size_t& known = widest[same.of(i)];
            if (known == kNoNode || raw_[i].clearance_mm > raw_[known].clearance_mm) known = i;
        }
        for (std::size_t i = 0; i < raw_.size(); ++i)
            standing[i] = widest[same.of(i)];
        return standing;
    }

  private:
    std::vector<MedialAxis::Node> raw_;
    std::vector<std::pair<std::size_t, std::size_t>> joints_;
};

/// An edge of the graph as one of its two sites sees it.
struct EdgeSide {
    int site = 0;
    int stop = kUnbounded;
    std::size_t begin = 0;
    std::size_t end = 0;

    /// Both sites know an edge; the first one draws it.
    bool draws() const { return stop > site; }
};

/// All pieces in the order of the boundary. The disc at the end of each is the one at the next one's
/// beginning, all round the loop.
std::vector<EdgeSide> sidesOf(const Profile& profile, Nodes& nodes) {
    const int count = static_cast<int>(profile.sites().size());
    std::vector<EdgeSide> sides;
    for (int site = 0; site < count;) {
        const int loop = profile.sites()[site].loop;
        const std::size_t first = sides.size();
        for (; site < count && profile.sites()[site].loop == loop; ++site)
            for (const Piece& piece : profile.pieces(site))
                sides.push_back({site, piece.stop,
                                 nodes.add(profile.centreAt(site, piece.from, piece.at_from), piece.at_from),
                                 nodes.add(profile.centreAt(site, piece.to, piece.at_to), piece.at_to)});
        for (std::size_t k = first; k < sides.size(); ++k)
            nodes.joinIfNear(sides[k].end, sides[k + 1 < sides.size() ? k + 1 : first].begin);
    }
    return sides;
}

/// Joins the ends of every edge as its two sites see them.
void joinSides(const std::vector<EdgeSide>& sides, Nodes& nodes) {
    std::map<std::pair<int, int>, std::vector<const EdgeSide*>> drawn;
    for (const EdgeSide& side : sides)
        if (side.draws()) drawn[{side.site, side.stop}].push_back(&side);
    for (const EdgeSide& side : sides) {
        const auto others = drawn.find({side.stop, side.site});
        if (others == drawn.end()) continue;
        const auto apart = [&](const EdgeSide* other) {
            return std::max(nodes.distance(side.begin, other->end), nodes.distance(side.end, other->begin));
        };
        const EdgeSide* other =
            *std::min_element(others->second.begin(), others->second.end(),
                              [&](const EdgeSide* a, const EdgeSide* b) { return apart(a) < apart(b); });
        nodes.joinIfNear(side.begin, other->end);
        nodes.joinIfNear(side.end, other->begin);
    }
}

}  // namespace

MedialAxis medialAxisOf(const Profile& profile) {
    MedialAxis axis;
    Nodes nodes;
    const std::vector<EdgeSide> sides = sidesOf(profile, nodes);
    joinSides(sides, nodes);
    const std::vector<std::size_t> merged = nodes.merge();
    std::vector<std::size_t> number(merged.size(), kNoNode);
    const auto numberOf = [&](std::size_t added) {
        std::size_t& known = number[merged[added]];
        if (known == kNoNode) {
            known = axis.nodes.size();
            axis.nodes.push_back(nodes[merged[added]]);
        }
        return known;
    };
    for (const EdgeSide& side : sides) {
        // An arc's centre: the leaf in the arc, and all there is in a disc.
        if (side.stop == kOwnCentre) numberOf(side.begin);
        if (!side.draws() || merged[side.begin] == merged[side.end]) continue;
        const std::size_t from = numberOf(side.begin);
        axis.edges.push_back({from, numberOf(side.end)});
    }
    return axis;
}

std::vector<ClearanceEvent> eventsOf(const Profile& profile, const MedialAxis& axis) {
    // Nodes that level edges join are one plateau: a passage between parallel walls.
    Groups plateaus(axis.nodes.size());
    const auto rise = [&](const MedialAxis::Edge& e) {
        return axis.nodes[e.to].clearance_mm - axis.nodes[e.from].clearance_mm;
    };
    for (const MedialAxis::Edge& e : axis.edges)
        if (std::abs(rise(e)) <= kLevelMm) plateaus.join(e.from, e.to);
    struct Plateau {
        int nodes = 0;
        int rising = 0;
        int degree = 0;
        std::size_t lowest = kNoNode;
        std::size_t highest = kNoNode;
    };
    std::vector<Plateau> found(axis.nodes.size());
    const auto clearance = [&](std::size_t node) { return axis.nodes[node].clearance_mm; };
    for (std::size_t i = 0; i < axis.nodes.size(); ++i) {
        Plateau& plateau = found[plateaus.of(i)];
        ++plateau.nodes;
        if (plateau.lowest == kNoNode || clearance(i) < clearance(plateau.lowest)) plateau.lowest = i;
        if (plateau.highest == kNoNode || clearance(i) > clearance(plateau.highest)) plateau.highest = i;
    }
    for (const MedialAxis::Edge& e : axis.edges) {
        if (std::abs(rise(e)) <= kLevelMm) continue;
        ++found[plateaus.of(rise(e) > 0 ? e.from : e.to)].rising;
        ++found[plateaus.of(e.from)].degree;
        ++found[plateaus.of(e.to)].degree;
    }
    std::vector<ClearanceEvent> events;
    const auto add = [&](ClearanceEvent::Kind kind, std::size_t node) {
        if (clearance(node) > kLevelMm) events.push_back({kind, clearance(node), axis.nodes[node].point});
    };
    for (const Plateau& plateau : found) {
        if (plateau.nodes == 0) continue;
        const bool passage = plateau.nodes > 1;
        if (plateau.rising == 0)
            add(ClearanceEvent::Kind::Room, plateau.highest);
        else if (plateau.rising >= 2 || passage)
            add(ClearanceEvent::Kind::Neck, plateau.lowest);
        else if (plateau.degree >= 3)
            add(ClearanceEvent::Kind::Branch, plateau.lowest);
    }
    for (int site = 0; site < static_cast<int>(profile.sites().size()); ++site) {
        const Site& s = profile.sites()[site];
        const auto pieces = profile.pieces(site);
        const bool own =
            std::any_of(pieces.begin(), pieces.end(), [](const Piece& p) { return p.stop == kOwnCentre; });
        const bool again = std::any_of(events.begin(), events.end(), [&](const ClearanceEvent& e) {
            return (e.at - s.centre).norm() <= kSameNodeMm && std::abs(e.radius_mm - s.radius) <= kLevelMm;
        });
        if (own && !again) events.push_back({ClearanceEvent::Kind::CornerRadius, s.radius, s.centre});
    }
    std::sort(events.begin(), events.end(), [](const ClearanceEvent& a, const ClearanceEvent& b) {
        return std::tuple(a.radius_mm, a.at.y(), a.at.x()) < std::tuple(b.radius_mm, b.at.y(), b.at.x());
    });
    return events;
}

}  // namespace stepmill::clearance
