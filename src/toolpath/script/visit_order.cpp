// Short ways from stop to stop.

#include "toolpath/script/visit_order.h"

#include <algorithm>
#include <numeric>

namespace stepmill::toolpath {

namespace {

using Order = std::vector<std::size_t>;

/// Ways that are shorter by less than this are the same [mm].
constexpr double kGainMm = 1e-6;
/// Stretches of up to this many stops are moved in one piece.
constexpr std::size_t kLongestStretch = 3;
/// With more stops than this the nearest next has to do: an improvement costs the square of their number.
constexpr std::size_t kMostStops = 60;
constexpr int kMostVisitRounds = 50;
/// The nearest next is tried from this many stops.
constexpr std::size_t kMostStarts = 8;

class Visit {
  public:
    explicit Visit(const std::vector<Stop>& stops) : stops_(stops) {}

    double way(const Order& order) const {
        double sum = 0;
        for (std::size_t i = 1; i < order.size(); ++i)
            sum += (stops_[order[i]].in - stops_[order[i - 1]].out).norm();
        return sum;
    }

    Order nearestNext(std::size_t first) const {
        Order left(stops_.size());
        std::iota(left.begin(), left.end(), std::size_t{0});
        Order order{first};
        left.erase(left.begin() + index(first));
        while (!left.empty()) {
            const Vec2& from = stops_[order.back()].out;
            const auto next = std::min_element(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
                return (stops_[a].in - from).norm() < (stops_[b].in - from).norm();
            });
            order.push_back(*next);
            left.erase(next);
        }
        return order;
    }

    bool improve(Order& order) const {
        bool any = false;
        for (std::size_t i = 0; i < order.size(); ++i)
            for (std::size_t j = i + 1; j < order.size(); ++j) {
                Order turned = order;
                std::reverse(turned.begin() + index(i), turned.begin() + index(j) + 1);
                any = takeIfShorter(order, std::move(turned)) || any;
            }
        for (std::size_t size = 1; size <= std::min(kLongestStretch, order.size() - 1); ++size)
            for (std::size_t from = 0; from + size <= order.size(); ++from)
                for (std::size_t to = 0; to + size <= order.size(); ++to)
                    any = takeIfShorter(order, moved(order, from, size, to)) || any;
        return any;
    }

  private:
    static std::ptrdiff_t index(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

    static Order moved(const Order& order, std::size_t from, std::size_t size, std::size_t to) {
        Order rest = order;
        const Order stretch(rest.begin() + index(from), rest.begin() + index(from + size));
        rest.erase(rest.begin() + index(from), rest.begin() + index(from + size));
        rest.insert(rest.begin() + index(to), stretch.begin(), stretch.end());
        return rest;
    }

    bool takeIfShorter(Order& order, Order other) const {
        if (way(other) >= way(order) - kGainMm) return false;
        order = std::move(other);
        return true;
    }

    const std::vector<Stop>& stops_;
};

}  // namespace

std::vector<std::size_t> visitOrder(const std::vector<Stop>& stops) {
    Order given(stops.size());
    std::iota(given.begin(), given.end(), std::size_t{0});
    if (stops.size() < 3) return given;
    const Visit visit(stops);
    Order best = given;
    for (std::size_t first = 0; first < std::min(stops.size(), kMostStarts); ++first) {
        Order order = visit.nearestNext(first);
        if (stops.size() <= kMostStops)
            for (int round = 0; round < kMostVisitRounds && visit.improve(order); ++round) {
            }
        if (visit.way(order) < visit.way(best) - kGainMm) best = std::move(order);
    }
    return best;
}

}  // namespace stepmill::toolpath
