#include "plan/assignment/best_closure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>

namespace stepmill {
namespace {

/// Gains are whole numbers of this share of the largest, so that a cut is one for certain.
constexpr double kGainUnit = 1e-6;
constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max() / 4;

/// A network whose arcs stand in pairs: arc i runs against arc i ^ 1.
class Network {
  public:
    explicit Network(std::size_t nodes) : arcs_of_(nodes) {}

    void connect(std::size_t from, std::size_t to, std::int64_t room) {
        arcs_of_[from].push_back(arcs_.size());
        arcs_.push_back({to, room});
        arcs_of_[to].push_back(arcs_.size());
        arcs_.push_back({from, 0});
    }

    /// Fills the network; returns which nodes the source still reaches.
    std::vector<bool> fill(std::size_t source, std::size_t sink) {
        for (;;) {
            const std::vector<std::size_t> came_by = search(source);
            if (came_by[sink] == kNone) {
                std::vector<bool> reached(arcs_of_.size());
                for (std::size_t node = 0; node < reached.size(); ++node)
                    reached[node] = node == source || came_by[node] != kNone;
                return reached;
            }
            push(came_by, source, sink);
        }
    }

  private:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    struct NetworkArc {
        std::size_t to = 0;
        std::int64_t room = 0;
    };

    /// The arc each node is reached by, breadth first.
    std::vector<std::size_t> search(std::size_t source) const {
        std::vector<std::size_t> came_by(arcs_of_.size(), kNone);
        std::queue<std::size_t> open;
        open.push(source);
        while (!open.empty()) {
            const std::size_t node = open.front();
            open.pop();
            for (const std::size_t arc : arcs_of_[node]) {
                const std::size_t to = arcs_[arc].to;
                if (arcs_[arc].room == 0 || to == source || came_by[to] != kNone) continue;
                came_by[to] = arc;
                open.push(to);
            }
        }
        return came_by;
    }

    void push(const std::vector<std::size_t>& came_by, std::size_t source, std::size_t sink) {
        const auto before = [&](std::size_t node) { return arcs_[came_by[node] ^ 1].to; };
        std::int64_t room = kNoLimit;
        for (std::size_t node = sink; node != source; node = before(node))
            room = std::min(room, arcs_[came_by[node]].room);
        for (std::size_t node = sink; node != source; node = before(node)) {
            arcs_[came_by[node]].room -= room;
            arcs_[came_by[node] ^ 1].room += room;
        }
    }

    std::vector<NetworkArc> arcs_;
    std::vector<std::vector<std::size_t>> arcs_of_;
};

}  // namespace

std::vector<bool> bestClosure(const std::vector<Takeable>& all) {
    double most = 0;
    for (const Takeable& one : all)
        most = std::max(most, std::abs(one.gain));
    if (most <= 0) return std::vector<bool>(all.size(), false);
    const std::size_t source = all.size();
    const std::size_t sink = source + 1;
    Network network(sink + 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto units = static_cast<std::int64_t>(std::llround(all[i].gain / (kGainUnit * most)));
        if (units > 0) network.connect(source, i, units);
        if (units < 0) network.connect(i, sink, -units);
        for (const std::size_t other : all[i].needs)
            network.connect(i, other, kNoLimit);
    }
    std::vector<bool> taken = network.fill(source, sink);
    taken.resize(all.size());
    return taken;
}

}  // namespace stepmill
