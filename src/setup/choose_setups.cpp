// Which ways up the part is machined, in which order, and from what.

#include <algorithm>
#include <iterator>
#include <optional>

#include "setup/candidates.h"
#include "setup/containment.h"
#include "setup/cover.h"
#include "setup/frame.h"
#include "setup/order.h"
#include "setup/ray_tree.h"
#include "setup/solid_stock.h"
#include "stepmill/core/error.h"
#include "stepmill/part/part_shape.h"
#include "stepmill/part/square_up.h"

namespace stepmill {

namespace {

/// Of axes that reach the same, the one over the stock's largest side is best held; less than any volume.
constexpr double kFootprintBonus = 0.01;

/// Stock below the part is there to be held and then faced off, which pays for a setup whatever else reaches
/// it: from the sides it is a deep profile. In setups.
constexpr double kTurnOverBonus = 1;

/// What an indexed axis costs over one along the box, in setups: it takes a sine vise and a datum more.
constexpr int kIndexedCost = 1;

/// Sets that see less than the chosen one by more than what pays for so many setups leave too much, whatever
/// the plan; of less sight is no judge.
constexpr double kSeesAlikeSetups = 2;

Box3 boxOfPoints(const setup::Facets& facets, const Eigen::Matrix3d& rotation) {
    Box3 box;
    for (const setup::Facet& facet : facets)
        for (const Vec3& p : facet)
            box.extend(Vec3(rotation * p));
    return box;
}

bool isBoxDirection(const Vec3& axis) {
    return axis == setup::nearestBoxDirection(axis);
}

/// The stock seen along an axis: exact for box directions, else from its shape.
Box3 turnedStock(const Stock& stock, const Vec3& axis, const setup::Facets& stock_facets) {
    const Eigen::Matrix3d rotation = setup::rotationFor(axis);
    if (isBoxDirection(axis) || stock.kind == Stock::Kind::Box)
        return setup::turnedBox(stock.bbox_mm, rotation);
    return boxOfPoints(stock_facets, rotation);
}

/// Of a place under the highest point of the stock's box along an axis.
double depthMm(const Vec3& at, const Vec3& axis, const Stock& stock) {
    const Vec3 highest = (axis.array() > 0).select(stock.bbox_mm.max(), stock.bbox_mm.min());
    return axis.dot(highest - at);
}

void placeOn(Setup& setup, const Box3& turned) {
    setup.part_to_setup = setup::frameFor(setup.axis, turned);
    const Vec3 size = turned.sizes();
    setup.stock_bbox_mm = Box3(Vec3(0, 0, -size.z()), Vec3(size.x(), size.y(), 0));
}

/// Makes setups for one part and one request; holds the facets that all directions share.
class SetupMaker {
  public:
    SetupMaker(const Part& part, const SetupRequest& request) : part_(part), request_(request) {
        STEPMILL_CHECK(part.shape, "a part to set up has a shape");
        mesh_ = setup::coarseFaceFacets(part.shape->solid);
        if (!request.stock_part) return;
        stock_part_ = turnedLike(*request.stock_part, part);
        setup::checkContained(part, mesh_.facets, *stock_part_);
        stock_facets_ = setup::coarseFacets(stock_part_->shape->solid);
    }

    std::vector<Setup> asked() const {
        const Stock stock = stockFor(request_.axes.front());
        std::vector<Setup> setups;
        for (const Vec3& axis : request_.axes)
            setups.push_back(make(setup::cleanAxis(axis), stock));
        return setups;
    }

    std::vector<Setup> chosen() const {
        const std::vector<Vec3> axes = setup::candidateAxes(part_, request_.forbidden);
        // Which side gets the top margin depends on the first axis, and that on the stock: ask again once.
        // Margins are told for the first axis, so it stays first.
        std::vector<int> order = orderOf(reachOf(axes, stockFor(axes.front()), std::nullopt));
        const int first = order.front();
        Stock stock = stockFor(axes[first]);
        const bool turned = !stock.bbox_mm.isApprox(stockFor(axes.front()).bbox_mm);
        if (turned || request_.margin.bottom_mm > 0) {
            order = orderOf(reachOf(axes, stock, axes[first]));
            const auto found = std::find(order.begin(), order.end(), first);
            if (found != order.end())
                std::rotate(order.begin(), found, found + 1);
            else
                stock = stockFor(axes[order.front()]);
        }
        return along(order, axes, stock);
    }

