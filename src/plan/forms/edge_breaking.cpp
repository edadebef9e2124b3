// Sharp edges, broken by chamfer mills.

#include "plan/forms/edge_breaking.h"

#include <algorithm>
#include <cmath>

#include "plan/forms/form_levels.h"
#include "plan/forms/form_stairs.h"
#include "plan/forms/form_work.h"
#include "plan/forms/site_walls.h"
#include "stepmill/catalog/cutter_form.h"
#include "stepmill/feature/heights.h"
#include "stepmill/layers/reserve.h"
#include "stepmill/plan/edge_breaks.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill {
namespace {

/// A break is planned in so many bands: the mill's flank goes through the upper inner corner of each, so
/// their number changes nothing of what is cut.
constexpr int kBands = 8;
/// The tip goes so far below an edge's foot where there is room, for a chamfer mill has no speed there [mm].
constexpr double kBelowFootMm = 0.5;
/// What passes may leave counts as a ridge of this share of the break's width.
constexpr double kScallopShare = 1.0 / 12;
/// A further mill comes only for this share of what is there.
constexpr double kLeastBreakGainShare = 0.02;
/// Stretches that stay sharp are no shorter than so many widths.
constexpr double kShortestSharpWidths = 2;
/// Sine of 45 degrees: how a break leans.
const double kBreakLean = std::sqrt(0.5);

/// The edges of a setup as ground for chamfer mills.
class EdgeWalls : public SiteWalls {
  public:
    EdgeWalls(const FormSources& from, const EdgeBreaks& breaks, const Tolerances& tol)
        : breaks_(breaks), part_(from.setup, tol), at_end_(from.setup, from.at_end, tol), tol_(tol) {
        for (const EdgeBreaks::FaceEdges& face : breaks.faces())
            addHeights(face.z_mm);
        std::sort(cuts_mm_.begin(), cuts_mm_.end());
        cuts_mm_.erase(std::unique(cuts_mm_.begin(), cuts_mm_.end()), cuts_mm_.end());
    }

    std::string groundId(const std::string& setup_id) const override { return edgeGroundId(setup_id); }

    /// What other operations, or breaks from other sides, have left of the edges.
    std::vector<Obstacle> stairs() const override {
        std::vector<Obstacle> found;
        for (std::size_t i = 1; i < cuts_mm_.size(); ++i) {
            const Heights band{cuts_mm_[i - 1], cuts_mm_[i]};
            const Region goes = breaks_.goesHalfWay(band.bottom_mm, band.top_mm);
            if (goes.empty()) continue;
            Region stands = at_end_.throughout(goes, band.bottom_mm, band.top_mm);
            if (area(stands) > tol_.area_mm2)
                found.push_back({band.bottom_mm, band.top_mm, std::move(stands)});
        }
        return found;
    }

    std::vector<double> feet() const override { return {}; }

    bool cuts(const Layer& layer) const override {
        return std::any_of(cuts_mm_.begin(), cuts_mm_.end(),
                           [&](double z_mm) { return z_mm > layer.bottom_z_mm && z_mm <= layer.top_z_mm; });
    }

    std::vector<Heights> bandsOf(const Layer& layer, const BandLimits& /*limits*/) const override {
        std::vector<double> heights = part_.levelsBetween(layer.bottom_z_mm, layer.top_z_mm);
        for (const double z_mm : cuts_mm_)
            if (z_mm > layer.bottom_z_mm && z_mm < layer.top_z_mm) heights.push_back(z_mm);
        heights.push_back(layer.top_z_mm);
        std::sort(heights.begin(), heights.end());
        std::vector<Heights> bands;
        double bottom_mm = layer.bottom_z_mm;
        for (const double top_mm : heights) {
            if (top_mm - bottom_mm < kHeightStepMm / 2) continue;
            bands.push_back({bottom_mm, top_mm});
            bottom_mm = top_mm;
        }
        if (bands.empty()) return {{layer.bottom_z_mm, layer.top_z_mm}};
        bands.back().top_mm = layer.top_z_mm;
        return bands;
    }

    Region mustStay(const Heights& band) const override {
        const Region part = part_.partBetween(band.bottom_mm, band.top_mm);
        const Region goes = breaks_.mayGo(band.bottom_mm, band.top_mm);
        return goes.empty() ? part : subtract(part, goes, tol_);
    }

    std::vector<double> leans(const Heights& band) const override {
        const bool breaks = !breaks_.mayGo(band.bottom_mm, band.top_mm).empty();
        return breaks ? std::vector<double>{kBreakLean} : std::vector<double>{};
    }

  private:
    void addHeights(double z_mm) {
        const double foot_mm = z_mm - breaks_.widthMm();
        cuts_mm_.push_back(foot_mm - kBelowFootMm);
        for (int i = 0; i <= kBands; ++i)
            cuts_mm_.push_back(foot_mm + breaks_.widthMm() * i / kBands);
    }

