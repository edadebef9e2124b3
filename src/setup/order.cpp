// Which setup comes first.

#include "setup/order.h"

namespace stepmill::setup {

namespace {

/// Setups within this share of the best one's volume are as good as it.
constexpr double kSameVolume = 0.1;
/// A setup that leaves steps on less than this share of the volume spoils nothing.
constexpr double kSpoilsShare = 0.02;
/// Depths within this share are alike.
constexpr double kSameDepth = 0.05;
/// Seats must differ by more than this share to decide.
constexpr double kSameSeat = 0.01;
/// The seat's facets lie this near the part's lowest point [mm].
constexpr double kSeatMm = 1e-3;

bool isOpposite(const SetupTraits& a, const SetupTraits& b) {
    return isSameAxis(a.axis, -b.axis);
}

/// A setup from the other side machines the seat as a floor, one across it as a wall.
bool isSeatReady(const SetupTraits& own, const std::vector<int>& earlier,
                 const std::vector<SetupTraits>& traits) {
    if (own.seat_mm2 <= 0) return false;
    if (own.seat_is_stock) return true;
    return std::any_of(earlier.begin(), earlier.end(), [&](int axis) {
        return std::abs(traits[axis].axis.dot(own.axis)) < kUprightSine || isOpposite(traits[axis], own);
    });
}

/// How many axes after the first come before their seat is machined?
int seatsNotReady(const std::vector<int>& order, const std::vector<SetupTraits>& traits) {
    int count = 0;
    for (auto axis = order.begin() + 1; axis < order.end(); ++axis)
        count += isSeatReady(traits[*axis], {order.begin(), axis}, traits) ? 0 : 1;
    return count;
}

class Orderer {
  public:
    Orderer(const std::vector<SampleGroup>& groups, const std::vector<int>& chosen,
            const std::vector<SetupTraits>& traits)
        : groups_(groups), traits_(traits), done_(groups.size(), false) {
        for (const SampleGroup& group : groups) {
            int best = -1;
            for (const int axis : chosen)
                if (best < 0 || isBetter(group, axis, best)) best = axis;
            owner_.push_back(best >= 0 && group.reach[best] != Reach::None ? best : -1);
        }
    }

    int next(const std::vector<int>& open, OrderBy by) const {
        std::vector<int> among = open;
        prefer(among, [&](int axis) { return !traits_[axis].indexed; });
        if (!order_.empty()) prefer(among, [&](int axis) { return isSeatReady(axis); });
        if (by == OrderBy::LeastSteps) preferLeastSteps(among, open);
        double most = 0;
        for (const int axis : among)
            most = std::max(most, left(axis));
        prefer(among, [&](int axis) { return left(axis) >= (1 - kSameVolume) * most; });
        double largest = 0;
        for (const int axis : among)
            largest = std::max(largest, traits_[axis].seat_mm2);
        prefer(among, [&](int axis) { return traits_[axis].seat_mm2 >= (1 - kSameSeat) * largest; });
        return among.front();
    }

    void take(int axis) {
        order_.push_back(axis);
        for (std::size_t g = 0; g < groups_.size(); ++g)
            done_[g] = done_[g] || groups_[g].reach[axis] != Reach::None;
    }

    const std::vector<int>& order() const { return order_; }

  private:
    template <typename Test>
    static void prefer(std::vector<int>& axes, Test test) {
        if (std::any_of(axes.begin(), axes.end(), test)) std::erase_if(axes, std::not_fn(test));
    }

    static bool isBetter(const SampleGroup& group, int axis, int other) {
        if (group.reach[axis] != group.reach[other]) return group.reach[axis] > group.reach[other];
        return group.depth_mm[axis] < (1 - kSameDepth) * group.depth_mm[other];
    }

    /// What of the volume to be removed is left to the axis and was not reached by an earlier one.
    double left(int axis) const {
        double share = 0;
        for (std::size_t g = 0; g < groups_.size(); ++g)
            if (!done_[g] && owner_[g] == axis) share += groups_[g].volume_share;
        return share;
    }

    void preferLeastSteps(std::vector<int>& among, const std::vector<int>& open) const {
        double least = 1;
        for (const int axis : among)
            least = std::min(least, stepsBefore(axis, open));
        prefer(among, [&](int axis) { return stepsBefore(axis, open) <= least + kSpoilsShare; });
    }

    /// What of the volume the axis would leave steps on where a later one finishes it.
    double stepsBefore(int axis, const std::vector<int>& open) const {
        double share = 0;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const int owner = owner_[g];
            const bool later = owner != axis && std::find(open.begin(), open.end(), owner) != open.end();
            if (!done_[g] && later && groups_[g].reach[axis] == Reach::Steps &&
                groups_[g].reach[owner] == Reach::Finished)
                share += groups_[g].volume_share;
        }
        return share;
    }

    bool isSeatReady(int axis) const { return setup::isSeatReady(traits_[axis], order_, traits_); }

    const std::vector<SampleGroup>& groups_;
    const std::vector<SetupTraits>& traits_;
    std::vector<int> owner_;  ///< by group: the axis best suited, or -1
    std::vector<bool> done_;
    std::vector<int> order_;
};

}  // namespace

SetupTraits traitsOf(const Facets& part_facets, const Stock& stock, const Vec3& axis) {
    SetupTraits traits;
    traits.axis = axis;
    double part_low = 1e300;
    for (const Facet& facet : part_facets)
        for (const Vec3& p : facet)
            part_low = std::min(part_low, axis.dot(p));
    for (const Facet& facet : part_facets) {
        const Vec3 across = (facet[1] - facet[0]).cross(facet[2] - facet[0]) / 2;
        const bool lowest = std::all_of(facet.begin(), facet.end(),
                                        [&](const Vec3& p) { return axis.dot(p) < part_low + kSeatMm; });
        if (lowest && across.dot(axis) < 0) traits.seat_mm2 += across.norm();
    }
    double stock_low = 1e300;
    for (int corner = 0; corner < 8; ++corner)
        stock_low =
            std::min(stock_low, axis.dot(stock.bbox_mm.corner(static_cast<Box3::CornerType>(corner))));
    traits.seat_is_stock = part_low < stock_low + kSeatMm;
    return traits;
}

std::vector<int> machiningOrder(const std::vector<SampleGroup>& groups, std::vector<int> chosen,
                                const std::vector<SetupTraits>& traits, OrderBy by) {
    Orderer orderer(groups, chosen, traits);
    while (!chosen.empty()) {
        const int axis = orderer.next(chosen, by);
        orderer.take(axis);
        std::erase(chosen, axis);
    }
    return orderer.order();
}

std::vector<std::vector<int>> otherOrders(const std::vector<int>& order,
                                          const std::vector<SetupTraits>& traits) {
    std::vector<std::vector<int>> others;
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const SetupTraits& earlier = traits[order[i]];
            const SetupTraits& later = traits[order[j]];
            if (!isOpposite(earlier, later) && j > 1) continue;
            if (earlier.indexed != later.indexed) continue;
            std::vector<int> other = order;
            std::swap(other[i], other[j]);
            if (seatsNotReady(other, traits) <= seatsNotReady(order, traits))
                others.push_back(std::move(other));
        }
    }
    return others;
}

}  // namespace stepmill::setup