    /// \pre `taken` is what chosen() gave
    OtherSetups others(const std::vector<Setup>& taken) const {
        const std::vector<Vec3> axes = setup::candidateAxes(part_, request_.forbidden);
        const Stock& stock = taken.front().stock;
        const AxesReach reach = reachOf(axes, stock, taken.front().axis);
        std::vector<int> order;
        std::transform(taken.begin(), taken.end(), std::back_inserter(order),
                       [&](const Setup& setup) { return indexOf(setup.axis, axes); });
        const std::vector<int> least_steps =
            setup::machiningOrder(reach.groups, order, reach.traits, setup::OrderBy::LeastSteps);
        std::vector<std::vector<int>> found = withoutOneOf(order, reach);
        for (std::vector<int>& other : setup::otherOrders(order, reach.traits))
            if (std::find(found.begin(), found.end(), other) == found.end())
                found.push_back(std::move(other));
        // Stock over the part is told for the first axis.
        const auto is_on_stock = [&](const std::vector<int>& other) {
            return stockFor(axes[other.front()]).bbox_mm.isApprox(stock.bbox_mm);
        };
        OtherSetups sets;
        if (least_steps != order && is_on_stock(least_steps))
            sets.least_steps = along(least_steps, axes, stock);
        for (const std::vector<int>& other : found)
            if (other != order && other != least_steps && is_on_stock(other))
                sets.further.push_back(along(other, axes, stock));
        return sets;
    }

    std::vector<AddedSetup> withOneMore(const std::vector<Setup>& setups,
                                        const std::vector<UnreachedPlace>& places) const {
        const Stock& stock = setups.front().stock;
        const setup::RayTree tree(mesh_.facets);
        std::vector<AddedSetup> found;
        for (const Vec3& axis : setup::candidateAxes(part_, request_.forbidden)) {
            const auto is_along = [&](const Setup& setup) { return isSameAxis(setup.axis, axis); };
            if (!isBoxDirection(axis) || std::any_of(setups.begin(), setups.end(), is_along)) continue;
            double free_mm3 = 0;
            for (const UnreachedPlace& place : places) {
                const bool nearer = depthMm(place.at, axis, stock) < depthMm(place.at, place.axis, stock);
                if (nearer && !tree.blocked(place.at, axis)) free_mm3 += place.volume_mm3;
            }
            if (free_mm3 <= 0) continue;
            found.push_back({setups, free_mm3});
            found.back().setups.push_back(make(axis, stock));
            found.back().setups.back().chosen = true;
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const AddedSetup& a, const AddedSetup& b) { return a.free_mm3 > b.free_mm3; });
        return found;
    }

  private:
    /// What is known of the axes when some of them are chosen.
    struct AxesReach {
        std::vector<setup::SampleGroup> groups;
        std::vector<double> bonus;
        std::vector<setup::SetupTraits> traits;
    };

    /// \param first  axis of the first setup, where it is known
    AxesReach reachOf(const std::vector<Vec3>& axes, const Stock& stock,
                      const std::optional<Vec3>& first) const {
        AxesReach reach{
            setup::sampleReach(part_, mesh_, stock, stock_facets_, axes), bonusOf(stock, axes), {}};
        if (first && request_.margin.bottom_mm > 0) addTurnOver(axes, *first, reach.bonus);
        for (const Vec3& axis : axes) {
            reach.traits.push_back(setup::traitsOf(mesh_.facets, stock, axis));
            reach.traits.back().indexed = !isBoxDirection(axis);
        }
        return reach;
    }

    std::vector<int> orderOf(const AxesReach& reach) const {
        std::vector<int> best = setup::bestAxes(reach.groups, reach.bonus, request_.steps_finished);
        if (best.empty()) best = {0};
        return setup::machiningOrder(reach.groups, std::move(best), reach.traits);
    }

    /// The sets chosen where one of these axes is none, as far as they cost no more and see about as much.
    std::vector<std::vector<int>> withoutOneOf(const std::vector<int>& order, const AxesReach& reach) const {
        const double seen = setup::worthSeen(order, reach.groups);
        const int cost = costOf(order, reach);
        std::vector<std::vector<int>> found;
        for (const int left_out : order) {
            AxesReach less = reach;
            for (setup::SampleGroup& group : less.groups)
                group.reach[left_out] = setup::Reach::None;
            std::vector<int> other = orderOf(less);
            if (costOf(other, reach) > cost) continue;
            if (seen - setup::worthSeen(other, less.groups) > kSeesAlikeSetups) continue;
            if (std::find(found.begin(), found.end(), other) == found.end())
                found.push_back(std::move(other));
        }
        std::stable_sort(found.begin(), found.end(),
                         [&](const auto& a, const auto& b) { return costOf(a, reach) < costOf(b, reach); });
        return found;
    }

