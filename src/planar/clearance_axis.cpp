#include "planar/clearance_axis.h"

#include <numeric>

namespace stepmill::clearance {

namespace {

/// Nodes closer than this are one; the same vertex comes from all sites around it [mm].
constexpr double kSameNodeMm = 1e-5;
/// Clearances along an edge that differ by less are equal [mm].
constexpr double kLevelMm = kTouchMm;

/// Groups of numbers, each named by its smallest member.
class Groups {
  public:
    explicit Groups(std::size_t count) : root_(count) {
        std::iota(root_.begin(), root_.end(), std::size_t{0});
    }

    std::size_t find(std::size_t i) {
        while (root_[i] != i)
            i = root_[i] = root_[root_[i]];
        return i;
    }
    void join(std::size_t i, std::size_t j) {
        const std::size_t a = find(i), b = find(j);
        root_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> root_;
};

/// Numbers points, equal ones alike.
class Nodes {
  public:
    std::size_t add(const Vec2& point, double clearance) {
        raw_.push_back({point, clearance});
        return raw_.size() - 1;
    }

    /// Merges what lies together; returns the number of every added point.
    std::vector<std::size_t> merge(std::vector<MedialAxis::Node>& nodes) const {
        std::vector<std::size_t> order(raw_.size()), number(raw_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return raw_[a].point.x() < raw_[b].point.x(); });
        Groups same(raw_.size());
        for (std::size_t k = 0; k < order.size(); ++k) {
            for (std::size_t j = k + 1; j < order.size(); ++j) {
                const Vec2 apart = raw_[order[j]].point - raw_[order[k]].point;
                if (apart.x() > kSameNodeMm) break;
                if (apart.norm() <= kSameNodeMm) same.join(order[k], order[j]);
            }
        }
        for (std::size_t i = 0; i < raw_.size(); ++i) {
            const std::size_t first = same.find(i);
            if (first == i) {
                number[i] = nodes.size();
                nodes.push_back(raw_[i]);
            } else {
                number[i] = number[first];
            }
        }
        return number;
    }

  private:
    std::vector<MedialAxis::Node> raw_;
};

/// Does this side draw the edge? Both sides know it; where they disagree by rounding, one is enough.
bool drawsEdge(int site, const Piece& piece) {
    return piece.stop > site;
}

}  // namespace

MedialAxis medialAxisOf(const Profile& profile) {
    MedialAxis axis;
    Nodes nodes;
    struct RawEdge {
        std::size_t from, to;
    };
    std::vector<RawEdge> raw;
    for (int site = 0; site < static_cast<int>(profile.sites().size()); ++site) {
        for (const Piece& piece : profile.pieces(site)) {
            // The leaf in an arc, and all there is in a disc.
            if (piece.stop == kOwnCentre) nodes.add(profile.sites()[site].centre, piece.at_from);
            if (!drawsEdge(site, piece)) continue;
            raw.push_back({nodes.add(profile.centreAt(site, piece.from, piece.at_from), piece.at_from),
                           nodes.add(profile.centreAt(site, piece.to, piece.at_to), piece.at_to)});
        }
    }
    const std::vector<std::size_t> number = nodes.merge(axis.nodes);
    for (const RawEdge& edge : raw)
        if (number[edge.from] != number[edge.to]) axis.edges.push_back({number[edge.from], number[edge.to]});
    return axis;
}

std::vector<ClearanceEvent> eventsOf(const Profile& profile, const MedialAxis& axis) {
    // Nodes that level edges join are one plateau.
    Groups plateaus(axis.nodes.size());
    const auto rise = [&](const MedialAxis::Edge& e) {
        return axis.nodes[e.to].clearance_mm - axis.nodes[e.from].clearance_mm;
    };
    for (const MedialAxis::Edge& e : axis.edges) {
        if (std::abs(rise(e)) <= kLevelMm) plateaus.join(e.from, e.to);
    }
    std::vector<int> rising(axis.nodes.size(), 0), degree(axis.nodes.size(), 0);
    for (const MedialAxis::Edge& e : axis.edges) {
        if (std::abs(rise(e)) <= kLevelMm) continue;
        ++rising[plateaus.find(rise(e) > 0 ? e.from : e.to)];
        ++degree[plateaus.find(e.from)];
        ++degree[plateaus.find(e.to)];
    }
    std::vector<ClearanceEvent> events;
    for (std::size_t i = 0; i < axis.nodes.size(); ++i) {
        if (plateaus.find(i) != i || axis.nodes[i].clearance_mm <= kLevelMm) continue;
        const MedialAxis::Node& node = axis.nodes[i];
        if (rising[i] == 0)
            events.push_back({ClearanceEvent::Kind::Room, node.clearance_mm, node.point});
        else if (rising[i] >= 2)
            events.push_back({ClearanceEvent::Kind::Neck, node.clearance_mm, node.point});
        else if (degree[i] >= 3)
            events.push_back({ClearanceEvent::Kind::Branch, node.clearance_mm, node.point});
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
