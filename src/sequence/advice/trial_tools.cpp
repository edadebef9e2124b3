#include "sequence/advice/trial_tools.h"

#include <fmt/format.h>

#include "sequence/dag/candidate.h"
#include "stepmill/access/access_curve.h"
#include "stepmill/access/collision.h"
#include "stepmill/feature/hole_group.h"

namespace stepmill {
namespace {

/// Diameters end mills are usually sold in [mm].
constexpr double kUsualSeriesMm[] = {1,  1.5, 2,  2.5, 3,  4,  5,  6,  7,  8, 9,
                                     10, 12,  14, 16,  18, 20, 22, 25, 28, 32};
/// End mills are ground to order in steps of this [mm].
constexpr double kGrindingStepMm = 0.1;
/// Drills are sold in steps of this [mm] ...
constexpr double kDrillStepMm = 0.5;
/// ... and leave so much of the diameter to the mill after them.
constexpr double kPreDrillAllowanceMm = 0.2;
/// Two diameters nearer than this are the same cutter [mm].
constexpr double kSameDiameterMm = 0.05;
/// Cutting data reach this far beyond the narrowest and the widest tool of the library.
constexpr double kMostBeyond = 1.5;
/// A tool that stands out farther bends and chatters.
constexpr double kMostStickOutDiameters = 10;

/// Nearest tools of a library on both sides of a diameter, of equal ones the shortest; null where none is.
struct Neighbours {
    const ToolAssembly* narrower = nullptr;
    const ToolAssembly* wider = nullptr;
};

bool getsDown(const ToolAssembly& tool, double reach_mm) {
    return (tool.isDrill() ? tool.flute_length_mm : tool.stick_out_mm) >= reach_mm;
}

Neighbours neighboursOf(const ToolLibrary& library, ToolType type, double diameter_mm, double reach_mm,
                        const std::string& material) {
    Neighbours found;
    // Among equal diameters byFallingDiameter() has the shortest stick-out first.
    for (const ToolAssembly* tool : byFallingDiameter(library)) {
        if (tool->type != type || tool->cuttingFor(material) == nullptr || !getsDown(*tool, reach_mm))
            continue;
        if (tool->diameter_mm >= diameter_mm) {
            if (found.wider == nullptr || tool->diameter_mm < found.wider->diameter_mm) found.wider = tool;
        } else if (found.narrower == nullptr) {
            found.narrower = tool;
        }
    }
    return found;
}

/// Shank of a cutter between two: as wide as the cutter, or as theirs where they are wider than their
/// cutters.
double shankDiameter(const ToolAssembly& narrower, const ToolAssembly& wider, double diameter_mm) {
    double shank_mm = diameter_mm;
    for (const ToolAssembly* tool : {&narrower, &wider})
        if (tool->shank.diameter_mm > tool->diameter_mm)
            shank_mm = std::max(shank_mm, tool->shank.diameter_mm);
    return shank_mm;
}

/// What another cutter may do besides is not this one's: it goes by the usual rules.
CuttingData withoutExtras(CuttingData data) {
    data.slot_step_down_mm = data.slot_feed_mm_per_min = data.rated_removal_mm3_per_min = 0;
    data.adaptive.reset();
    return data;
}

CuttingData between(const CuttingData& a, const CuttingData& b, double share) {
    CuttingData data = withoutExtras(b);
    for (double CuttingData::*member :
         {&CuttingData::step_over_mm, &CuttingData::step_down_mm, &CuttingData::feed_mm_per_min,
          &CuttingData::plunge_feed_mm_per_min, &CuttingData::speed_rpm})
        data.*member = std::lerp(a.*member, b.*member, share);
    data.ramp_angle_deg = std::min(a.ramp_angle_deg, b.ramp_angle_deg);
    return data;
}

ToolAssembly betweenTools(const ToolAssembly& narrower, const ToolAssembly& wider, double diameter_mm,
                          const std::string& material) {
    const double share = (diameter_mm - narrower.diameter_mm) / (wider.diameter_mm - narrower.diameter_mm);
    const auto middle = [&](double a, double b) { return std::lerp(a, b, share); };
    ToolAssembly tool = wider;
    tool.flutes = std::min(narrower.flutes, wider.flutes);
    tool.centre_cutting = narrower.centre_cutting && wider.centre_cutting;
    tool.flute_length_mm = middle(narrower.flute_length_mm, wider.flute_length_mm);
    tool.price = middle(narrower.price, wider.price);
    tool.life_min = middle(narrower.life_min, wider.life_min);
    tool.shank.diameter_mm = shankDiameter(narrower, wider, diameter_mm);
    tool.shank.bottom_mm = middle(narrower.shank.bottom_mm, wider.shank.bottom_mm);
    tool.cutting = {between(*narrower.cuttingFor(material), *wider.cuttingFor(material), share)};
    return setTo(std::move(tool), middle(narrower.stick_out_mm, wider.stick_out_mm));
}

ToolAssembly scaledTool(const ToolAssembly& neighbour, double diameter_mm, const std::string& material) {
    const double scale = diameter_mm / neighbour.diameter_mm;
    ToolAssembly tool = neighbour;
    // A narrower cutter has shorter flutes; a wider one has no longer ones for sure.
    tool.flute_length_mm *= std::min(1.0, scale);
    tool.price *= std::max(1.0, scale);
    tool.shank.diameter_mm = std::max(tool.shank.diameter_mm, diameter_mm);
    tool.shank.bottom_mm *= std::min(1.0, scale);
    CuttingData data = withoutExtras(*neighbour.cuttingFor(material));
    data.step_over_mm *= scale;
    // What power and stiffness allow a wider cutter than any here is not known: it goes no deeper.
    data.step_down_mm *= std::min(1.0, scale);
    data.speed_rpm /= scale;
    tool.cutting = {data};
    return tool;
}

bool isStocked(const ToolLibrary& library, ToolType type, double diameter_mm, double reach_mm,
               const std::string& material) {
    return std::any_of(library.tools.begin(), library.tools.end(), [&](const ToolAssembly& tool) {
        return tool.type == type && std::abs(tool.diameter_mm - diameter_mm) < kSameDiameterMm &&
               getsDown(tool, reach_mm) && tool.cuttingFor(material) != nullptr;
    });
}

int nextNumber(const ToolLibrary& library) {
    int last = 0;
    for (const ToolAssembly& tool : library.tools)
        last = std::max(last, tool.number);
    return last + 1;
}

/// The widest that can be ground and still does what the event says.
double groundDiameter(const AccessEvent& event) {
    // A corner's own diameter still clears it; a neck's own does not pass it.
    const bool itself = event.kind == AccessEventKind::CornerRadius;
    constexpr double kRounding = 1e-3;
    const double most_mm = event.diameter_mm + (itself ? kRounding : -kRounding);
    return std::floor(most_mm / kGrindingStepMm) * kGrindingStepMm;
}

const char* wordsFor(AccessEventKind kind) {
    switch (kind) {
        case AccessEventKind::Neck:
            return "the widest that passes a neck of {:.4g} mm";
        case AccessEventKind::CornerRadius:
            return "the widest that clears corners for {:.4g} mm cutters";
        case AccessEventKind::Vanishes:
            return "the widest that enters a room of {:.4g} mm";
    }
    return "";
}

struct WantedDiameter {
    double diameter_mm;
    std::string why;
};

/// By rising diameter, each once; what an event asks for stands before the series.
std::vector<WantedDiameter> wantedDiameters(const FeatureGround& ground, double from_mm, double to_mm) {
    std::vector<WantedDiameter> wanted;
    const auto add = [&](double diameter_mm, const std::string& why) {
        if (diameter_mm < from_mm || diameter_mm > to_mm) return;
        const bool known = std::any_of(wanted.begin(), wanted.end(), [&](const WantedDiameter& other) {
            return std::abs(other.diameter_mm - diameter_mm) < kSameDiameterMm;
        });
        if (!known) wanted.push_back({diameter_mm, why});
    };
    for (const AccessEvent& event : accessCurve(ground, 0, to_mm).events)
        add(groundDiameter(event), fmt::format(fmt::runtime(wordsFor(event.kind)), event.diameter_mm));
    for (const double diameter_mm : kUsualSeriesMm)
        add(diameter_mm, "of the usual series");
    std::sort(wanted.begin(), wanted.end(),
              [](const WantedDiameter& a, const WantedDiameter& b) { return a.diameter_mm < b.diameter_mm; });
    return wanted;
}

}  // namespace

std::optional<ToolAssembly> interpolatedTool(const ToolLibrary& library, ToolType type, double diameter_mm,
                                             double reach_mm, const std::string& material) {
    const Neighbours near = neighboursOf(library, type, diameter_mm, reach_mm, material);
    ToolAssembly tool;
    if (near.narrower != nullptr && near.wider != nullptr) {
        tool = betweenTools(*near.narrower, *near.wider, diameter_mm, material);
    } else if (const ToolAssembly* only = near.wider != nullptr ? near.wider : near.narrower) {
        const double scale = diameter_mm / only->diameter_mm;
        if (scale > kMostBeyond || scale < 1 / kMostBeyond) return std::nullopt;
        tool = scaledTool(*only, diameter_mm, material);
    } else {
        return std::nullopt;
    }
    tool.id = fmt::format("new {} {:.4g}", type == ToolType::Drill ? "drill" : "end mill", diameter_mm);
    tool.number = nextNumber(library);
    tool.diameter_mm = diameter_mm;
    tool.stick_out_range.reset();
    tool.description.clear();
    tool.vendor.clear();
    tool.product_id.clear();
    return tool;
}

std::optional<ToolAssembly> withStickOut(ToolAssembly tool, double stick_out_mm) {
    const double whole_mm = std::ceil(stick_out_mm);
    if (whole_mm <= tool.stick_out_mm || whole_mm > kMostStickOutDiameters * tool.diameter_mm)
        return std::nullopt;
    const double share = tool.stick_out_mm / whole_mm;
    for (CuttingData& data : tool.cutting) {
        data = withoutExtras(std::move(data));
        data.step_down_mm *= share;
        data.feed_mm_per_min *= share;
        data.plunge_feed_mm_per_min *= share;
    }
    tool = setTo(std::move(tool), whole_mm);
    tool.stick_out_range.reset();
    tool.id = fmt::format("{} out {:.4g}", tool.id, whole_mm);
    return tool;
}

std::vector<TrialTool> trialMills(const FeatureGround& ground, const ToolLibrary& library,
                                  const std::string& material) {
    double widest_mm = 0;
    double narrowest_mm = std::numeric_limits<double>::infinity();
    for (const ToolAssembly& tool : library.tools) {
        if (tool.type != ToolType::Flat) continue;
        widest_mm = std::max(widest_mm, tool.diameter_mm);
        narrowest_mm = std::min(narrowest_mm, tool.diameter_mm);
    }
    std::vector<TrialTool> trials;
    const double to_mm = std::min(ground.widestCutterMm(), widest_mm * kMostBeyond);
    if (to_mm <= 0) return trials;
    const double reach_mm = ground.feature().depth_mm();
    for (const WantedDiameter& wanted : wantedDiameters(ground, narrowest_mm / kMostBeyond, to_mm)) {
        if (isStocked(library, ToolType::Flat, wanted.diameter_mm, reach_mm, material)) continue;
        if (auto tool = interpolatedTool(library, ToolType::Flat, wanted.diameter_mm, reach_mm, material))
            trials.push_back({std::move(*tool), wanted.why});
    }
    return trials;
}

std::optional<TrialTool> trialDrill(const FeatureGround& ground, const ToolLibrary& library,
                                    const std::string& material) {
    const Feature& feature = ground.feature();
    if (!isHole(feature.feature_class) || (hasFloor(feature.feature_class) && feature.point_mm <= 0))
        return std::nullopt;
    const double hole_mm = 2 * holeRadiusMm(feature);
    if (isStocked(library, ToolType::Drill, hole_mm, feature.depth_mm(), material)) return std::nullopt;
    auto tool = interpolatedTool(library, ToolType::Drill, hole_mm, feature.depth_mm(), material);
    if (!tool) return std::nullopt;
    return TrialTool{std::move(*tool), "drills the hole at once"};
}

std::optional<TrialTool> trialPreDrill(const FeatureGround& ground, const ToolLibrary& library,
                                       const std::string& material) {
    const Feature& feature = ground.feature();
    if (!isHole(feature.feature_class)) return std::nullopt;
    const double hole_mm = 2 * holeRadiusMm(feature);
    double widest_mm = std::floor((hole_mm - kPreDrillAllowanceMm) / kDrillStepMm) * kDrillStepMm;
    for (; widest_mm > hole_mm / 2; widest_mm -= kDrillStepMm) {
        if (isStocked(library, ToolType::Drill, widest_mm, feature.depth_mm(), material)) return std::nullopt;
        auto tool = interpolatedTool(library, ToolType::Drill, widest_mm, feature.depth_mm(), material);
        if (tool) return TrialTool{std::move(*tool), "makes room for the mill", true};
    }
    return std::nullopt;
}

namespace {

/// What clears obstacles and, for a tool that is too short, what it leaves of the feature itself.
double stickOutThatDoes(const FeatureGround& ground, const ToolAssembly& tool, const CutterArea& cutter,
                        ExclusionReason excluded_for) {
    const double beside_obstacles_mm = depthLimitOf(ground, tool, cutter).stick_out_mm;
    if (excluded_for != ExclusionReason::TooShort) return beside_obstacles_mm;
    const double lacks_mm = ground.feature().depth_mm() - access::freeReachMm(tool);
    return lacks_mm > 0 ? std::max(beside_obstacles_mm, tool.stick_out_mm + lacks_mm) : beside_obstacles_mm;
}

}  // namespace

std::vector<TrialTool> longerTools(const FeatureGround& ground, const ToolLibrary& library,
                                   const std::vector<ToolReach>& reaches) {
    std::vector<TrialTool> trials;
    for (const ToolReach& reach : reaches) {
        const ToolAssembly& tool = library.tool(reach.tool_id);
        if (tool.isForHoles()) continue;
        const Exclusion* excluded = reach.exclusion();
        const bool kept_off = excluded != nullptr && (excluded->reason == ExclusionReason::TooShort ||
                                                      excluded->reason == ExclusionReason::HolderCollision);
        if (!kept_off) continue;
        auto longer = withStickOut(tool, stickOutThatDoes(ground, tool, reach.cutter, excluded->reason));
        if (!longer) continue;
        std::string why = fmt::format("{} with {:.4g} instead of {:.4g} mm of stick-out clears its holder",
                                      tool.id, longer->stick_out_mm, tool.stick_out_mm);
        longer->number = nextNumber(library);
        trials.push_back({std::move(*longer), std::move(why)});
    }
    return trials;
}

}  // namespace stepmill