    const EdgeBreaks& breaks_;
    SectionCutter part_;
    StockSections at_end_;
    const Tolerances& tol_;
    std::vector<double> cuts_mm_;  ///< heights at which the part is cut, ascending
};

bool breaksEdges(const ToolAssembly& tool, const FormShop& shop) {
    return tool.type == ToolType::Chamfer && tool.cuttingFor(shop.material) != nullptr;
}

/// The mill that takes most of what is left, then the next, as long as that is worth its change.
std::vector<FormStep> stepsOver(const FormSite& site, const FormShop& shop) {
    FormWork work(site, shop);
    StandingStairs left(site.ground, shop.tol);
    const double least_mm3 = kLeastBreakGainShare * left.volumeMm3();
    std::vector<FormStep> steps;
    while (true) {
        std::optional<FormStep> best;
        for (const ToolAssembly* tool : work.cutters()) {
            if (!breaksEdges(*tool, shop)) continue;
            FormStep step = work.step(*tool, left);
            const bool more = !best || step.taken_mm3 > best->taken_mm3 * (1 + kLeastBreakGainShare);
            if (step.taken_mm3 > least_mm3 && more) best = std::move(step);
        }
        if (!best) return steps;
        left = best->left;
        steps.push_back(std::move(*best));
    }
}

/// Why an edge stays that some mill was tried on.
std::string whyLeft(const FormShop& shop) {
    const auto& tools = shop.library.tools;
    const bool any = std::any_of(tools.begin(), tools.end(), [&](const ToolAssembly& tool) {
        return breaksEdges(tool, shop) && std::abs(flankLean(tool) - kBreakLean) <= kSameLean;
    });
    return any ? "no chamfer mill reaches it without touching what must stand"
               : "the library has no chamfer mill of 90 degrees for the material";
}

/// Stretches of edges whose strip still stands where it is widest, edge by edge.
std::vector<SharpStretch> stretchesLeft(const EdgeBreaks& breaks, const StandingStairs& left,
                                        const std::string& why, const Tolerances& tol) {
    std::vector<SharpStretch> sharp;
    const double width_mm = breaks.widthMm();
    for (const EdgeBreaks::FaceEdges& face : breaks.faces()) {
        const double highest_mm = face.z_mm - width_mm / kBands;
        for (const StandingStairs::Slice& slice : left.slices()) {
            if (slice.z_mm <= highest_mm || slice.z_mm >= face.z_mm || slice.region.empty()) continue;
            const Region near = offset(slice.region, width_mm / 2, tol);
            for (const Path& edge : face.edges)
                for (const Path& stretch : split(edge, near, tol).inside)
                    if (length(stretch) > kShortestSharpWidths * width_mm)
                        sharp.push_back(sharpStretch(stretch, face.z_mm, why));
        }
    }
    return sharp;
}

/// Where layers end that fixtures stand beside: above them cutters have room.
std::vector<double> fixtureTops(const Setup& setup) {
    std::vector<double> heights_mm;
    for (const Fixture& fixture : setup.fixtures)
        heights_mm.push_back(fixture.top_z_mm);
    return heights_mm;
}

}  // namespace

std::optional<FormFinishing> breakEdges(const FormSources& cut, double width_mm, const FormShop& shop) {
    shop.deadline.check(edgeGroundId(cut.setup.id));
    const LayerStack layers = partedAt(cut.layers, fixtureTops(cut.setup));
    const FormSources sources{cut.setup, layers, cut.after, cut.at_end};
    const EdgeBreaks breaks(layers, width_mm, shop.tol);
    std::optional<FormSite> site = siteOf(sources, EdgeWalls(sources, breaks, shop.tol), width_mm,
                                          widestFormCutterMm(shop), shop.tol, shop.deadline);
    if (!site || shop.caution.dropped) return std::nullopt;
    const StandingStairs all(site->ground, shop.tol);
    FormShop fine = shop;
    fine.scallop_mm = kScallopShare * width_mm;
    std::vector<FormStep> steps = stepsOver(*site, fine);
    const StandingStairs& left = steps.empty() ? all : steps.back().left;
    FormFinishing breaking;
    breaking.ground = std::move(site->ground);
    breaking.ground.edges_mm = width_mm;
    breaking.ground.sharp = stretchesLeft(breaks, left, whyLeft(shop), shop.tol);
    breaking.ground.sharp.insert(breaking.ground.sharp.end(), breaks.lowWalls().begin(),
                                 breaks.lowWalls().end());
    breaking.removed = takenPrisms(all, left, shop.tol);
    for (FormStep& step : steps) {
        breaking.operations.push_back(formOperation(step, breaking.ground, shop));
        breaking.operations.back().breaks_mm3 = step.taken_mm3;
        breaking.operations.back().path.pattern = "edge pass";
    }
    return breaking;
}

}  // namespace stepmill
