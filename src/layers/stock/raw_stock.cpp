// The solid a stock was before anything was cut from it.

#include "layers/stock/raw_stock.h"

#include "stepmill/core/error.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::layers {
namespace {

bool isUprightBox(const Setup& setup) {
    if (setup.stock.kind != Stock::Kind::Box) return false;
    const Eigen::Matrix3d r = setup.part_to_setup.linear().cwiseAbs();
    return (r.array() * (1 - r.array())).matrix().norm() < 1e-12;
}

}  // namespace

RawStock::RawStock(const Setup& setup, const Tolerances& tol) {
    if (isUprightBox(setup)) {
        const Box3& box = setup.stock_bbox_mm;
        box_ = makeRectangle(box.min().head<2>(), box.max().head<2>());
        return;
    }
    STEPMILL_CHECK(setup.stock.shape, "a stock other than an upright box has a shape");
    mesh_.emplace(setup.stock.shape->solid, setup.part_to_setup, facetChord(setup.stock.bbox_mm), tol);
}

}  // namespace stepmill::layers
