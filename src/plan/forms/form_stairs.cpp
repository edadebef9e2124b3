// What form cutters find to take off: the stairs of flat layers that no other operation takes.

#include "plan/forms/form_stairs.h"

#include <algorithm>

#include "stepmill/core/parallel.h"
#include "stepmill/feature/heights.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/toolpath/swept_region.h"

namespace stepmill {
namespace {

/// A layer whose leaning walls hide less from flat cutters has no work for form cutters [mm3].
constexpr double kLeastHiddenMm3 = 0.05;
/// The part at the top of a layer is looked at over so much height [mm].
constexpr double kUnderTopMm = 0.01;
/// Stairs are no thinner than this, however the stock changes over them [mm].
constexpr double kThinnestStairMm = 0.1;
/// ... and thick enough where no more than this volume, or than this share of what may stand, is left out.
constexpr double kLeftOutMm3 = 0.01;
constexpr double kLeftOutShare = 0.02;
/// Where less of what may stand does so all the way up, setups before have cut through the rest [share].
constexpr double kLittleShare = 0.25;

/// Volume of a layer that tools from above see and flat ones leave.
double seenFromAboveMm3(const Layer& layer) {
    double sum = 0;
    for (const HiddenVolume& hidden : layer.hidden)
        if (hidden.cause != SlopeCause::Overhang && hidden.cause != SlopeCause::AcrossAxis)
            sum += hidden.volume_mm3;
    return sum;
}

class StairMaker {
  public:
    StairMaker(const FormSources& from, const SectionCutter& part, const Tolerances& tol,
               const Deadline& deadline)
        : id_(formGroundId(from.setup.id)),
          drilled_(from.drilled),
          part_(part),
          at_end_(from.setup, from.at_end, tol),
          tol_(tol),
          deadline_(deadline) {}

    LayerStairs of(const Layer& layer) const {
        LayerStairs found{layer.bottom_z_mm, {}};
        if (seenFromAboveMm3(layer) < kLeastHiddenMm3) return found;
        const double thin_mm = std::min(kUnderTopMm, layer.height_mm() / 2);
        std::vector<Region> gone{part_.partBetween(layer.top_z_mm - thin_mm, layer.top_z_mm)};
        for (const Prism& point : drilled_)
            if (point.bottom_z_mm < layer.top_z_mm && point.top_z_mm > layer.bottom_z_mm)
                gone.push_back(point.region);
        const Region ground = subtract(layer.part, gone, tol_);
        if (!ground.empty()) add(ground, layer.bottom_z_mm, layer.top_z_mm, found.stairs);
        return found;
    }

  private:
    void add(const Region& ground, double bottom_mm, double top_mm, std::vector<Obstacle>& into) const {
        deadline_.check(id_);
        const Region may_stand = at_end_.between(ground, bottom_mm, top_mm);
        if (may_stand.empty()) return;
        Region stands = at_end_.throughout(may_stand, bottom_mm, top_mm);
        const double height_mm = top_mm - bottom_mm;
        if (height_mm < 2 * kThinnestStairMm || isNearlyAll(stands, may_stand, bottom_mm, top_mm))
            return push({bottom_mm, top_mm, std::move(stands)}, into);
        const double middle_mm = onHeightStep((bottom_mm + top_mm) / 2);
        std::vector<Obstacle> above;
        parallelInvoke([&] { add(may_stand, bottom_mm, middle_mm, into); },
                       [&] { add(may_stand, middle_mm, top_mm, above); });
        for (Obstacle& stair : above)
            append(std::move(stair), into);
    }

    /// What stands at some height only does not count where the part is.
    bool isNearlyAll(const Region& stands, const Region& may_stand, double bottom_mm, double top_mm) const {
        const double height_mm = top_mm - bottom_mm;
        const Region unsure = subtract(may_stand, stands, tol_);
        if (area(unsure) * height_mm <= kLeftOutMm3) return true;
        const std::vector<Region> parts = partsBetween(bottom_mm, top_mm);
        const bool little_stands = area(stands) < kLittleShare * area(may_stand);
        const Region part = little_stands ? common(parts) : unite(parts, tol_);
        const double left_out_mm2 = area(subtract(unsure, part, tol_));
        return left_out_mm2 * height_mm <= kLeftOutMm3 ||
               left_out_mm2 <= kLeftOutShare * area(subtract(may_stand, part, tol_));
    }

    /// The part from level to level.
    std::vector<Region> partsBetween(double bottom_mm, double top_mm) const {
        std::vector<Region> sections;
        double low_mm = bottom_mm;
        std::vector<double> tops = part_.levelsBetween(bottom_mm, top_mm);
        tops.push_back(top_mm);
        for (const double high_mm : tops) {
            sections.push_back(part_.partBetween(low_mm, high_mm));
            low_mm = high_mm;
        }
        return sections;
    }

    /// Where setups before have cut under what leans, the part at some height says nothing: of one that is
    /// chamfered on both sides the edges above still stand.
    Region common(const std::vector<Region>& sections) const {
        Region all = sections.front();
        for (const Region& section : sections)
            all = intersect(all, section, tol_);
        return all;
    }

    void push(Obstacle stair, std::vector<Obstacle>& into) const {
        stair.section = toolpath::beyondSkins(stair.section, tol_);
        if (!stair.section.empty()) append(std::move(stair), into);
    }

    void append(Obstacle stair, std::vector<Obstacle>& into) const {
        const bool goes_on = !into.empty() && into.back().top_z_mm == stair.bottom_z_mm &&
                             feature::sameRegion(into.back().section, stair.section, tol_);
        if (goes_on)
            into.back().top_z_mm = stair.top_z_mm;
        else
            into.push_back(std::move(stair));
    }

    std::string id_;  ///< of the form ground
    const std::vector<Prism>& drilled_;
    const SectionCutter& part_;
    StockSections at_end_;
    const Tolerances& tol_;
    const Deadline& deadline_;
};

}  // namespace

std::vector<LayerStairs> stairsOf(const FormSources& sources, const SectionCutter& part,
                                  const Tolerances& tol, const Deadline& deadline) {
    const StairMaker maker(sources, part, tol, deadline);
    const std::vector<Layer>& layers = sources.layers.layers;
    std::vector<LayerStairs> all(layers.size());
    parallelFor(layers.size(), [&](std::size_t i) { all[i] = maker.of(layers[layers.size() - 1 - i]); });
    std::erase_if(all, [](const LayerStairs& one) { return one.stairs.empty(); });
    return all;
}

double mostStairsMm3(const LayerStack& layers) {
    double sum = 0;
    for (const Layer& layer : layers.layers)
        sum += seenFromAboveMm3(layer);
    return sum;
}

}  // namespace stepmill
