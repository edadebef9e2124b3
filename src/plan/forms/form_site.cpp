// Where form cutters have work in a setup, and what they must keep clear of.

#include "plan/forms/form_site.h"

#include <algorithm>

#include "plan/forms/form_stairs.h"
#include "plan/forms/site_walls.h"
#include "stepmill/core/parallel.h"
#include "stepmill/feature/heights.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/layers/section_cutter.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/toolpath/swept_region.h"

namespace stepmill {
namespace {

/// Bands are no thinner, whatever the lean, and no thicker on walls that lean at all [mm].
constexpr double kThinnestBandMm = 0.01;
constexpr double kThickestBandMm = 0.25;
/// The thickest of a ground with few bands: a ball stays over the bottom of a groove of its own radius by as
/// much as the thickest band is high.
constexpr double kThickestOfFewMm = 0.05;
constexpr std::size_t kFewBands = 150;
/// A setup has no more bands than this; where it would, they are cut coarser.
constexpr std::size_t kMostBands = 500;
/// ... but never coarser than for a skin of that thickness [mm].
constexpr double kThickestSkinMm = 0.5;
/// Room around the stairs beyond the cutter's own width [mm].
constexpr double kRoomMm = 2.0;

/// Halves what is too high for its lean.
void addBands(const SectionCutter& part, const Heights& heights, const BandLimits& limits,
              std::vector<Heights>& into) {
    const double height_mm = heights.top_mm - heights.bottom_mm;
    const double lean = part.greatestLean(heights.bottom_mm, heights.top_mm);
    const bool fine = height_mm * lean <= limits.skin_mm || height_mm <= 2 * kThinnestBandMm;
    if (lean <= 0 || (fine && height_mm <= std::max(limits.thickest_mm, limits.skin_mm))) {
        into.push_back(heights);
        return;
    }
    const double middle_mm = onHeightStep((heights.bottom_mm + heights.top_mm) / 2);
    addBands(part, {heights.bottom_mm, middle_mm}, limits, into);
    addBands(part, {middle_mm, heights.top_mm}, limits, into);
}

/// Walls that look up and lean: flat layers leave stairs on them.
class LeaningWalls : public SiteWalls {
  public:
    LeaningWalls(const FormSources& from, const Tolerances& tol, const Deadline& deadline)
        : part_(from.setup, tol) {
        for (LayerStairs& layer : stairsOf(from, part_, tol, deadline)) {
            feet_mm_.push_back(layer.foot_mm);
            std::move(layer.stairs.begin(), layer.stairs.end(), std::back_inserter(stairs_));
        }
    }

    std::string groundId(const std::string& setup_id) const override { return formGroundId(setup_id); }
    std::vector<Obstacle> stairs() const override { return stairs_; }
    std::vector<double> feet() const override { return feet_mm_; }
    bool cuts(const Layer& layer) const override {
        return std::find(feet_mm_.begin(), feet_mm_.end(), layer.bottom_z_mm) != feet_mm_.end();
    }
    std::vector<Heights> bandsOf(const Layer& layer, const BandLimits& limits) const override {
        std::vector<Heights> bands;
        double bottom_mm = layer.bottom_z_mm;
        std::vector<double> tops = part_.levelsBetween(layer.bottom_z_mm, layer.top_z_mm);
        tops.push_back(layer.top_z_mm);
        for (const double top_mm : tops) {
            addBands(part_, {bottom_mm, top_mm}, limits, bands);
            bottom_mm = top_mm;
        }
        return bands;
    }
    Region mustStay(const Heights& band) const override {
        return part_.partBetween(band.bottom_mm, band.top_mm);
    }
    std::vector<double> leans(const Heights& band) const override {
        return part_.leansBetween(band.bottom_mm, band.top_mm);
    }

