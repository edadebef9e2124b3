// From solids to layers.

#include <span>

#include <fmt/format.h>

#include "layers/faces/trace_faces.h"
#include "layers/mesh/solid_mesh.h"
#include "layers/section/section.h"
#include "layers/slab/cut_layer.h"
#include "layers/slab/levels.h"
#include "layers/slab/slab.h"
#include "layers/stock/raw_stock.h"
#include "layers/stock/stock_air.h"
#include "stepmill/core/error.h"
#include "stepmill/core/parallel.h"
#include "stepmill/layers/hole_cone.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/part/face_graph.h"
#include "stepmill/part/part_shape.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {

using layers::CutLayer;
using layers::Level;
using layers::SlabCut;
using layers::SolidMesh;

namespace {

/// The solids of a setup, ready to cut.
struct Solids {
    SolidMesh part;
    layers::RawStock raw;
    layers::StockAir air;      ///< what earlier setups cut from the raw stock
    double worthless_mm3 = 0;  ///< of which no slab makes a difference: SliceOptions::least_gain_share
};

/// To see whether a slab hides air worth another one, it is integrated over at most as many stretches between
/// bends; the stock's own volume corrects the sum.
constexpr int kStretches = 6;
/// ... and where cuts stand askew to the axis over this many: there every height has a scan of its own.
constexpr int kAskewStretches = 3;
/// A slab of the stock under several levels may hold air of this share of what is worth nothing: the rest is
/// left to the joining of slabs.
constexpr double kSharedAir = 1.0 / 16;

double worthlessMm3(const Setup& setup, const SliceOptions& options) {
    if (setup.stock.isRaw()) return 0;
    return setup.removable_mm3 *
           (setup.indexed ? options.least_gain_share_indexed : options.least_gain_share);
}

Solids makeSolids(const Setup& setup, const SliceOptions& options, const Tolerances& tol) {
    STEPMILL_CHECK(setup.part.shape, "a part to slice has a shape");
    return {
        SolidMesh(setup.part.shape->solid, setup.part_to_setup, layers::facetChord(setup.part.bbox_mm), tol),
        layers::RawStock(setup, tol), layers::StockAir(setup, worthlessMm3(setup, options) / 2, tol),
        worthlessMm3(setup, options)};
}

/// The stock in the slab: raw, less what is air at every height of it.
void cutStock(const Solids& solids, const SliceOptions& options, const Tolerances& tol, CutLayer& cut) {
    Layer& layer = cut.layer;
    layer.stock = solids.raw.box();
    double stock_mm3 = area(layer.stock) * layer.height_mm();
    if (solids.raw.mesh()) {
        SlabCut raw = layers::cutSlab(*solids.raw.mesh(), layer.top_z_mm, layer.bottom_z_mm, options, tol);
        layer.stock = std::move(raw.region);
        cut.raw_stock_upright = raw.vertical;
        stock_mm3 = raw.vertical ? area(layer.stock) * layer.height_mm() : raw.volume_mm3;
        for (const std::string& remark : raw.remarks)
            cut.remarks.push_back("stock: " + remark);
    }
    if (!solids.air.empty()) {
        // A slab that holds no more than makes a difference is not worth a quadrature: settleAir() looks at
        // its middle.
        const bool counts = stock_mm3 > solids.worthless_mm3;
        const Region air = solids.air.between(layer.bottom_z_mm, layer.top_z_mm);
        const int stretches = solids.air.leans() ? kAskewStretches : kStretches;
        stock_mm3 -= counts ? solids.air.volumeIn(layer.stock, layer.bottom_z_mm, layer.top_z_mm, stretches)
                            : area(intersect(layer.stock, air, tol)) * layer.height_mm();
        layer.stock = subtract(layer.stock, air, tol);
    }
    layer.stock_air_mm3 = area(layer.stock) * layer.height_mm() - stock_mm3;
}

/// The stock half-way up a slab, less what earlier setups cut.
Region stockHalfWay(const Solids& solids, const Tolerances& tol, const CutLayer& cut) {
    const Layer& layer = cut.layer;
    const double half_way = layer.middle_z_mm();
    Region raw = solids.raw.box();
    if (solids.raw.mesh()) {
        raw = layer.stock;
        if (!cut.raw_stock_upright)
            raw = layers::exactSection(*solids.raw.mesh(), half_way, tol).value_or(layer.stock);
    }
    return subtract(raw, solids.air.at(half_way), tol);
}

/// Settles whether the stock leans in a slab that stays, and where it stands half-way up if so.
void settleAir(const Solids& solids, const Tolerances& tol, CutLayer& cut) {
    Layer& layer = cut.layer;
    const double nothing_mm3 = tol.area_mm2 * layer.height_mm();
    const bool cut_before = !solids.air.empty();
    if (cut_before && !solids.air.isUpright(layer.bottom_z_mm, layer.top_z_mm)) {
        layer.stock_half_way = stockHalfWay(solids, tol, cut);
        // In thin slabs the quadrature misses more than there is; there the middle stands for all heights.
        if (layer.stock_air_mm3 <= nothing_mm3)
            layer.stock_air_mm3 = (area(layer.stock) - area(layer.stock_half_way)) * layer.height_mm();
    } else if (cut_before && layer.stock_air_mm3 > nothing_mm3) {
        layer.stock_half_way = stockHalfWay(solids, tol, cut);
    }
    if (layer.stock_air_mm3 > nothing_mm3) return;
    layer.stock_air_mm3 = 0;
    layer.stock_half_way = {};
}

/// Slabs of the stock that hold several of the part's, from the top down.
using StockSlabs = std::vector<CutLayer>;

/// Takes the stock from the slab that holds this one's heights; false if there is none.
bool takeStock(const StockSlabs& slabs, CutLayer& cut) {
    const auto holds = std::find_if(slabs.begin(), slabs.end(), [&](const CutLayer& slab) {
        return cut.layer.isWithin(slab.layer.top_z_mm, slab.layer.bottom_z_mm);
    });
    if (holds == slabs.end()) return false;
    const double share = cut.layer.height_mm() / holds->layer.height_mm();
    cut.layer.stock = holds->layer.stock;
    cut.raw_stock_upright = holds->raw_stock_upright;
    cut.layer.stock_air_mm3 = cut.shared_air_mm3 = share * holds->layer.stock_air_mm3;
    if (cut.layer.top_z_mm == holds->layer.top_z_mm) cut.remarks = holds->remarks;
    return true;
}

/// What all slabs are cut from.
struct Cutting {
    const Solids& solids;
    const StockSlabs& stock_slabs;
    const std::vector<FaceTrace>& traces;
    const std::vector<HoleCone>& cones;
    const SliceOptions& options;
    const Tolerances& tol;
};

/// A hole goes up through its cone as wide as below: the cone is for one stroke of a countersink, not for the
/// steps of a mill, which would stand over the hole.
void closeCones(const Cutting& from, CutLayer& cut) {
    Layer& layer = cut.layer;
    for (const HoleCone& cone : from.cones) {
        const double merge_mm = 2 * from.options.level_merge_mm;
        if (cone.bottom_z_mm > layer.top_z_mm - merge_mm || cone.top_z_mm < layer.bottom_z_mm + merge_mm)
            continue;
        const double mm2 = area(layer.part);
        const Region ring = subtract(makeCircle(cone.centre, snapToGrid(cone.radius_mm)),
                                     makeCircle(cone.centre, snapToGrid(cone.foot_radius_mm)), from.tol);
        layer.part = unite(layer.part, intersect(ring, layer.stock, from.tol), from.tol);
        const double volume_mm3 = std::max(0.0, area(layer.part) - mm2) * layer.height_mm();
        for (const int face : cone.faces)
            cut.in_cones_mm3[face] += volume_mm3 / static_cast<double>(cone.faces.size());
    }
}

CutLayer cutLayer(const Cutting& from, double top_mm, double bottom_mm) {
    const auto& [solids, stock_slabs, traces, cones, options, tol] = from;
    CutLayer cut;
    cut.layer.top_z_mm = top_mm;
    cut.layer.bottom_z_mm = bottom_mm;
    SlabCut part = layers::cutSlab(solids.part, top_mm, bottom_mm, options, tol);
    cut.layer.part = std::move(part.region);
    cut.layer.vertical_walls = part.vertical;
    cut.layer.mended_by_mm = part.mended_by_mm;
    cut.part_volume_mm3 = part.volume_mm3;
    cut.leaning = std::move(part.leaning);
    if (!takeStock(stock_slabs, cut)) cutStock(solids, options, tol, cut);
    std::move(part.remarks.begin(), part.remarks.end(), std::back_inserter(cut.remarks));
    // Hulls of facets may reach out of the stock; the part does not.
    if (part.mended_by_mm > 0) cut.layer.part = intersect(cut.layer.part, cut.layer.stock, tol);
    closeCones(from, cut);
    return cut;
}

/// Volume that leaning walls hide and that thinner slabs would show: not what lies below overhangs and in
/// holes across the axis, where no tool from above comes at any height, nor in cones of holes.
double gainableVolume(const CutLayer& cut, const std::vector<FaceTrace>& traces) {
    double space = 0;
    double gainable = 0;
    for (const auto& [face, share] : cut.leaning) {
        const double volume = share.space(cut.layer.top_z_mm, cut.layer.bottom_z_mm);
        const auto cause = traces[face].cause;
        space += volume;
        const bool in_cone = cut.in_cones_mm3.count(face) > 0;
        if (cause != SlopeCause::Overhang && cause != SlopeCause::AcrossAxis && !in_cone) gainable += volume;
    }
    return space > 0 ? (layers::hiddenVolume(cut) - cut.inCones_mm3()) * gainable / space : 0;
}

/// One slab between levels, halved while leaning walls hide too much of what is to be removed.
void cutAndHalve(const Cutting& from, double top_mm, double bottom_mm, std::vector<CutLayer>& out) {
    CutLayer cut = cutLayer(from, top_mm, bottom_mm);
    const double height = top_mm - bottom_mm;
    const double removable = area(cut.layer.stock) * height - cut.part_volume_mm3;
    const double allowed = std::max({from.options.largest_hidden_share * removable,
                                     from.tol.area_mm2 * height, from.solids.worthless_mm3});
    const bool thin = height / 2 < from.options.thinnest_slab_mm;
    const bool stock_leans = cut.layer.stock_air_mm3 > allowed;
    if (thin || (gainableVolume(cut, from.traces) <= allowed && !stock_leans)) {
        if (cut.shared_air_mm3 <= 0)
            settleAir(from.solids, from.tol, cut);
        else
            cut.layer.stock_half_way = stockHalfWay(from.solids, from.tol, cut);
        out.push_back(std::move(cut));
        return;
    }
    const double middle =
        stock_leans ? from.solids.air.bendNearMiddle(bottom_mm, top_mm) : (top_mm + bottom_mm) / 2;
    cutAndHalve(from, top_mm, middle, out);
    cutAndHalve(from, middle, bottom_mm, out);
}

/// Heights where slabs of the stock end in any case: hard levels, and those where the raw stock's own form
/// changes.
std::vector<std::size_t> stockBounds(const Solids& solids, const std::vector<Level>& levels,
                                     const SliceOptions& options) {
    std::vector<Level> of_stock;
    if (solids.raw.mesh()) layers::addLevels(*solids.raw.mesh(), Level::Rank::Plane, of_stock);
    std::vector<std::size_t> bounds;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const bool of_raw = std::any_of(of_stock.begin(), of_stock.end(), [&](const Level& level) {
            return std::abs(level.z_mm - levels[i].z_mm) <= 2 * options.level_merge_mm;
        });
        if (of_raw || !levels[i].soft()) bounds.push_back(i);
    }
    return bounds;
}