    /// In setups.
    static int costOf(const std::vector<int>& order, const AxesReach& reach) {
        int cost = 0;
        for (const int axis : order)
            cost += reach.traits[axis].indexed ? 1 + kIndexedCost : 1;
        return cost;
    }

    static int indexOf(const Vec3& axis, const std::vector<Vec3>& axes) {
        const auto found =
            std::find_if(axes.begin(), axes.end(), [&](const Vec3& one) { return isSameAxis(one, axis); });
        STEPMILL_CHECK(found != axes.end(), "an axis that was chosen is among those to choose from");
        return static_cast<int>(found - axes.begin());
    }

    std::vector<Setup> along(const std::vector<int>& order, const std::vector<Vec3>& axes,
                             const Stock& stock) const {
        std::vector<Setup> setups;
        for (const int index : order) {
            setups.push_back(make(axes[index], stock));
            setups.back().chosen = true;
        }
        return setups;
    }

    Stock stockFor(const Vec3& axis) const {
        Stock stock = stock_part_ ? setup::stepStock(*stock_part_)
                                  : setup::boxStock(part_, request_, setup::cleanAxis(axis));
        if (!stock_part_) setup::addBoxShape(stock);
        stock.tolerance_mm = request_.stock_tolerance_mm;
        return stock;
    }

    std::vector<double> bonusOf(const Stock& stock, const std::vector<Vec3>& axes) const {
        std::vector<double> bonus;
        for (const Vec3& axis : axes) {
            const Vec3 size = turnedStock(stock, axis, stock_facets_).sizes();
            bonus.push_back(isBoxDirection(axis) ? size.x() * size.y() : 0);
        }
        const double largest = *std::max_element(bonus.begin(), bonus.end());
        for (double& value : bonus)
            value *= largest > 0 ? kFootprintBonus / largest : 0;
        for (std::size_t i = 0; i < axes.size(); ++i)
            if (!isBoxDirection(axes[i])) bonus[i] -= kIndexedCost;
        return bonus;
    }

    static void addTurnOver(const std::vector<Vec3>& axes, const Vec3& first, std::vector<double>& bonus) {
        for (std::size_t i = 0; i < axes.size(); ++i)
            if (isSameAxis(axes[i], first) || isSameAxis(axes[i], -first)) bonus[i] += kTurnOverBonus;
    }

    Setup make(const Vec3& axis, const Stock& stock) const {
        Setup made;
        made.axis = axis;
        made.part = part_;
        made.stock = stock;
        made.removable_mm3 = stock.volume_mm3 - part_.volume_mm3;
        made.indexed = !isBoxDirection(axis);
        placeOn(made, turnedStock(stock, axis, stock_facets_));
        return made;
    }

    const Part& part_;
    const SetupRequest& request_;
    setup::FaceFacets mesh_;
    std::optional<Part> stock_part_;  ///< in part coordinates; nothing: a box
    setup::Facets stock_facets_;
};

std::vector<Setup> numbered(std::vector<Setup> setups) {
    for (std::size_t i = 0; i < setups.size(); ++i)
        setups[i].id = "S" + std::to_string(i + 1);
    return setups;
}

}  // namespace

std::vector<Setup> chooseSetups(const Part& part, const SetupRequest& request) {
    const SetupMaker maker(part, request);
    return numbered(request.axes.empty() ? maker.chosen() : maker.asked());
}

OtherSetups otherSetups(const Part& part, const SetupRequest& request, const std::vector<Setup>& chosen) {
    OtherSetups sets = SetupMaker(part, request).others(chosen);
    sets.least_steps = numbered(std::move(sets.least_steps));
    for (std::vector<Setup>& setups : sets.further)
        setups = numbered(std::move(setups));
    return sets;
}

std::vector<AddedSetup> withOneMore(const Part& part, const SetupRequest& request,
                                    const std::vector<Setup>& setups,
                                    const std::vector<UnreachedPlace>& places) {
    if (places.empty()) return {};  // as after most plans: the part needs no facets for that
    std::vector<AddedSetup> sets = SetupMaker(part, request).withOneMore(setups, places);
    for (AddedSetup& added : sets)
        added.setups = numbered(std::move(added.setups));
    return sets;
}

Setup onStock(const Setup& setup, const Stock& stock) {
    Setup moved = setup;
    moved.stock = stock;
    const bool box_direction = isBoxDirection(setup.axis);
    placeOn(moved, turnedStock(stock, setup.axis,
                               box_direction ? setup::Facets{} : setup::coarseFacets(stock.shape->solid)));
    return moved;
}

}  // namespace stepmill
