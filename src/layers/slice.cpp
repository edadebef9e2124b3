// From solids to layers.

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "layers/levels.h"
#include "layers/slab.h"
#include "layers/solid_mesh.h"
#include "stepmill/core/error.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {

using layers::SlabCut;
using layers::SolidMesh;

namespace {

/// The solids of a setup, ready to cut.
struct Solids {
    SolidMesh part;
    std::optional<SolidMesh> stock;  ///< none: an upright box
    Region stock_box;
};

/// A layer with the true volume of the part in it, for the books.
struct CutLayer {
    Layer layer;
    double part_volume_mm3 = 0;
    std::vector<std::string> remarks;
};

bool isUprightBox(const Setup& setup) {
    if (setup.stock.kind != Stock::Kind::Box) return false;
    const Eigen::Matrix3d r = setup.part_to_setup.linear().cwiseAbs();
    return (r.array() * (1 - r.array())).matrix().norm() < 1e-12;
}

Solids makeSolids(const Setup& setup, const Tolerances& tol) {
    STEPMILL_CHECK(setup.part.shape, "a part to slice has a shape");
    Solids solids{
        SolidMesh(setup.part.shape->solid, setup.part_to_setup, layers::facetChord(setup.part.bbox_mm), tol),
        std::nullopt,
        {}};
    if (isUprightBox(setup)) {
        const Box3& box = setup.stock_bbox_mm;
        solids.stock_box = makeRectangle(box.min().head<2>(), box.max().head<2>());
    } else {
        STEPMILL_CHECK(setup.stock.shape, "a stock other than an upright box has a shape");
        solids.stock.emplace(setup.stock.shape->solid, setup.part_to_setup,
                             layers::facetChord(setup.stock.bbox_mm), tol);
    }
    return solids;
}

CutLayer cutLayer(const Solids& solids, double top_mm, double bottom_mm, const SliceOptions& options,
                  const Tolerances& tol) {
    CutLayer cut;
    cut.layer.top_z_mm = top_mm;
    cut.layer.bottom_z_mm = bottom_mm;
    SlabCut part = layers::cutSlab(solids.part, top_mm, bottom_mm, options, tol);
    cut.layer.part = std::move(part.region);
    cut.layer.vertical_walls = part.vertical;
    cut.part_volume_mm3 = part.volume_mm3;
    cut.remarks = std::move(part.remarks);
    if (solids.stock) {
        SlabCut stock = layers::cutSlab(*solids.stock, top_mm, bottom_mm, options, tol);
        cut.layer.stock = std::move(stock.region);
        for (const std::string& remark : stock.remarks)
            cut.remarks.push_back("stock: " + remark);
    } else {
        cut.layer.stock = solids.stock_box;
    }
    return cut;
}

double hiddenVolume(const CutLayer& cut) {
    if (cut.layer.vertical_walls) return 0;
    return std::max(0.0, area(cut.layer.part) * cut.layer.height_mm() - cut.part_volume_mm3);
}

/// One slab between levels, halved while leaning walls hide too much of what is to be removed.
void cutAndHalve(const Solids& solids, double top_mm, double bottom_mm, const SliceOptions& options,
                 const Tolerances& tol, std::vector<CutLayer>& out) {
    CutLayer cut = cutLayer(solids, top_mm, bottom_mm, options, tol);
    const double height = top_mm - bottom_mm;
    const double removable = area(cut.layer.stock) * height - cut.part_volume_mm3;
    const bool halve =
        hiddenVolume(cut) > std::max(options.largest_hidden_share * removable, tol.area_mm2 * height) &&
        height / 2 >= options.thinnest_slab_mm;
    if (!halve) {
        out.push_back(std::move(cut));
        return;
    }
    const double middle = (top_mm + bottom_mm) / 2;
    cutAndHalve(solids, top_mm, middle, options, tol, out);
    cutAndHalve(solids, middle, bottom_mm, options, tol, out);
}

std::vector<CutLayer> cutAll(const Solids& solids, const std::vector<double>& levels,
                             const SliceOptions& options, const Tolerances& tol) {
    std::vector<std::vector<CutLayer>> slabs(levels.size() - 1);
    tbb::parallel_for(std::size_t{0}, slabs.size(), [&](std::size_t i) {
        guardOcct(ErrorCode::GeometryKernel, fmt::format("slab at z {:.4f} mm", levels[i]),
                  [&] { cutAndHalve(solids, levels[i], levels[i + 1], options, tol, slabs[i]); });
    });
    std::vector<CutLayer> all;
    for (std::vector<CutLayer>& slab : slabs)
        std::move(slab.begin(), slab.end(), std::back_inserter(all));
    return all;
}

/// Makes the slabs' volumes add up to the solid's: what quadrature missed belongs to the sloped slabs.
void closeBooks(std::vector<CutLayer>& cuts, const Setup& setup, const Tolerances& tol,
                std::vector<std::string>& remarks) {
    double total = 0;
    double sloped = 0;
    for (const CutLayer& cut : cuts) {
        total += cut.part_volume_mm3;
        if (!cut.layer.vertical_walls) sloped += cut.part_volume_mm3;
    }
    const double missing = setup.part.volume_mm3 - total;
    // Rounding of the part's own volume is no discrepancy, however little there is to remove.
    const double allowed = std::max(tol.volume_share * (setup.stock.volume_mm3 - setup.part.volume_mm3),
                                    1e-6 * setup.part.volume_mm3);
    if (std::abs(missing) > allowed)
        remarks.push_back(fmt::format("sections account for {:.1f} mm3 of the part's {:.1f} mm3", total,
                                      setup.part.volume_mm3));
    if (sloped <= 0 || std::abs(missing) > 0.1 * sloped) return;
    for (CutLayer& cut : cuts)
        if (!cut.layer.vertical_walls) cut.part_volume_mm3 *= 1 + missing / sloped;
}

void castShadows(std::vector<CutLayer>& cuts, const Tolerances& tol) {
    Region shadow;
    for (CutLayer& cut : cuts) {
        // The wider region below hides the narrower one above: ask that way round first.
        shadow = layers::uniteKeeping(cut.layer.part, shadow, tol);
        cut.layer.shadow = shadow;
    }
}

}  // namespace