/// One slab of the stock between two levels, parted at a level while it holds air worth a slab of its own.
/// Between neighbouring levels it is left to the part's slab.
void cutStockSlab(const Solids& solids, std::span<const Level> levels, const SliceOptions& options,
                  const Tolerances& tol, StockSlabs& out) {
    if (levels.size() <= 2) return;
    CutLayer cut;
    cut.layer.top_z_mm = levels.front().z_mm;
    cut.layer.bottom_z_mm = levels.back().z_mm;
    cutStock(solids, options, tol, cut);
    if (cut.layer.stock_air_mm3 <= kSharedAir * solids.worthless_mm3) {
        cut.layer.stock_air_mm3 = std::max(0.0, cut.layer.stock_air_mm3);
        out.push_back(std::move(cut));
        return;
    }
    const double middle = cut.layer.middle_z_mm();
    std::size_t at = 1;
    for (std::size_t i = 1; i + 1 < levels.size(); ++i)
        if (std::abs(levels[i].z_mm - middle) < std::abs(levels[at].z_mm - middle)) at = i;
    cutStockSlab(solids, levels.first(at + 1), options, tol, out);
    cutStockSlab(solids, levels.subspan(at), options, tol, out);
}

/// Seen askew every wall that earlier setups cut leans, and the part has a level at every vertex: slabs of
/// the stock are cut where its air asks for them, not at each of these.
StockSlabs cutStockSlabs(const Solids& solids, const std::vector<Level>& levels, const SliceOptions& options,
                         const Tolerances& tol) {
    StockSlabs all;
    if (!solids.air.leans() || !options.join_slabs) return all;
    const std::vector<std::size_t> bounds = stockBounds(solids, levels, options);
    std::vector<StockSlabs> slabs(bounds.size() - 1);
    parallelFor(slabs.size(), [&](std::size_t i) {
        guardOcct(ErrorCode::GeometryKernel, fmt::format("stock under z {:.4f} mm", levels[bounds[i]].z_mm),
                  [&] {
                      const std::span<const Level> between(&levels[bounds[i]], bounds[i + 1] - bounds[i] + 1);
                      cutStockSlab(solids, between, options, tol, slabs[i]);
                  });
    });
    for (StockSlabs& some : slabs)
        std::move(some.begin(), some.end(), std::back_inserter(all));
    return all;
}

