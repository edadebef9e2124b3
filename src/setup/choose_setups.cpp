// Which ways up the part is machined, in which order, and from what.

#include <algorithm>
#include <optional>

#include "setup/candidates.h"
#include "setup/containment.h"
#include "setup/cover.h"
#include "setup/frame.h"
#include "setup/order.h"
#include "setup/solid_stock.h"
#include "stepmill/core/error.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {

namespace {

/// Of axes that reach the same, the one over the stock's largest side is best held; less than any volume.
constexpr double kFootprintBonus = 0.01;

/// Stock below the part is there to be held and then faced off: the first setup's axis and the one it is
/// turned over to are chosen unless others do that much more, in setups.
constexpr double kTurnOverBonus = 0.5;

/// What an indexed axis costs over one along the box, in setups: it takes a sine vise and a datum more.
constexpr double kIndexedCost = 1;

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
        setup::checkContained(part, mesh_.facets, *request.stock_part);
        stock_facets_ = setup::coarseFacets(request.stock_part->shape->solid);
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
        Choice choice = choose(axes, stockFor(axes.front()), std::nullopt);
        const int first = choice.order.front();
        Stock stock = stockFor(axes[first]);
        const bool turned = !stock.bbox_mm.isApprox(stockFor(axes.front()).bbox_mm);
        if (turned || request_.margin.bottom_mm > 0) {
            choice = choose(axes, stock, axes[first]);
            const auto found = std::find(choice.order.begin(), choice.order.end(), first);
            if (found != choice.order.end())
                std::rotate(choice.order.begin(), found, found + 1);
            else
                stock = stockFor(axes[choice.order.front()]);
        }
        std::vector<Setup> setups;
        for (const int index : choice.order) {
            setups.push_back(make(axes[index], stock));
            setups.back().chosen = true;
        }
        return setups;
    }

  private:
    struct Choice {
        std::vector<setup::SampleGroup> groups;
        std::vector<int> order;  ///< indices of axes
    };

    /// \param first  axis of the first setup, where it is known
    Choice choose(const std::vector<Vec3>& axes, const Stock& stock, const std::optional<Vec3>& first) const {
        Choice choice;
        choice.groups = setup::sampleReach(part_, mesh_, stock, stock_facets_, axes);
        std::vector<double> bonus = bonusOf(stock, axes);
        if (first && request_.margin.bottom_mm > 0) addTurnOver(axes, *first, bonus);
        std::vector<int> best = setup::bestAxes(choice.groups, bonus, request_.steps_finished);
        if (best.empty()) best = {0};
        std::vector<setup::SetupTraits> traits;
        for (const Vec3& axis : axes) {
            traits.push_back(setup::traitsOf(mesh_.facets, stock, axis));
            traits.back().indexed = !isBoxDirection(axis);
        }
        choice.order = setup::machiningOrder(choice.groups, std::move(best), traits);
        return choice;
    }

    Stock stockFor(const Vec3& axis) const {
        Stock stock = request_.stock_part ? setup::stepStock(*request_.stock_part)
                                          : setup::boxStock(part_, request_, setup::cleanAxis(axis));
        if (!request_.stock_part) setup::addBoxShape(stock);
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
            if (axes[i].isApprox(first) || axes[i].isApprox(-first)) bonus[i] += kTurnOverBonus;
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
    setup::Facets stock_facets_;
};

}  // namespace

std::vector<Setup> chooseSetups(const Part& part, const SetupRequest& request) {
    const SetupMaker maker(part, request);
    std::vector<Setup> setups = request.axes.empty() ? maker.chosen() : maker.asked();
    for (std::size_t i = 0; i < setups.size(); ++i)
        setups[i].id = "S" + std::to_string(i + 1);
    return setups;
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
