// Part and stock at any height.

#include "stepmill/layers/section_cutter.h"

#include <cmath>
#include <set>

#include "layers/mesh/solid_mesh.h"
#include "layers/section/section.h"
#include "layers/slab/levels.h"
#include "layers/slab/slab.h"
#include "layers/slab/slab_facets.h"
#include "layers/stock/raw_stock.h"
#include "layers/stock/stock_air.h"
#include "stepmill/core/error.h"
#include "stepmill/part/part_shape.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {

using layers::Level;
using layers::SlabFacet;
using layers::SolidMesh;

namespace {

/// Sections at the ends of a slab are made this share of its height within: level faces lie on them.
constexpr double kFromEndsShare = 0.01;
/// Leans closer than this are one.
constexpr double kLeanStep = 0.02;

SolidMesh partMesh(const Setup& setup, const Tolerances& tol) {
    STEPMILL_CHECK(setup.part.shape, "a part to cut has a shape");
    return SolidMesh(setup.part.shape->solid, setup.part_to_setup, layers::facetChord(setup.part.bbox_mm),
                     tol);
}

Setup withStock(Setup setup, const Stock& stock) {
    setup.stock = stock;
    return setup;
}

}  // namespace

struct SectionCutter::Impl {
    SolidMesh mesh;
    Tolerances tol;
    SliceOptions options;
};

SectionCutter::SectionCutter(const Setup& setup, const Tolerances& tol)
    : impl_(new Impl{partMesh(setup, tol), tol, {}}) {}
SectionCutter::~SectionCutter() = default;
SectionCutter::SectionCutter(SectionCutter&&) noexcept = default;

std::vector<double> SectionCutter::levelsBetween(double bottom_mm, double top_mm) const {
    std::vector<Level> levels;
    layers::addLevels(impl_->mesh, Level::Rank::Plane, levels);
    levels = layers::mergeLevels(std::move(levels), top_mm, bottom_mm, impl_->options.level_merge_mm);
    std::vector<double> heights;
    for (std::size_t i = levels.size() - 1; i-- > 1;)
        heights.push_back(levels[i].z_mm);
    return heights;
}

Region SectionCutter::partBetween(double bottom_mm, double top_mm) const {
    Region covered;
    guardOcct(ErrorCode::GeometryKernel, "a section of the part", [&] {
        covered = layers::cutSlab(impl_->mesh, top_mm, bottom_mm, impl_->options, impl_->tol).region;
    });
    return covered;
}

double SectionCutter::greatestLean(double bottom_mm, double top_mm) const {
    double greatest = 0;
    for (const SlabFacet& facet : layers::slopedFacets(impl_->mesh, top_mm, bottom_mm))
        if (!facet.thin) greatest = std::max(greatest, facet.normal_z);
    return greatest;
}

std::vector<double> SectionCutter::leansBetween(double bottom_mm, double top_mm) const {
    std::set<double> leans;
    for (const SlabFacet& facet : layers::slopedFacets(impl_->mesh, top_mm, bottom_mm))
        if (!facet.thin && facet.normal_z > 0)
            leans.insert(std::min(1.0, std::ceil(facet.normal_z / kLeanStep) * kLeanStep));
    return {leans.begin(), leans.end()};
}

struct StockSections::Impl {
    layers::RawStock raw;
    layers::StockAir air;
    Tolerances tol;

    Region rawBetween(double bottom_mm, double top_mm) const {
        if (!raw.mesh()) return raw.box();
        return layers::cutSlab(*raw.mesh(), top_mm, bottom_mm, {}, tol).region;
    }
    Region rawAt(double z_mm) const {
        if (!raw.mesh()) return raw.box();
        return layers::exactSection(*raw.mesh(), z_mm, tol).value_or(Region{});
    }
    Region rawThroughout(double bottom_mm, double top_mm) const {
        if (!raw.mesh()) return raw.box();
        const double in_mm = kFromEndsShare * (top_mm - bottom_mm);
        const Region ends = intersect(rawAt(bottom_mm + in_mm), rawAt(top_mm - in_mm), tol);
        return intersect(ends, rawAt((bottom_mm + top_mm) / 2), tol);
    }
};

StockSections::StockSections(const Setup& setup, const Stock& stock, const Tolerances& tol)
    : impl_(new Impl{layers::RawStock(withStock(setup, stock), tol),
                     layers::StockAir(withStock(setup, stock), 0, tol), tol}) {}
StockSections::~StockSections() = default;
StockSections::StockSections(StockSections&&) noexcept = default;

Region StockSections::between(double bottom_mm, double top_mm) const {
    return subtract(impl_->rawBetween(bottom_mm, top_mm), impl_->air.between(bottom_mm, top_mm), impl_->tol);
}

Region StockSections::between(const Region& ground, double bottom_mm, double top_mm) const {
    return impl_->air.subtractedFrom(intersect(ground, impl_->rawBetween(bottom_mm, top_mm), impl_->tol),
                                     bottom_mm, top_mm, layers::AtHeights::All);
}

Region StockSections::throughout(const Region& ground, double bottom_mm, double top_mm) const {
    return impl_->air.subtractedFrom(intersect(ground, impl_->rawThroughout(bottom_mm, top_mm), impl_->tol),
                                     bottom_mm, top_mm, layers::AtHeights::Some);
}

Region StockSections::at(double z_mm) const {
    return subtract(impl_->rawAt(z_mm), impl_->air.at(z_mm), impl_->tol);
}

}  // namespace stepmill