std::vector<CutLayer> cutAll(const Cutting& from, const std::vector<Level>& levels) {
    std::vector<std::vector<CutLayer>> slabs(levels.size() - 1);
    parallelFor(slabs.size(), [&](std::size_t i) {
        guardOcct(ErrorCode::GeometryKernel, fmt::format("slab at z {:.4f} mm", levels[i].z_mm), [&] {
            cutAndHalve(from, levels[i].z_mm, levels[i + 1].z_mm, slabs[i]);
            for (std::size_t k = 0; k < slabs[i].size(); ++k)
                slabs[i][k].soft_top = k > 0 || levels[i].soft();
        });
    });
    std::vector<CutLayer> all;
    for (std::vector<CutLayer>& slab : slabs)
        std::move(slab.begin(), slab.end(), std::back_inserter(all));
    return all;
}

/// Slabs of one solid are mended for the same few reasons again and again: the first ones stand for all.
void appendShortened(std::vector<std::string> of_slabs, std::vector<std::string>& remarks) {
    constexpr std::size_t kShown = 3;
    const std::size_t shown = of_slabs.size() > kShown + 1 ? kShown : of_slabs.size();
    std::move(of_slabs.begin(), of_slabs.begin() + static_cast<std::ptrdiff_t>(shown),
              std::back_inserter(remarks));
    if (shown < of_slabs.size())
        remarks.push_back(fmt::format("{} more remarks like these", of_slabs.size() - shown));
}

}  // namespace

