// The stock a setup leaves to the next one.

#include "stepmill/layers/stock_after.h"

#include <algorithm>
#include <optional>
#include <set>

#include "layers/section/section.h"
#include "layers/stock/raw_stock.h"
#include "layers/stock/stock_air.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {

namespace {

/// Less than this removed is nothing [mm3].
constexpr double kNothingMm3 = 1e-3;
/// The stock's box ends where what stands is thicker than this [mm]: rounding leaves films.
constexpr double kFilmMm = 0.01;

/// What is taken from a layer is integrated over at most as many stretches between bends of earlier cuts.
constexpr int kTakenStretches = 32;

/// Cuts by a setup in one of its layers, between two heights where they change.
struct CutStretch {
    const Layer* layer = nullptr;
    double top_z_mm = 0;
    double bottom_z_mm = 0;
    Region gone;  ///< of the layer's stock
};

std::vector<CutStretch> stretches(const LayerStack& layers, const std::vector<Prism>& removed,
                                  const Tolerances& tol) {
    std::set<double> heights;
    for (const Prism& prism : removed)
        heights.insert({prism.top_z_mm, prism.bottom_z_mm});
    for (const Layer& layer : layers.layers)
        heights.insert({layer.top_z_mm, layer.bottom_z_mm});
    std::vector<CutStretch> found;
    std::size_t at = layers.layers.size();
    for (auto low = heights.begin(); low != heights.end() && std::next(low) != heights.end(); ++low) {
        CutStretch stretch{nullptr, *std::next(low), *low, {}};
        const double middle = (stretch.top_z_mm + stretch.bottom_z_mm) / 2;
        while (at > 0 && layers.layers[at - 1].top_z_mm <= middle)
            --at;
        if (at == 0) break;
        stretch.layer = &layers.layers[at - 1];
        if (stretch.layer->bottom_z_mm > middle) continue;
        std::vector<Region> gone;
        for (const Prism& prism : removed)
            if (prism.bottom_z_mm < middle && middle < prism.top_z_mm) gone.push_back(prism.region);
        if (!gone.empty()) stretch.gone = intersect(unite(gone, tol), stretch.layer->stock, tol);
        found.push_back(std::move(stretch));
    }
    return found;
}

/// What of the prisms' ground lies beside the raw stock, and in no earlier cut, which may reach beside it too
/// [mm3]: where its walls lean slabs hold its hull.
class RawAir {
  public:
    /// \param cuts  of the earlier setups
    RawAir(const Setup& setup, const layers::StockAir& cuts, const Tolerances& tol)
        : raw_(setup, tol), cuts_(cuts), tol_(tol) {}

    double volumeIn(const Region& gone, double bottom_mm, double top_mm) const {
        if (!raw_.mesh()) return 0;
        constexpr int kHeights = 24;
        double beside_mm3 = 0;
        for (int i = 0; i < kHeights; ++i) {
            const double z_mm = bottom_mm + (i + 0.5) / kHeights * (top_mm - bottom_mm);
            const std::optional<Region> raw = layers::exactSection(*raw_.mesh(), z_mm, tol_);
            if (!raw) continue;
            const Region beside = subtract(gone, *raw, tol_);
            beside_mm3 += (area(beside) - cuts_.areaIn(beside, z_mm)) * (top_mm - bottom_mm) / kHeights;
        }
        return beside_mm3;
    }

  private:
    layers::RawStock raw_;
    const layers::StockAir& cuts_;
    const Tolerances& tol_;
};

/// Box around what still stands, in setup coordinates.
Box3 boxOfRest(const std::vector<CutStretch>& stretches, const Tolerances& tol) {
    Box3 box;
    for (const CutStretch& stretch : stretches) {
        const Region& stock = stretch.layer->stock;
        const Region left = stretch.gone.empty() ? stock : subtract(stock, stretch.gone, tol);
        for (const Region& piece : components(left)) {
            const Box2 extent = boundingBox(piece);
            if (area(piece) <= kFilmMm * perimeter(piece) / 2) continue;
            box.extend(Vec3(extent.min().x(), extent.min().y(), stretch.bottom_z_mm));
            box.extend(Vec3(extent.max().x(), extent.max().y(), stretch.top_z_mm));
        }
    }
    return box;
}

/// The stock's box in part coordinates, as far as the setup's own box says something about it: an axis askew
/// to the part's box does not.
Box3 shrunkBox(const Box3& known, const Setup& setup, const Box3& rest) {
    if (setup.indexed || rest.isEmpty()) return known;
    const Eigen::Isometry3d to_part = setup.part_to_setup.inverse();
    Box3 turned;
    turned.extend(Vec3(to_part * rest.min()));
    turned.extend(Vec3(to_part * rest.max()));
    Box3 box = known;
    // Sides that did not move keep their exact place.
    for (int axis = 0; axis < 3; ++axis) {
        if (turned.min()[axis] > known.min()[axis] + kFilmMm) box.min()[axis] = turned.min()[axis];
        if (turned.max()[axis] < known.max()[axis] - kFilmMm) box.max()[axis] = turned.max()[axis];
    }
    return box;
}

}  // namespace

StockAfter stockAfter(const Setup& setup, const LayerStack& layers, const std::vector<Prism>& removed,
                      const Tolerances& tol) {
    StockAfter after{setup.stock, 0, 0};
    if (volumeOf(removed) < kNothingMm3) return after;
    const layers::StockAir air(setup, 0, tol);
    const RawAir raw_air(setup, air, tol);
    const std::vector<CutStretch> cut = stretches(layers, removed, tol);
    for (const CutStretch& stretch : cut) {
        if (stretch.gone.empty()) continue;
        const double height = stretch.top_z_mm - stretch.bottom_z_mm;
        after.prisms_mm3 += area(stretch.gone) * height;
        if (stretch.layer->stock_air_mm3 <= 0) continue;
        after.removed_mm3 -=
            air.volumeIn(stretch.gone, stretch.bottom_z_mm, stretch.top_z_mm, kTakenStretches) +
            raw_air.volumeIn(stretch.gone, stretch.bottom_z_mm, stretch.top_z_mm);
    }
    // The quadratures may find a little more air than there is ground.
    after.removed_mm3 = std::max(0.0, after.removed_mm3 + after.prisms_mm3);
    after.stock.volume_mm3 -= after.removed_mm3;
    after.stock.cuts.push_back({setup.part_to_setup, removed});
    after.stock.bbox_mm = shrunkBox(setup.stock.bbox_mm, setup, boxOfRest(cut, tol));
    return after;
}

}  // namespace stepmill
