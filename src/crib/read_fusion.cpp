// Tool libraries of Fusion. Fields and their meaning were taken from libraries that Fusion exported: lengths
// and feeds in the tool's unit, angles in degrees, TA per side, LB what stands out of the holder, the
// holder's segments from the tip's side up.

#include <algorithm>

#include <fmt/format.h>

#include "crib/json_reader.h"
#include "crib/tool_maker.h"
#include "crib/type_words.h"
#include "stepmill/core/error.h"
#include "stepmill/crib/read_foreign.h"

namespace stepmill {
namespace {

using crib::fieldText;
using crib::JsonReader;

/// Tapers below this are rounding [degrees].
constexpr double kUprightDeg = 1e-6;
/// Lengths that differ by less are the same [mm].
constexpr double kSameMm = 1e-6;

class FusionTool {
  public:
    FusionTool(const JsonReader& from, const std::string& file, const ForeignOptions& options)
        : from_(from), file_(file), options_(options) {}

    ForeignTool read() {
        foreign_.place = from_.pointer();
        takeWords();
        if (!foreign_.unfit.empty()) return std::move(foreign_);
        takeUnit();
        const std::optional<JsonReader> geometry = from_.object("geometry");
        if (geometry) takeGeometry(*geometry);
        takeHolder();
        takePresets();
        crib::finishTool(foreign_, geometry ? mm(*geometry, "TP") : 0, file_, options_);
        return std::move(foreign_);
    }

  private:
    double mm(const JsonReader& from, const char* field) const { return mm_per_unit_ * from.positive(field); }

    void takeWords() {
        ToolAssembly& tool = foreign_.tool;
        const std::string type = from_.text("type");
        const crib::TypeWord word = crib::typeOfWords(type);
        if (word.type) crib::setType(tool, *word.type);
        if (!word.type)
            foreign_.unfit = !word.unfit.empty() ? word.unfit
                                                 : fmt::format("'{}' is no type of tool that Stepmill knows",
                                                               fieldText(type, 60));
        tool.description = fieldText(from_.text("description"), 900);
        tool.vendor = fieldText(from_.text("vendor"), 900);
        tool.product_id = fieldText(from_.text("product-id"), 900);
        if (from_.text("BMC") == "hss") tool.cutter_material = CutterMaterial::Hss;
        if (const auto post = from_.object("post-process")) {
            tool.number = static_cast<int>(std::clamp(post->number("number"), 0.0, 99999.0));
            tool.id = fieldText(post->text("comment"), 100);
        }
    }

    void takeUnit() {
        const auto unit = crib::mmPerUnit(from_.text("unit"));
        if (!unit) from_.refuseField("unit", "\"millimeters\" or \"inches\"");
        mm_per_unit_ = *unit;
        foreign_.is_inch = mm_per_unit_ != 1;
    }

    void takeGeometry(const JsonReader& geometry) {
        ToolAssembly& tool = foreign_.tool;
        tool.diameter_mm = mm(geometry, "DC");
        tool.flute_length_mm = mm(geometry, "LCF");
        tool.stick_out_mm = mm(geometry, "LB");
        tool.flutes = static_cast<int>(std::clamp(geometry.positive("NOF"), 0.0, 100.0));
        takeForm(geometry);
        takeShank(geometry);
        if (!geometry.flag("HAND", true)) foreign_.unfit = "it cuts left-handed";
    }

    void takeForm(const JsonReader& geometry) {
        ToolAssembly& tool = foreign_.tool;
        const double taper_deg = geometry.number("TA");
        if (tool.type == ToolType::Bull || tool.type == ToolType::Face)
            tool.corner_radius_mm = mm(geometry, "RE");
        if (tool.type == ToolType::Flat && mm(geometry, "RE") > 0) {
            tool.type = ToolType::Bull;
            tool.corner_radius_mm = mm(geometry, "RE");
            foreign_.notes.push_back("a flat end mill with a corner radius: taken as a bull nose");
        }
        if ((tool.isDrill() || tool.isSpot()) && geometry.number("SIG") > 0)
            tool.point_angle_deg = geometry.number("SIG");
        if (tool.type == ToolType::Chamfer) {
            tool.tip_diameter_mm = mm(geometry, "tip-diameter");
            tool.included_angle_deg = 2 * taper_deg;
        } else if (tool.isCountersink()) {
            tool.tip_diameter_mm = mm(geometry, "tip-diameter");
            tool.included_angle_deg = geometry.number("SIG");
        } else if (!tool.isForHoles() && tool.type != ToolType::Face && std::abs(taper_deg) > kUprightDeg) {
            foreign_.unfit =
                fmt::format("its flanks lean by {:.6g} degrees; cutters here are upright", taper_deg);
        }
    }