LayerStack slice(const Setup& setup, const Tolerances& tol, const SliceOptions& options) {
    const Solids solids = makeSolids(setup, options, tol);
    std::vector<layers::Level> marks;
    layers::addLevels(solids.part, Level::Rank::Plane, marks);
    if (solids.raw.mesh()) layers::addLevels(*solids.raw.mesh(), Level::Rank::Plane, marks);
    for (const double z : solids.air.planes())
        marks.push_back({z, Level::Rank::CutPlane});
    LayerStack stack;
    stack.setup_id = setup.id;
    stack.stock_top_z_mm = setup.stock_bbox_mm.max().z();
    stack.stock_bottom_z_mm = setup.stock_bbox_mm.min().z();
    stack.stock_volume_mm3 = setup.stock.volume_mm3;
    stack.part_volume_mm3 = setup.part.volume_mm3;
    stack.stock_cut_before = !setup.stock.isRaw();
    stack.removable_mm3 = setup.removable_mm3;
    const std::vector<Level> levels = layers::mergeLevels(std::move(marks), stack.stock_top_z_mm,
                                                          stack.stock_bottom_z_mm, options.level_merge_mm);
    if (solids.part.openSides() > 0)
        stack.remarks.push_back(fmt::format("the part's facets leave {} gap{}", solids.part.openSides(),
                                            solids.part.openSides() == 1 ? "" : "s"));
    guardOcct(ErrorCode::GeometryKernel, "faces of the part",
              [&] { stack.traces = layers::traceFaces(solids.part, faceEdges(setup.part, tol), tol); });
    const StockSlabs stock_slabs = cutStockSlabs(solids, levels, options, tol);
    const std::vector<HoleCone> cones = holeCones(stack.traces);
    std::vector<CutLayer> cuts = cutAll({solids, stock_slabs, stack.traces, cones, options, tol}, levels);
    layers::closeBooks(cuts, setup, tol, stack.remarks);
    layers::castShadows(cuts, tol);
    if (options.join_slabs) cuts = layers::mergeSlabs(std::move(cuts), solids.worthless_mm3, options, tol);
    layers::shareHiddenVolume(cuts, stack.traces);
    std::vector<std::string> of_slabs;
    for (CutLayer& cut : cuts) {
        std::move(cut.remarks.begin(), cut.remarks.end(), std::back_inserter(of_slabs));
        stack.layers.push_back(std::move(cut.layer));
    }
    appendShortened(std::move(of_slabs), stack.remarks);
    return stack;
}

}  // namespace stepmill
