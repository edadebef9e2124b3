#include "plan/assignment/shared_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "stepmill/feature/heights.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/layers/reserve.h"
#include "stepmill/layers/section_cutter.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/wider_than.h"

namespace stepmill {
namespace {

/// A later band with more corners adds only the ends of its extent to the heights where layers part.
constexpr std::size_t kMostCorners = 40;

bool holdsLayer(const Feature& feature, const Layer& layer) {
    return layer.isWithin(feature.top_z_mm, feature.floor_z_mm);
}

double perVolume(const LateBand& band) {
    return band.feature.volume_mm3 > 0 ? band.weight / band.feature.volume_mm3 : 0;
}

/// Heights at which a later band begins, ends or turns, seen from the earlier setup.
std::vector<double> heightsOf(const LateBand& band, const Setup& setup) {
    const Eigen::Isometry3d to_setup = setup.part_to_setup * band.part_to_setup.inverse();
    std::vector<double> heights;
    for (const auto& [from, segment] : eachEdge(band.feature.target))
        for (const double z_mm : {band.feature.top_z_mm, band.feature.floor_z_mm})
            heights.push_back((to_setup * Vec3(from.x(), from.y(), z_mm)).z());
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end(),
                              [](double a, double b) { return std::abs(a - b) <= kSameWrittenHeightMm; }),
                  heights.end());
    if (heights.size() > kMostCorners) heights = {heights.front(), heights.back()};
    return heights;
}

/// The ground of the later band among the earlier setup's heights.
StockSections withoutBand(const LateBand& band, const Setup& setup, const Tolerances& tol) {
    Stock stock = setup.stock;
    const Feature& feature = band.feature;
    stock.cuts = {{band.part_to_setup, {{feature.target, feature.top_z_mm, feature.floor_z_mm}}}};
    return {setup, stock, tol};
}

class CellFinder {
  public:
    CellFinder(const Setup& setup, const LayerStack& layers, const std::vector<EarlyBand>& early,
               const std::vector<LateBand>& late, const Deadline& deadline, const Tolerances& tol)
        : setup_id_(setup.id),
          early_(early),
          late_(late),
          deadline_(deadline),
          tol_(tol),
          by_price_(late.size()) {
        std::vector<double> heights;
        for (const EarlyBand& band : early)
            heights.insert(heights.end(), {band.feature->top_z_mm, band.feature->floor_z_mm});
        for (const LateBand& band : late) {
            const std::vector<double> own = heightsOf(band, setup);
            heights.insert(heights.end(), own.begin(), own.end());
            without_.push_back(withoutBand(band, setup, tol));
        }
        layers_ = partedAt(layers, heights);
        std::iota(by_price_.begin(), by_price_.end(), std::size_t{0});
        std::stable_sort(by_price_.begin(), by_price_.end(), [&](std::size_t a, std::size_t b) {
            return perVolume(late[a]) < perVolume(late[b]);
        });
    }

    std::vector<SharedCell> run() {
        Region must_go;  // of the layers below, this setup alone
        std::vector<SharedCell> from_below;
        for (std::size_t i = layers_.layers.size(); i-- > 0;) {
            deadline_.check("what " + setup_id_ + " might leave");
            const Layer& layer = layers_.layers[i];
            std::vector<SharedCell> cells = cellsIn(layer, must_go);
            must_go = withOwn(std::move(must_go), layer, cells);
            std::move(cells.begin(), cells.end(), std::back_inserter(from_below));
        }
        std::vector<SharedCell> cells(std::make_move_iterator(from_below.rbegin()),
                                      std::make_move_iterator(from_below.rend()));
        findBelow(cells);
        return cells;
    }

  private:
    std::vector<SharedCell> cellsIn(const Layer& layer, const Region& must_go) const {
        std::vector<SharedCell> cells;
        std::vector<Region> late(late_.size());
        std::vector<char> known(late_.size(), 0);
        for (std::size_t e = 0; e < early_.size(); ++e) {
            const Feature& feature = *early_[e].feature;
            if (early_[e].drilled || !holdsLayer(feature, layer)) continue;
            Region open = intersect(subtract(feature.target, layer.shadow, tol_), layer.stock, tol_);
            if (!must_go.empty()) open = subtract(open, must_go, tol_);
            for (const std::size_t l : by_price_) {
                if (open.empty()) break;
                if (known[l] == 0) late[l] = groundOf(l, layer);
                known[l] = 1;
                if (late[l].empty()) continue;
                Region shared = componentsWiderThan(intersect(open, late[l], tol_), kThinnestReserveMm, tol_);
                if (shared.empty()) continue;
                open = subtract(open, shared, tol_);
                cells.push_back(cellOf(
                    {std::move(shared), snapToGrid(layer.top_z_mm), snapToGrid(layer.bottom_z_mm)}, e, l));
            }
        }
        return cells;
    }