LayerStack slice(const Setup& setup, const Tolerances& tol, const SliceOptions& options) {
    const Solids solids = makeSolids(setup, tol);
    std::vector<layers::Level> marks;
    layers::addLevels(solids.part, marks);
    if (solids.stock) layers::addLevels(*solids.stock, marks);
    LayerStack stack;
    stack.setup_id = setup.id;
    stack.stock_top_z_mm = setup.stock_bbox_mm.max().z();
    stack.stock_bottom_z_mm = setup.stock_bbox_mm.min().z();
    stack.stock_volume_mm3 = setup.stock.volume_mm3;
    stack.part_volume_mm3 = setup.part.volume_mm3;
    const std::vector<double> levels = layers::mergeLevels(std::move(marks), stack.stock_top_z_mm,
                                                           stack.stock_bottom_z_mm, options.level_merge_mm);
    if (solids.part.openSides() > 0)
        stack.remarks.push_back(fmt::format("the part's facets leave {} gaps", solids.part.openSides()));
    std::vector<CutLayer> cuts = cutAll(solids, levels, options, tol);
    closeBooks(cuts, setup, tol, stack.remarks);
    castShadows(cuts, tol);
    for (CutLayer& cut : cuts) {
        cut.layer.sloped_volume_mm3 = hiddenVolume(cut);
        std::move(cut.remarks.begin(), cut.remarks.end(), std::back_inserter(stack.remarks));
        stack.layers.push_back(std::move(cut.layer));
    }
    return stack;
}

}  // namespace stepmill
