// Stocks from boxes and files.

#include "setup/solid_stock.h"

#include <algorithm>
#include <cmath>

#include <BRepPrimAPI_MakeBox.hxx>

#include "setup/frame.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::setup {

namespace {

/// A size this little over one that there is is that one: sums of lengths are rounded [mm].
constexpr double kSawnMm = 1e-6;

/// Boxes come out of OCCT with 1e-7 mm of its own tolerance around them; that would make every coordinate
/// of the setup odd. Rounding to a micrometre's thousandth removes it where the part's size is round.
Box3 tidyBox(const Box3& box) {
    const auto tidy = [](double v) {
        const double rounded = std::round(v * 1e6) / 1e6 + 0.0;
        return std::abs(rounded - v) < 2.5e-7 ? rounded : v;
    };
    return Box3(box.min().unaryExpr(tidy), box.max().unaryExpr(tidy));
}

}  // namespace

namespace {

double sawn(double size_mm, const std::vector<double>& sizes_mm) {
    const auto fits = std::lower_bound(sizes_mm.begin(), sizes_mm.end(), size_mm - kSawnMm);
    return fits != sizes_mm.end() ? *fits : std::ceil(size_mm - kSawnMm);
}

/// Rounds the box up to what can be sawn; what is more goes below the part, and of other sides half each.
void roundUp(Box3& box, const std::vector<double>& sizes_mm, const Vec3& up) {
    Eigen::Index longest = 0;
    box.sizes().maxCoeff(&longest);
    for (int i = 0; i < 3; ++i) {
        const double size_mm = box.sizes()[i];
        const double more_mm = sawn(size_mm, i == longest ? std::vector<double>{} : sizes_mm) - size_mm;
        const double below = up[i] > 0 ? 1 : up[i] < 0 ? 0 : 0.5;
        box.min()[i] -= below * more_mm;
        box.max()[i] += (1 - below) * more_mm;
    }
}

}  // namespace

Stock boxStock(const Part& part, const SetupRequest& request, const Vec3& axis) {
    const StockMargin& margin = request.margin;
    Stock stock;
    stock.bbox_mm = tidyBox(part.bbox_mm);
    const Vec3 up = nearestBoxDirection(axis);
    for (int i = 0; i < 3; ++i) {
        const bool along = up[i] != 0;
        stock.bbox_mm.min()[i] -= !along ? margin.side_mm : (up[i] > 0 ? margin.bottom_mm : margin.top_mm);
        stock.bbox_mm.max()[i] += !along ? margin.side_mm : (up[i] > 0 ? margin.top_mm : margin.bottom_mm);
    }
    if (!request.stock_sizes_mm.empty()) roundUp(stock.bbox_mm, request.stock_sizes_mm, up);
    stock.raw_bbox_mm = stock.bbox_mm;
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
    stock.raw_bbox_mm = stock.bbox_mm;
    stock.volume_mm3 = stock_part.volume_mm3;
    stock.shape = stock_part.shape;
    return stock;
}

}  // namespace stepmill::setup
