#include "access/suitability.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/access/collision.h"
#include "stepmill/feature/hole_group.h"

namespace stepmill::access {
namespace {

/// A drill makes a hole whose diameter differs from its own by no more than this [mm].
constexpr double kDrillFitMm = 0.02;

std::optional<Exclusion> withoutData(const ToolAssembly& tool, const std::string& material) {
    if (tool.cuttingFor(material)) return std::nullopt;
    return Exclusion{ExclusionReason::NoCuttingData, fmt::format("has no cutting data for {}", material)};
}

std::optional<Exclusion> wrongHole(const Feature& feature, const ToolAssembly& tool) {
    const auto wrong = [](std::string text) {
        return Exclusion{ExclusionReason::WrongType, std::move(text)};
    };
    if (feature.feature_class == FeatureClass::HoleBlind && feature.point_mm <= 0)
        return wrong("a drill's tip leaves a cone where the floor is flat");
    if (!isHole(feature.feature_class))
        return wrong(fmt::format("a drill makes holes, this is a {}", toString(feature.feature_class)));
    const double hole_mm = 2 * holeRadiusMm(feature);
    if (std::abs(tool.diameter_mm - hole_mm) > kDrillFitMm)
        return wrong(
            fmt::format("a drill of {:.4g} mm makes no hole of {:.4g} mm", tool.diameter_mm, hole_mm));
    return std::nullopt;
}

}  // namespace

std::optional<Exclusion> unsuitable(const FeatureGround& ground, const ToolAssembly& tool,
                                    const std::string& material) {
    if (tool.isTap())
        return Exclusion{ExclusionReason::WrongType, "a tap cuts threads into holes that are made"};
    if (tool.isSpot()) return Exclusion{ExclusionReason::WrongType, "a spot drill starts holes for drills"};
    if (tool.isCountersink())
        return Exclusion{ExclusionReason::WrongType, "a countersink goes into the cones of holes"};
    if (tool.isSizer())
        return Exclusion{
            ExclusionReason::WrongType,
            fmt::format("a {} tool brings bores to a fit where one is asked for", toString(tool.type))};
    if (tool.type == ToolType::Chamfer)
        return Exclusion{ExclusionReason::WrongType, "a chamfer mill leaves its cone on a flat floor"};
    if (tool.type == ToolType::Ball || tool.type == ToolType::Bull)
        return Exclusion{ExclusionReason::WrongType,
                         fmt::format("a {} cutter leaves its corner radius of {:.4g} mm on a flat floor",
                                     toString(tool.type), tool.corner_radius_mm)};
    if (auto exclusion = withoutData(tool, material)) return exclusion;
    const double pass_mm = std::min(tool.cuttingFor(material)->step_down_mm, ground.feature().depth_mm());
    if (tool.flute_length_mm > 0 && pass_mm > tool.flute_length_mm)
        return Exclusion{ExclusionReason::TooShort,
                         fmt::format("cuts {:.4g} mm deep a pass with {:.4g} mm of flutes", pass_mm,
                                     tool.flute_length_mm)};
    return std::nullopt;
}

std::optional<Exclusion> unsuitableDrill(const FeatureGround& ground, const ToolAssembly& tool,
                                         const std::string& material) {
    const Feature& feature = ground.feature();
    if (auto exclusion = wrongHole(feature, tool)) return exclusion;
    if (auto exclusion = withoutData(tool, material)) return exclusion;
    if (tool.flute_length_mm < feature.depth_mm())
        return Exclusion{ExclusionReason::TooShort,
                         fmt::format("{:.4g} mm of flutes clear no chips from a hole {:.4g} mm deep",
                                     tool.flute_length_mm, feature.depth_mm())};
    const std::vector<Vec2> axes = holeCentres(feature);
    for (const Blocker& blocker : blockers(feature, tool)) {
        const Region& section = feature.obstacles[blocker.obstacle].section;
        const bool touches = std::any_of(axes.begin(), axes.end(), [&](const Vec2& axis) {
            return contains(section, axis) || distanceToBoundary(section, axis) < blocker.radius_mm;
        });
        if (touches)
            return Exclusion{
                ExclusionReason::TooShort,
                fmt::format("its shank or holder, {:.4g} mm wide and {:.4g} mm over the tip{}, would "
                            "touch standing material before the tip is {:.4g} mm deep",
                            2 * blocker.radius_mm, blocker.height_mm, clearanceWords(tool),
                            feature.depth_mm())};
    }
    return std::nullopt;
}

}  // namespace stepmill::access