    /// The neck counts as shank where it is thicker than the cutter.
    void takeShank(const JsonReader& geometry) {
        ToolAssembly& tool = foreign_.tool;
        const double shaft_mm = mm(geometry, "SFDM");
        const double shoulder_mm = mm(geometry, "shoulder-diameter");
        const double shoulder_length_mm = mm(geometry, "shoulder-length");
        const bool thick_shoulder = shoulder_mm > tool.diameter_mm + kSameMm;
        if (shaft_mm == 0 && !thick_shoulder) return;
        tool.shank.diameter_mm = std::max(shaft_mm, thick_shoulder ? shoulder_mm : 0.0);
        const double from_mm = thick_shoulder ? tool.flute_length_mm : shoulder_length_mm;
        tool.shank.bottom_mm = std::max(from_mm, tool.flute_length_mm);
        tool.shank.top_mm = tool.stick_out_mm;
        takeShaft();
    }

    /// A shaft that grows on its way up is as thick as its thickest from the start.
    void takeShaft() {
        const auto shaft = from_.object("shaft");
        if (!shaft) return;
        for (const JsonReader& segment : shaft->list("segments"))
            for (const char* end : {"lower-diameter", "upper-diameter"})
                foreign_.tool.shank.diameter_mm = std::max(foreign_.tool.shank.diameter_mm, mm(segment, end));
    }

    /// Cones become cylinders of their thicker end.
    void takeHolder() {
        const auto holder = from_.object("holder");
        if (!holder) return;
        const auto own_unit = crib::mmPerUnit(holder->text("unit"));
        if (holder->has("unit") && !own_unit) holder->refuseField("unit", "\"millimeters\" or \"inches\"");
        const double unit_mm = own_unit.value_or(mm_per_unit_);
        bool any_cone = false;
        for (const JsonReader& segment : holder->list("segments")) {
            const double lower_mm = unit_mm * segment.positive("lower-diameter");
            const double upper_mm = unit_mm * segment.positive("upper-diameter");
            const double height_mm = unit_mm * segment.positive("height");
            if (height_mm == 0) continue;
            any_cone = any_cone || std::abs(lower_mm - upper_mm) > kSameMm;
            foreign_.tool.holder.push_back({std::max(lower_mm, upper_mm), 0, height_mm});
        }
        crib::stackHolder(foreign_.tool);
        if (any_cone)
            foreign_.notes.push_back("cones of its holder are taken as cylinders of their thicker end");
    }

    void takePresets() {
        const auto values = from_.object("start-values");
        if (!values) return;
        for (const JsonReader& preset : values->list("presets"))
            takePreset(preset);
    }

    void takePreset(const JsonReader& preset) {
        CuttingData data;
        const std::string name = preset.text("name");
        data.material = crib::materialName(options_, name, queriedMaterial(preset));
        data.speed_rpm = preset.positive("n");
        data.feed_mm_per_min = feed(preset, data.speed_rpm);
        data.plunge_feed_mm_per_min = mm(preset, "v_f_plunge");
        if (preset.flag("use-stepdown", true)) data.step_down_mm = mm(preset, "stepdown");
        if (preset.flag("use-stepover", true)) data.step_over_mm = mm(preset, "stepover");
        data.ramp_angle_deg = preset.positive("ramp-angle");
        data.coolant = coolantOf(preset.text("tool-coolant"));
        crib::addCutting(foreign_, name, std::move(data));
    }

    /// Of a preset that is for all materials its name is all there is.
    static std::string queriedMaterial(const JsonReader& preset) {
        const auto material = preset.object("material");
        if (!material) return {};
        const std::string query = material->text("query");
        const std::string category = material->text("category");
        return !query.empty() ? query : category == "all" ? std::string() : category;
    }

    double feed(const JsonReader& preset, double speed_rpm) const {
        if (const double feed_mm = mm(preset, "v_f"); feed_mm > 0) return feed_mm;
        if (const double per_turn_mm = mm(preset, "f_n"); per_turn_mm > 0) return per_turn_mm * speed_rpm;
        if (foreign_.tool.isDrill() && preset.has("v_f_plunge")) return mm(preset, "v_f_plunge");
        return mm(preset, "f_z") * foreign_.tool.flutes * speed_rpm;
    }

    static Coolant coolantOf(const std::string& word) {
        if (word == "disabled" || word == "off" || word == "air" || word == "suction") return Coolant::Off;
        return word == "mist" ? Coolant::Mist : Coolant::Flood;
    }

    const JsonReader& from_;
    const std::string& file_;
    const ForeignOptions& options_;
    double mm_per_unit_ = 1;
    ForeignTool foreign_;
};

}  // namespace

ForeignLibrary fusionFromText(std::string_view text, const std::string& name, const ForeignOptions& options) {
    const nlohmann::json root = JsonReader::parse(text, name);
    const JsonReader reader(root, name);
    if (!reader.has("data"))
        crib::refuse(name, "#", "expected the list \"data\" of a Fusion tool library, found none");
    ForeignLibrary library{name, {}};
    for (const JsonReader& tool : reader.list("data")) {
        if (library.tools.size() == crib::kMostTools)
            crib::refuse(name, tool.pointer(), fmt::format("expected at most {} tools", crib::kMostTools));
        library.tools.push_back(FusionTool(tool, name, options).read());
    }
    return library;
}

}  // namespace stepmill