  private:
    SectionCutter part_;
    std::vector<double> feet_mm_;
    std::vector<Obstacle> stairs_;
};

/// A layer, or a part of one in which fixtures end, with what stands beside its part.
struct StandingLayer {
    const Layer* layer = nullptr;
    Heights heights;
    bool cut = false;
    Region beside;  ///< stock beyond the layer's part, and fixtures
};

class SiteMaker {
  public:
    SiteMaker(const FormSources& from, const SiteWalls& walls, double skin_mm, double widest_mm,
              const Tolerances& tol, const Deadline& deadline)
        : from_(from),
          walls_(walls),
          skin_mm_(skin_mm),
          widest_mm_(widest_mm),
          tol_(tol),
          deadline_(deadline) {}

    std::optional<FormSite> make() {
        site_.ground.stairs = walls_.stairs();
        if (site_.ground.stairs.empty()) return std::nullopt;
        site_.feet_mm = walls_.feet();
        site_.ground.id = walls_.groundId(from_.setup.id);
        site_.ground.setup_id = from_.setup.id;
        findWindow();
        findStanding();
        cutBands();
        castShadows();
        return std::move(site_);
    }

  private:
    void checkTime() const { deadline_.check(walls_.groundId(from_.setup.id)); }

    void findWindow() {
        const double by_mm = 2 * widest_mm_ + kRoomMm;
        std::vector<Region> boxes;
        for (const Obstacle& stair : site_.ground.stairs)
            for (const Region& piece : components(stair.section)) {
                const Box2 box = grown(boundingBox(piece), by_mm);
                boxes.push_back(makeRectangle(box.min(), box.max()));
            }
        site_.ground.window = unite(boxes, tol_);
    }

    Region fixturesBetween(double bottom_mm, double top_mm) const {
        std::vector<Region> sections;
        for (const Fixture& fixture : from_.setup.fixtures)
            if (fixture.bottom_z_mm < top_mm && fixture.top_z_mm > bottom_mm)
                sections.push_back(fixture.section);
        return sections.empty() ? Region{} : unite(sections, tol_);
    }

    /// A layer in pieces, from below, in each of which the same fixtures stand.
    std::vector<Heights> betweenFixtures(const Layer& layer) const {
        std::vector<double> ends{layer.bottom_z_mm, layer.top_z_mm};
        for (const Fixture& fixture : from_.setup.fixtures)
            for (const double z_mm : {fixture.bottom_z_mm, fixture.top_z_mm})
                if (z_mm > layer.bottom_z_mm && z_mm < layer.top_z_mm) ends.push_back(z_mm);
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        std::vector<Heights> pieces;
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            pieces.push_back({ends[i], ends[i + 1]});
        return pieces;
    }

    /// From below.
    void findStanding() {
        const StockSections after(from_.setup, from_.after, tol_);
        const std::vector<Layer>& layers = from_.layers.layers;
        for (std::size_t i = layers.size(); i-- > 0;) {
            checkTime();
            const Layer& layer = layers[i];
            const Region stock = after.between(layer.bottom_z_mm, layer.top_z_mm);
            const Region left = toolpath::beyondSkins(subtract(stock, layer.part, tol_), tol_);
            for (const Heights& heights : betweenFixtures(layer)) {
                const Region fixtures = fixturesBetween(heights.bottom_mm, heights.top_mm);
                standing_.push_back({&layer, heights, walls_.cuts(layer), unite(left, fixtures, tol_)});
            }
        }
    }

    std::vector<Heights> bandsOf(const StandingLayer& standing, const BandLimits& limits) const {
        if (!standing.cut) return {standing.heights};
        std::vector<Heights> bands;
        for (const Heights& band : walls_.bandsOf(*standing.layer, limits)) {
            const Heights within{std::max(band.bottom_mm, standing.heights.bottom_mm),
                                 std::min(band.top_mm, standing.heights.top_mm)};
            if (within.bottom_mm < within.top_mm) bands.push_back(within);
        }
        return bands;
    }

    struct LayerBand {
        const StandingLayer* standing;
        Heights heights;
    };

    std::vector<LayerBand> allBands(const BandLimits& limits) const {
        std::vector<LayerBand> all;
        for (const StandingLayer& standing : standing_)
            for (const Heights& heights : bandsOf(standing, limits))
                all.push_back({&standing, heights});
        return all;
    }

