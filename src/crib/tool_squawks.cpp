#include "stepmill/crib/tool_squawks.h"

#include <algorithm>

#include <fmt/format.h>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// A tool that stands out farther bends so much that rules of thumb forbid it [diameters].
constexpr double kSlender = 8;
/// Cutting speeds that no cutter of today has [m/min].
constexpr double kFastest = 2000;
constexpr double kSlowest = 1;
/// Feeds of a tooth that are no chip but a typing error [diameters].
constexpr double kThickestChip = 0.1;
constexpr double kThinnestChip = 1e-4;

class Squawker {
  public:
    explicit Squawker(std::vector<ToolSquawk>& squawks) : squawks_(squawks) {}

    void look(const ToolAssembly& tool, const std::vector<FilledField>& filled_fields) {
        tool_ = &tool;
        if (tool.holder.empty())
            say(SquawkGrade::Danger, "no holder is known: nothing keeps it off part and fixture");
        for (const FilledField& filled : filled_fields)
            say(lengthOfTheAssembly(filled.field) ? SquawkGrade::Danger : SquawkGrade::Caution,
                fmt::format("{} was never measured: {}", filled.field, filled.source));
        if (tool.stick_out_mm > kSlender * std::max(tool.diameter_mm, thinnestAboveMm(tool)))
            say(SquawkGrade::Caution,
                fmt::format("stands out {:.3g} diameters: it bends", tool.stick_out_mm / tool.diameter_mm));
        if (tool.cutting.empty()) say(SquawkGrade::Caution, "no cutting data: no plan takes it");
        for (const CuttingData& data : tool.cutting)
            look(data);
        lookForGaps();
    }

  private:
    /// A longer one than thought hits what a plan holds for free.
    static bool lengthOfTheAssembly(const std::string& field) {
        return field == "stick_out" || field == "holder" || field == "flute_length";
    }

    static double thinnestAboveMm(const ToolAssembly& tool) {
        return tool.shank.diameter_mm > 0 ? std::min(tool.shank.diameter_mm, tool.diameter_mm) : 0;
    }

    void look(const CuttingData& data) {
        constexpr double kMmPerMetre = 1000;
        const double speed = kPi * tool_->diameter_mm * data.speed_rpm / kMmPerMetre;
        if (speed > kFastest || speed < kSlowest)
            say(SquawkGrade::Caution, fmt::format("{}: {:.0f} rpm is {:.3g} m/min; is that a typing error?",
                                                  data.material, data.speed_rpm, speed));
        if (tool_->isTap()) return;
        const int teeth = std::max(1, tool_->flutes);
        const double chip = data.feed_mm_per_min / data.speed_rpm / teeth / tool_->diameter_mm;
        if (chip > kThickestChip || chip < kThinnestChip)
            say(SquawkGrade::Caution,
                fmt::format("{}: a feed of {:.3g} mm a tooth on {:.4g} mm; is that a typing error?",
                            data.material, chip * tool_->diameter_mm, tool_->diameter_mm));
        if (!tool_->isForHoles() && data.ramp_angle_deg == 0 && tool_->max_plunge_mm == 0)
            say(SquawkGrade::Note, data.material +
                                       ": no ramp angle and no plunge depth: it enters from outside "
                                       "alone");
    }

    void lookForGaps() {
        if (tool_->flutes == 0 && !tool_->isForHoles())
            say(SquawkGrade::Note, "flutes are not told: feeds are not set by what is cut");
        if (tool_->life_min == 0) say(SquawkGrade::Note, "no tool life: its wear costs nothing");
        if (tool_->price == 0) say(SquawkGrade::Note, "no price: its wear costs nothing");
    }

    void say(SquawkGrade grade, std::string text) { squawks_.push_back({grade, tool_->id, std::move(text)}); }

    std::vector<ToolSquawk>& squawks_;
    const ToolAssembly* tool_ = nullptr;
};

}  // namespace

std::vector<ToolSquawk> toolSquawks(const ToolLibrary& library, const FilledFields& all_filled) {
    std::vector<ToolSquawk> squawks;
    for (const std::string& field : library.unknown_fields)
        squawks.push_back(
            {SquawkGrade::Note, "", field + " is no field of tool libraries: it changes nothing"});
    Squawker squawker(squawks);
    for (const ToolAssembly& tool : library.tools) {
        const auto filled = all_filled.find(tool.id);
        squawker.look(tool, filled == all_filled.end() ? std::vector<FilledField>{} : filled->second);
    }
    std::stable_sort(squawks.begin(), squawks.end(),
                     [](const ToolSquawk& a, const ToolSquawk& b) { return a.grade < b.grade; });
    return squawks;
}

}  // namespace stepmill
