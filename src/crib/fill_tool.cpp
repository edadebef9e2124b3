#include "stepmill/crib/fill_tool.h"

#include <algorithm>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// Feeds and speeds are told in steps that people read [1/min, mm/min].
constexpr double kSpeedStep = 10;
constexpr double kFeedStep = 5;

double rounded(double value, double step) {
    return std::max(step, std::floor(value / step) * step);
}

/// Fills one tool and keeps a record of it.
class Filler {
  public:
    explicit Filler(ToolAssembly& tool) : tool_(tool) {}

    std::vector<FilledField> filled() && { return std::move(filled_); }

    void fill(const UsualAssembly& usual) {
        const double diameter_mm = tool_.diameter_mm;
        if (tool_.flutes == 0 && usual.flutes > 0) {
            tool_.flutes = usual.flutes;
            note("flutes", usual.source);
        }
        if (tool_.flute_length_mm == 0 && usual.flute_length_diameters > 0) {
            // Flutes that are not told are no longer than a stick-out that is.
            const double most_mm = tool_.stick_out_mm > 0 ? tool_.stick_out_mm : 1e9;
            tool_.flute_length_mm = std::min(usual.flute_length_diameters * diameter_mm, most_mm);
            tool_.shank.bottom_mm = std::max(tool_.shank.bottom_mm, tool_.flute_length_mm);
            note("flute_length", usual.source);
        }
        if (tool_.stick_out_mm == 0 && usual.stick_out_diameters > 0) {
            const double least_mm =
                std::max(tool_.flute_length_mm, tool_.shank.bottom_mm) + usual.over_flutes_mm;
            tool_ = setTo(std::move(tool_), std::max(usual.stick_out_diameters * diameter_mm, least_mm));
            note("stick_out", usual.source);
        }
        if (tool_.holder.empty() && tool_.stick_out_mm > 0) fillHolder(usual);
        if (tool_.life_min == 0 && usual.life_min > 0) {
            tool_.life_min = usual.life_min;
            note("life_min", usual.source);
        }
    }

    void fill(const UsualCutting& usual) {
        const auto own =
            std::find_if(tool_.cutting.begin(), tool_.cutting.end(),
                         [&](const CuttingData& data) { return data.material == usual.material; });
        if (own == tool_.cutting.end())
            addCutting(usual);
        else
            fillSteps(*own, usual);
    }

  private:
    void note(const std::string& field, const std::string& source) { filled_.push_back({field, source}); }

    void fillHolder(const UsualAssembly& usual) {
        double at_mm = tool_.stick_out_mm;
        for (const UsualCylinder& cylinder : usual.holder) {
            tool_.holder.push_back({cylinder.diameter_mm, at_mm, at_mm + cylinder.height_mm});
            at_mm += cylinder.height_mm;
        }
        if (!usual.holder.empty()) note("holder", usual.source);
    }

    double stepDownMm(const UsualCutting& usual) const {
        return std::min(usual.step_down_diameters * tool_.diameter_mm, tool_.flute_length_mm);
    }

    void fillSteps(CuttingData& data, const UsualCutting& usual) {
        if (tool_.isTap()) return;
        if (data.step_down_mm == 0 && usual.step_down_diameters > 0) {
            data.step_down_mm = stepDownMm(usual);
            note("cutting/" + data.material + "/step_down", usual.source);
        }
        if (data.step_over_mm == 0 && !tool_.isForHoles() && usual.step_over_diameters > 0) {
            data.step_over_mm = usual.step_over_diameters * tool_.diameter_mm;
            note("cutting/" + data.material + "/step_over", usual.source);
        }
    }

    /// Feed of a turn [mm]; 0 where it cannot be told.
    double feedPerTurnMm(const UsualCutting& usual) const {
        if (tool_.isTap()) return tool_.thread ? tool_.thread->pitch_mm : 0;
        if (usual.feed_per_turn_diameters > 0) return usual.feed_per_turn_diameters * tool_.diameter_mm;
        return usual.feed_per_tooth_diameters * tool_.diameter_mm * tool_.flutes;
    }

    void addCutting(const UsualCutting& usual) {
        CuttingData data;
        data.material = usual.material;
        const double rpm = usual.cutting_speed_m_per_min * 1000 / (kPi * tool_.diameter_mm);
        data.speed_rpm = rounded(usual.most_rpm > 0 ? std::min(rpm, usual.most_rpm) : rpm, kSpeedStep);
        const double feed = feedPerTurnMm(usual) * data.speed_rpm;
        if (feed < kFeedStep) return;
        data.feed_mm_per_min = tool_.isTap() ? feed : rounded(feed, kFeedStep);
        if (usual.plunge_share > 0)
            data.plunge_feed_mm_per_min = rounded(usual.plunge_share * data.feed_mm_per_min, kFeedStep);
        data.ramp_angle_deg = usual.ramp_angle_deg;
        if (!tool_.isTap()) data.step_down_mm = stepDownMm(usual);
        if (!tool_.isForHoles()) data.step_over_mm = usual.step_over_diameters * tool_.diameter_mm;
        tool_.cutting.push_back(std::move(data));
        note("cutting/" + usual.material, usual.source);
    }

    ToolAssembly& tool_;
    std::vector<FilledField> filled_;
};

}  // namespace

std::vector<FilledField> fillFrom(const UsualValues& usual, ToolAssembly& tool) {
    Filler filler(tool);
    const auto assembly = std::find_if(usual.assemblies.begin(), usual.assemblies.end(),
                                       [&](const UsualAssembly& entry) { return entry.tools.fits(tool); });
    if (assembly != usual.assemblies.end()) filler.fill(*assembly);
    std::set<std::string> done;
    for (const UsualCutting& entry : usual.cutting)
        if (entry.tools.fits(tool) && done.insert(entry.material).second) filler.fill(entry);
    return std::move(filler).filled();
}

}  // namespace stepmill