    std::vector<LayerBand> affordableBands() const {
        BandLimits limits{skin_mm_, kThickestOfFewMm};
        std::vector<LayerBand> bands = allBands(limits);
        if (bands.size() <= kFewBands) return bands;
        limits.thickest_mm = kThickestBandMm;
        bands = allBands(limits);
        while (bands.size() > kMostBands && limits.skin_mm < kThickestSkinMm) {
            limits.skin_mm *= 2;
            bands = allBands(limits);
        }
        return bands;
    }

    void cutBands() {
        const std::vector<LayerBand> bands = affordableBands();
        site_.ground.must_stand.resize(bands.size());
        site_.leans.resize(bands.size());
        parallelFor(bands.size(), [&](std::size_t i) { cutBand(bands[i], i); });
        addFixturesOver();
    }

    void cutBand(const LayerBand& band, std::size_t i) {
        checkTime();
        const StandingLayer& standing = *band.standing;
        const Region part = standing.cut ? walls_.mustStay(band.heights) : standing.layer->part;
        site_.ground.must_stand[i] = {
            band.heights.bottom_mm, band.heights.top_mm,
            intersect(unite(part, standing.beside, tol_), site_.ground.window, tol_)};
        if (standing.cut) site_.leans[i] = walls_.leans(band.heights);
    }

    /// What holds the part may stand over the stock.
    void addFixturesOver() {
        double top_mm = from_.layers.stock_top_z_mm;
        for (const Fixture& fixture : from_.setup.fixtures)
            top_mm = std::max(top_mm, fixture.top_z_mm);
        if (top_mm <= from_.layers.stock_top_z_mm) return;
        const Region over = fixturesBetween(from_.layers.stock_top_z_mm, top_mm);
        site_.ground.must_stand.push_back(
            {from_.layers.stock_top_z_mm, top_mm, intersect(over, site_.ground.window, tol_)});
        site_.leans.emplace_back();
        fixtures_over_ = {from_.layers.stock_top_z_mm, top_mm, over};
    }

    void castShadows() {
        std::vector<Obstacle> from_above;
        Region shadow;
        if (!fixtures_over_.section.empty()) {
            from_above.push_back(fixtures_over_);
            shadow = fixtures_over_.section;
        }
        for (std::size_t i = standing_.size(); i-- > 0;) {
            checkTime();
            const StandingLayer& standing = standing_[i];
            const Region here = unite(standing.layer->part, standing.beside, tol_);
            Region with = unite(here, shadow, tol_);
            const bool same = !from_above.empty() && feature::sameRegion(with, shadow, tol_);
            shadow = std::move(with);
            if (same) {
                from_above.back().bottom_z_mm = standing.heights.bottom_mm;
                from_above.back().section = shadow;
                continue;
            }
            from_above.push_back({standing.heights.bottom_mm, standing.heights.top_mm, shadow});
        }
        site_.ground.obstacles = onGrownStock({from_above.rbegin(), from_above.rend()},
                                              growthOf(from_.setup.stock, from_.setup.part_to_setup), tol_);
    }

    const FormSources& from_;
    const SiteWalls& walls_;
    double skin_mm_;
    double widest_mm_;
    const Tolerances& tol_;
    const Deadline& deadline_;
    std::vector<StandingLayer> standing_;  ///< from below
    Obstacle fixtures_over_;
    FormSite site_;
};

}  // namespace

std::optional<FormSite> siteOf(const FormSources& sources, const SiteWalls& walls, double skin_mm,
                               double widest_mm, const Tolerances& tol, const Deadline& deadline) {
    return SiteMaker(sources, walls, skin_mm, widest_mm, tol, deadline).make();
}

std::optional<FormSite> formSite(const FormSources& sources, double skin_mm, double widest_mm,
                                 const Tolerances& tol, const Deadline& deadline) {
    std::optional<FormSite> site =
        siteOf(sources, LeaningWalls(sources, tol, deadline), skin_mm, widest_mm, tol, deadline);
    if (site) site->cones = holeCones(sources.layers.traces);
    return site;
}

}  // namespace stepmill
