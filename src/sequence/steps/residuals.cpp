#include "sequence/steps/residuals.h"

#include <limits>

#include <fmt/format.h>

#include "stepmill/access/swept.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/toolpath/swept_region.h"

namespace stepmill {
namespace {

/// Nobody sells narrower end mills [mm].
constexpr double kNarrowestCutterMm = 0.1;

std::string endMillOf(double widest_mm) {
    if (widest_mm < kNarrowestCutterMm) return "a relief in the design, or EDM: no cutter is so narrow";
    return fmt::format("an end mill of {:.4g} mm or less", widest_mm);
}

/// What could make the feature's ground: mills no wider than that, and in a hole a drill.
std::string cutterFor(const Feature& feature, double widest_mm) {
    const std::string mill = endMillOf(widest_mm);
    return isHole(feature.feature_class)
               ? fmt::format("a drill of {:.4g} mm or {}", 2 * holeRadiusMm(feature), mill)
               : mill;
}

void add(Residual& into, const Region& piece, double depth_mm) {
    append(into.region, piece);
    into.area_mm2 += area(piece);
    into.volume_mm3 = into.area_mm2 * depth_mm;
}

double widestDiscMm(const Region& region, const Tolerances& tol) {
    const auto disc = ClearanceDiagram(region, tol).largestInscribedDisc();
    return disc ? 2 * disc->radius_mm : 0;
}

std::string cornerAdvice(const Feature& feature) {
    if (feature.min_corner_radius_mm && *feature.min_corner_radius_mm > 0)
        return endMillOf(2 * *feature.min_corner_radius_mm);
    return "a corner radius or relief in the design, or EDM: no cutter makes a sharp inner corner";
}

/// The point of a drill leaves the rim of a flat floor: the hole less the cone under it.
std::vector<Residual> drillPoint(const Feature& feature, const ToolAssembly& drill) {
    const double left_mm3 = leftByPointMm3(feature, drill);
    if (left_mm3 <= 0) return {};
    Residual rim;
    rim.region = feature.target;
    rim.area_mm2 = feature.area_mm2;
    rim.volume_mm3 = left_mm3;
    rim.reason = {Reason::DrillPoint, {}};
    rim.advice =
        fmt::format("{} that reaches {:.4g} mm deep", endMillOf(drill.diameter_mm), feature.depth_mm());
    return {rim};
}

/// \param has_mm  the stick-out of the library's own
std::string longerTool(const std::string& kind, double diameter_mm, double stick_out_mm, double has_mm) {
    if (has_mm >= stick_out_mm)
        return fmt::format("{} of {:.4g} mm whose neck is no wider for {:.4g} mm", kind, diameter_mm,
                           stick_out_mm);
    return fmt::format("{} of {:.4g} mm with a stick-out of {:.4g} mm or a slimmer holder", kind, diameter_mm,
                       stick_out_mm);
}

std::string whatWouldClear(const Withheld& withheld) {
    if (withheld.holder_diameter_mm <= 0 || withheld.has_stick_out_mm >= withheld.stick_out_mm)
        return longerTool("an end mill", withheld.diameter_mm, withheld.stick_out_mm,
                          withheld.has_stick_out_mm);
    return fmt::format(
        "an end mill of {:.4g} mm with a stick-out of {:.4g} mm ({:.4g} mm more), or a holder no wider than "
        "{:.1f} mm below that",
        withheld.diameter_mm, withheld.stick_out_mm, withheld.stick_out_mm - withheld.has_stick_out_mm,
        withheld.holder_diameter_mm);
}

/// What the last tool covers on paper and no pass sweeps: there its centres are thinner than a sliver.
Region beyondPasses(const std::vector<const Candidate*>& used, const Tolerances& tol) {
    const Candidate& last = *used.back();
    Region missed = subtract(last.cleared->coverable, last.cleared->swept.region(), tol);
    for (const Candidate* tool : used)
        if (tool != &last && !missed.empty()) missed = subtract(missed, tool->cleared->swept.region(), tol);
    return toolpath::beyondSkins(missed, tol);
}

struct Vote {
    int count = 0;
    std::string text;  ///< of the first tool voted for
};

/// Could the cutter stand in the feature at all?
bool isNarrowEnough(const ToolReach& tool, double widest_mm) {
    return 2 * tool.cutter.radius_mm <= widest_mm;
}

Reason reasonFor(ExclusionReason reason) {
    switch (reason) {
        case ExclusionReason::HolderCollision:
            return Reason::HolderCollision;
        case ExclusionReason::TooShort:
            return Reason::TooDeep;
        case ExclusionReason::NoEntry:
            return Reason::NoWayIn;
        case ExclusionReason::NoCuttingData:
            return Reason::NoCuttingData;
        case ExclusionReason::TooWide:
        case ExclusionReason::WrongType:
            break;
    }
    return Reason::NoNarrowCutter;
}

std::string adviceFor(ExclusionReason reason, const std::string& cutter, double depth_mm) {
    switch (reason) {
        case ExclusionReason::HolderCollision:
            return fmt::format("{} with a longer stick-out than {:.4g} mm or a slimmer holder", cutter,
                               depth_mm);
        case ExclusionReason::TooShort:
            return fmt::format("{} that reaches {:.4g} mm deep", cutter, depth_mm);
        case ExclusionReason::NoEntry:
            return cutter + " that cuts over its centre, or a ramp angle in its cutting data";
        case ExclusionReason::NoCuttingData:
            return "cutting data for this material in the tool library";
        case ExclusionReason::TooWide:
        case ExclusionReason::WrongType:
            break;
    }
    return cutter;
}

}  // namespace

std::vector<Residual> residualsOf(const FeatureGround& ground, const std::vector<const Candidate*>& used,
                                  const std::optional<Withheld>& withheld) {
    const Feature& feature = ground.feature();
    const Tolerances& tol = ground.tolerances();
    const Candidate& last = *used.back();
    if (last.drill()) return drillPoint(feature, *last.tool);
    const Region missed = beyondPasses(used, tol);
    if (missed.empty() && feature.area_mm2 - last.coverable_mm2 <= sameArea(feature, tol)) return {};

    Region rest = feature.target;
    // With a free holder the last tool's area holds those of all before it.
    for (const Candidate* tool : used) {
        if (tool == &last || tool->isLimited() || last.isLimited())
            rest = subtract(rest, tool->cleared->coverable, tol);
    }
    if (!missed.empty()) rest = unite(rest, missed, tol);
    Residual held_off;
    if (withheld) {
        held_off.reason = {withheld->too_short ? Reason::TooDeep : Reason::HolderCollision, {}};
        held_off.advice = whatWouldClear(*withheld);
        for (const Region& piece : components(intersect(rest, withheld->coverable, tol)))
            if (area(piece) > tol.area_mm2) add(held_off, piece, feature.depth_mm());
        if (!held_off.region.empty()) rest = subtract(rest, withheld->coverable, tol);
    }
    // A cusp in a corner is smaller than the square over the cutter's radius; more than that lies behind a
    // neck or in a slot the cutter does not fit.
    const double cusp_mm2 = last.tool->radius_mm() * last.tool->radius_mm();
    Residual corners;
    corners.reason = {Reason::CornerRadius, {}};
    corners.advice = cornerAdvice(feature);
    Residual narrows;
    narrows.reason = {Reason::NoNarrowCutter, {}};
    double narrowest_mm = std::numeric_limits<double>::infinity();
    for (const Region& piece : components(rest)) {
        const double piece_mm2 = area(piece);
        if (piece_mm2 <= tol.area_mm2) continue;
        const bool corner = piece_mm2 <= cusp_mm2;
        add(corner ? corners : narrows, piece, feature.depth_mm());
        if (!corner) narrowest_mm = std::min(narrowest_mm, widestDiscMm(piece, tol));
    }
    narrows.advice = endMillOf(narrowest_mm);

    std::vector<Residual> result;
    for (Residual* residual : {&held_off, &narrows, &corners}) {
        if (!residual->region.empty()) result.push_back(std::move(*residual));
    }
    return result;
}

double residualVolumeMm3(const ToolSequence& sequence) {
    double volume_mm3 = 0;
    for (const Residual& residual : sequence.residual)
        volume_mm3 += residual.volume_mm3;
    return volume_mm3;
}

Residual belowReach(const Feature& feature, const Shallower& reached) {
    Residual below;
    below.region = feature.target;
    below.area_mm2 = feature.area_mm2;
    below.volume_mm3 = feature.area_mm2 * (reached.floor_z_mm - feature.floor_z_mm);
    below.reason = {Reason::TooDeep, fmt::format("the tools reach {:.4g} of {:.4g} mm",
                                                 feature.top_z_mm - reached.floor_z_mm, feature.depth_mm())};
    const bool drilled =
        isHole(feature.feature_class) && reached.diameter_mm >= 2 * holeRadiusMm(feature) - kDrillUndersizeMm;
    if (drilled && reached.by_flutes)
        below.advice = fmt::format("a drill of {:.4g} mm with flutes of {:.4g} mm", reached.diameter_mm,
                                   reached.stick_out_mm);
    else
        below.advice = longerTool(drilled ? "a drill" : "an end mill", reached.diameter_mm,
                                  reached.stick_out_mm, reached.has_stick_out_mm);
    return below;
}

Residual wholeFeature(const FeatureGround& ground, const std::vector<ToolReach>& reaches,
                      const ToolLibrary& library) {
    const Feature& feature = ground.feature();
    const double widest_mm = ground.widestCutterMm();
    std::map<ExclusionReason, Vote> votes;
    for (const ToolReach& tool : reaches) {
        const Exclusion* excluded = tool.exclusion();
        if (excluded == nullptr || excluded->reason == ExclusionReason::WrongType) continue;
        if (!isNarrowEnough(tool, widest_mm) || excluded->reason == ExclusionReason::TooWide) continue;
        Vote& vote = votes[excluded->reason];
        if (vote.count++ == 0) vote.text = library.tool(tool.tool_id).id + " " + excluded->text;
    }
    const auto most = std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
        return a.second.count < b.second.count;
    });
    const ExclusionReason reason = most == votes.end() ? ExclusionReason::TooWide : most->first;

    Residual whole;
    whole.region = feature.target;
    whole.area_mm2 = feature.area_mm2;
    whole.volume_mm3 = feature.volume_mm3;
    whole.reason = {reasonFor(reason), most != votes.end() ? most->second.text : std::string()};
    whole.advice = adviceFor(reason, cutterFor(feature, widest_mm), feature.depth_mm());
    const bool short_of_reach =
        reason == ExclusionReason::HolderCollision || reason == ExclusionReason::TooShort;
    if (const auto withheld = short_of_reach ? withheldFrom(ground, library, 0, reaches) : std::nullopt)
        whole.advice = whatWouldClear(*withheld);
    return whole;
}

}  // namespace stepmill
