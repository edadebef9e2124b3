// Which way up the part is machined, and from what.

#include <BRepPrimAPI_MakeBox.hxx>

#include "setup/containment.h"
#include "setup/frame.h"
#include "setup/reach.h"
#include "stepmill/core/error.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {

namespace {

/// Boxes come out of OCCT with 1e-7 mm of its own tolerance around them; that would make every coordinate
/// of the setup odd. Rounding to a micrometre's thousandth removes it where the part's size is round.
Box3 tidyBox(const Box3& box) {
    const auto tidy = [](double v) {
        const double rounded = std::round(v * 1e6) / 1e6 + 0.0;
        return std::abs(rounded - v) < 2.5e-7 ? rounded : v;
    };
    return Box3(box.min().unaryExpr(tidy), box.max().unaryExpr(tidy));
}

/// The part's box with margins, top and bottom along the axis (for other axes than box directions, along
/// the nearest of these).
Stock boxStock(const Part& part, const StockMargin& margin, const Vec3& axis) {
    Stock stock;
    stock.bbox_mm = tidyBox(part.bbox_mm);
    const Vec3 up = setup::nearestBoxDirection(axis);
    for (int i = 0; i < 3; ++i) {
        const bool along = up[i] != 0;
        stock.bbox_mm.min()[i] -= !along ? margin.side_mm : (up[i] > 0 ? margin.bottom_mm : margin.top_mm);
        stock.bbox_mm.max()[i] += !along ? margin.side_mm : (up[i] > 0 ? margin.top_mm : margin.bottom_mm);
    }
    stock.volume_mm3 = stock.bbox_mm.volume();
    return stock;
}

void addBoxShape(Stock& stock) {
    const Vec3& lo = stock.bbox_mm.min();
    const Vec3& hi = stock.bbox_mm.max();
    guardOcct(ErrorCode::GeometryKernel, "box stock", [&] {
        const gp_Pnt from(lo.x(), lo.y(), lo.z());
        const gp_Pnt to(hi.x(), hi.y(), hi.z());
        stock.shape = std::make_shared<PartShape>(PartShape{BRepPrimAPI_MakeBox(from, to).Solid()});
    });
}

Stock stepStock(const Part& stock_part) {
    Stock stock;
    stock.kind = Stock::Kind::Step;
    stock.bbox_mm = tidyBox(stock_part.bbox_mm);
    stock.volume_mm3 = stock_part.volume_mm3;
    stock.shape = stock_part.shape;
    return stock;
}

/// Makes setups for one part and one request; holds the facets that all directions share.
class SetupMaker {
  public:
    SetupMaker(const Part& part, const SetupRequest& request) : part_(part), request_(request) {
        STEPMILL_CHECK(part.shape, "a part to set up has a shape");
        facets_ = setup::coarseFacets(part.shape->solid);
        if (!request.stock_part) return;
        setup::checkContained(part, facets_, *request.stock_part);
        stock_facets_ = setup::coarseFacets(request.stock_part->shape->solid);
    }

    Setup make(const Vec3& asked_axis) const {
        Setup made;
        made.axis = setup::cleanAxis(asked_axis);
        made.stock = request_.stock_part ? stepStock(*request_.stock_part)
                                         : boxStock(part_, request_.margin, made.axis);
        const Eigen::Matrix3d rotation = setup::rotationFor(made.axis);
        const bool box_direction = made.axis == setup::nearestBoxDirection(made.axis);
        const bool upright_box = made.stock.kind == Stock::Kind::Box && box_direction;
        const setup::Facets tilted_box =
            upright_box || request_.stock_part ? setup::Facets{} : boxFacets(made.stock);
        const setup::Facets& stock_facets = request_.stock_part ? stock_facets_ : tilted_box;
        const Box3 turned =
            box_direction ? setup::turnedBox(made.stock.bbox_mm, rotation) : tightBox(stock_facets, rotation);
        made.part_to_setup = setup::frameFor(made.axis, turned);
        made.stock_bbox_mm =
            Box3(Vec3(0, 0, -turned.sizes().z()), Vec3(turned.sizes().x(), turned.sizes().y(), 0));
        made.reachable_share = setup::reachableShare(facets_, stock_facets, rotation, turned,
                                                     made.stock.volume_mm3 - part_.volume_mm3);
        return made;
    }

  private:
    static setup::Facets boxFacets(Stock stock) {
        addBoxShape(stock);
        return setup::coarseFacets(stock.shape->solid);
    }

    static Box3 tightBox(const setup::Facets& facets, const Eigen::Matrix3d& rotation) {
        Box3 box;
        for (const auto& facet : facets)
            for (const Vec3& p : facet)
                box.extend(Vec3(rotation * p));
        return box;
    }

    const Part& part_;
    const SetupRequest& request_;
    setup::Facets facets_;
    setup::Facets stock_facets_;
};

std::vector<Vec3> boxDirections() {
    return {Vec3::UnitZ(), -Vec3::UnitZ(), Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY()};
}

Setup bestOf(const SetupMaker& maker, const std::vector<Vec3>& axes) {
    // Shares closer than the height map resolves are ties, and the first direction wins.
    constexpr double kTie = 2e-3;
    Setup best = maker.make(axes.front());
    for (std::size_t i = 1; i < axes.size(); ++i) {
        Setup candidate = maker.make(axes[i]);
        if (candidate.reachable_share > best.reachable_share + kTie) best = std::move(candidate);
    }
    return best;
}

}  // namespace

std::vector<Setup> chooseSetups(const Part& part, const SetupRequest& request) {
    const SetupMaker maker(part, request);
    std::vector<Setup> setups;
    if (request.axes.empty()) setups.push_back(bestOf(maker, boxDirections()));
    for (const Vec3& axis : request.axes)
        setups.push_back(maker.make(axis));
    for (std::size_t i = 0; i < setups.size(); ++i) {
        Setup& made = setups[i];
        made.id = "S" + std::to_string(i + 1);
        made.part = part;
        if (made.stock.kind == Stock::Kind::Box) addBoxShape(made.stock);
    }
    return setups;
}

}  // namespace stepmill