    /// What of the layer the later band takes, at every height.
    Region groundOf(std::size_t late, const Layer& layer) const {
        return subtract(layer.stock, without_[late].between(layer.bottom_z_mm, layer.top_z_mm), tol_);
    }

    SharedCell cellOf(Prism prism, std::size_t early, std::size_t late) const {
        const double volume_mm3 = prism.volume_mm3();
        const double early_share = volume_mm3 / early_[early].feature->volume_mm3;
        return {std::move(prism),
                early,
                late,
                early_share * early_[early].weight,
                volume_mm3 * perVolume(late_[late]),
                {}};
    }

    /// What must go with what the setup's bands take of the layer and no cell holds.
    Region withOwn(Region must_go, const Layer& layer, const std::vector<SharedCell>& cells) const {
        std::vector<Region> taken;
        for (const EarlyBand& band : early_)
            if (holdsLayer(*band.feature, layer)) taken.push_back(band.feature->target);
        if (taken.empty()) return must_go;
        Region own = intersect(subtract(layer.stock, layer.shadow, tol_), unite(taken, tol_), tol_);
        for (const SharedCell& cell : cells)
            own = subtract(own, cell.prism.region, tol_);
        if (feature::isSliver(own, tol_)) return must_go;
        return must_go.empty() ? own : unite(must_go, own, tol_);
    }

    /// Says of each which cells are under it: those that others of them are under are left out, as these stay
    /// where they stay.
    void findBelow(std::vector<SharedCell>& cells) const {
        std::vector<Box2> boxes;
        for (const SharedCell& cell : cells)
            boxes.push_back(boundingBox(cell.prism.region));
        for (std::size_t over = 0; over < cells.size(); ++over) {
            Region bare = cells[over].prism.region;
            for (std::size_t i = over + 1; i < cells.size() && !bare.empty(); ++i) {
                const Prism& under = cells[i].prism;
                if (under.top_z_mm > cells[over].prism.bottom_z_mm + kSameHeightMm) continue;
                if (!boxes[over].intersects(boxes[i])) continue;
                if (feature::isSliver(intersect(bare, under.region, tol_), tol_)) continue;
                cells[over].below.push_back(i);
                bare = subtract(bare, under.region, tol_);
                if (feature::isSliver(bare, tol_)) bare = {};
            }
        }
    }

    std::string setup_id_;
    const std::vector<EarlyBand>& early_;
    const std::vector<LateBand>& late_;
    Deadline deadline_;
    const Tolerances& tol_;
    LayerStack layers_;
    std::vector<StockSections> without_;  ///< of each later band
    std::vector<std::size_t> by_price_;   ///< later bands, the cheapest for its volume first
};

}  // namespace

std::vector<SharedCell> sharedCells(const Setup& setup, const LayerStack& layers,
                                    const std::vector<EarlyBand>& early, const std::vector<LateBand>& late,
                                    const Deadline& deadline, const Tolerances& tol) {
    return CellFinder(setup, layers, early, late, deadline, tol).run();
}

std::vector<Prism> prismsOf(const std::vector<SharedCell>& cells, const std::vector<bool>& chosen,
                            const Tolerances& tol) {
    std::vector<Prism> slabs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!chosen[i]) continue;
        const Prism& prism = cells[i].prism;
        if (slabs.empty() || slabs.back().bottom_z_mm != prism.bottom_z_mm)
            slabs.push_back(prism);
        else
            slabs.back().region = unite(slabs.back().region, prism.region, tol);
    }
    std::vector<Prism> joined;
    for (Prism& slab : slabs) {
        if (!joined.empty() && joined.back().bottom_z_mm == slab.top_z_mm &&
            feature::sameRegion(joined.back().region, slab.region, tol))
            joined.back().bottom_z_mm = slab.bottom_z_mm;
        else
            joined.push_back(std::move(slab));
    }
    return joined;
}

}  // namespace stepmill
