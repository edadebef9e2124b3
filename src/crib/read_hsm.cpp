// Tool libraries of HSMWorks, Inventor CAM and early Fusion (.hsmlib). What attributes mean was checked by
// arithmetic on libraries that those programs wrote: taper-angle is the whole angle of drills and half that
// of chamfer mills, body-length is what stands out of the holder, a holder's section of length 0 is a step.

#include <algorithm>
#include <charconv>
#include <cstring>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "crib/tool_maker.h"
#include "crib/type_words.h"
#include "stepmill/crib/read_foreign.h"

namespace stepmill {
namespace {

using crib::fieldText;

constexpr double kUprightHsmDeg = 1e-6;

class HsmTool {
  public:
    HsmTool(const pugi::xml_node& from, std::size_t index, const std::string& file,
            const ForeignOptions& options)
        : from_(from), file_(file), options_(options) {
        foreign_.place = fmt::format("tool {}", index + 1);
    }

    ForeignTool read() {
        takeWords();
        if (!foreign_.unfit.empty()) return std::move(foreign_);
        takeUnit();
        const pugi::xml_node body = from_.child("body");
        takeBody(body);
        takeHolder();
        takeCutting();
        crib::finishTool(foreign_, mm(body, "thread-pitch"), file_, options_);
        return std::move(foreign_);
    }

  private:
    double number(const pugi::xml_node& node, const char* attribute) const {
        const pugi::xml_attribute found = node.attribute(attribute);
        if (!found || *found.value() == '\0') return 0;
        return parsed(found.value(), fmt::format("{}/@{}", node.name(), attribute));
    }

    double parsed(const char* text, const std::string& what) const {
        const std::optional<double> value = crib::numberOf(text);
        if (!value || *value < 0)
            crib::refuse(file_, fmt::format("{}, {}", foreign_.place, what),
                         fmt::format("expected a number of 0 or more, found '{}'", fieldText(text, 40)));
        return *value;
    }

    double mm(const pugi::xml_node& node, const char* attribute) const {
        return mm_per_unit_ * number(node, attribute);
    }

    void takeWords() {
        ToolAssembly& tool = foreign_.tool;
        const std::string type = from_.attribute("type").value();
        const crib::TypeWord word = crib::typeOfWords(type);
        if (word.type) crib::setType(tool, *word.type);
        if (!word.type)
            foreign_.unfit = !word.unfit.empty() ? word.unfit
                                                 : fmt::format("'{}' is no type of tool that Stepmill knows",
                                                               fieldText(type, 60));
        tool.description = fieldText(from_.child_value("description"), 900);
        tool.vendor = fieldText(from_.child_value("manufacturer"), 900);
        tool.product_id = fieldText(from_.child_value("product-id"), 900);
        tool.id = fieldText(from_.child_value("comment"), 100);
        if (std::strcmp(from_.child("material").attribute("name").value(), "hss") == 0)
            tool.cutter_material = CutterMaterial::Hss;
        tool.number = static_cast<int>(std::clamp(number(from_.child("nc"), "number"), 0.0, 99999.0));
    }

    void takeUnit() {
        const std::string unit = from_.attribute("unit").value();
        const auto known = crib::mmPerUnit(unit);
        if (!known)
            crib::refuse(file_, foreign_.place + ", @unit",
                         fmt::format("expected 'millimeters' or 'inches', found '{}'", fieldText(unit, 40)));
        mm_per_unit_ = *known;
        foreign_.is_inch = mm_per_unit_ != 1;
    }

    void takeBody(const pugi::xml_node& body) {
        ToolAssembly& tool = foreign_.tool;
        tool.diameter_mm = mm(body, "diameter");
        tool.flute_length_mm = mm(body, "flute-length");
        tool.stick_out_mm = mm(body, "body-length");
        tool.flutes = static_cast<int>(std::clamp(number(body, "number-of-flutes"), 0.0, 100.0));
        takeForm(body);
        const double shaft_mm = mm(body, "shaft-diameter");
        const double shoulder_mm = mm(body, "shoulder-diameter");
        const bool thick_shoulder = shoulder_mm > tool.diameter_mm;
        if (shaft_mm == 0 && !thick_shoulder) return;
        tool.shank = {std::max(shaft_mm, thick_shoulder ? shoulder_mm : 0.0),
                      std::max(thick_shoulder ? 0.0 : mm(body, "shoulder-length"), tool.flute_length_mm),
                      tool.stick_out_mm};
    }

    void takeForm(const pugi::xml_node& body) {
        ToolAssembly& tool = foreign_.tool;
        const double taper_deg = number(body, "taper-angle");
        if (tool.type == ToolType::Bull || tool.type == ToolType::Face)
            tool.corner_radius_mm = mm(body, "corner-radius");
        if ((tool.isDrill() || tool.isSpot()) && taper_deg > 0) tool.point_angle_deg = taper_deg;
        if (tool.type == ToolType::Chamfer) {
            tool.tip_diameter_mm = mm(body, "tip-diameter");
            tool.included_angle_deg = 2 * taper_deg;
        } else if (tool.isCountersink()) {
            tool.tip_diameter_mm = mm(body, "tip-diameter");
            tool.included_angle_deg = taper_deg;
        } else if (!tool.isForHoles() && tool.type != ToolType::Face && taper_deg > kUprightHsmDeg) {
            foreign_.unfit =
                fmt::format("its flanks lean by {:.6g} degrees; cutters here are upright", taper_deg);
        }
    }

    /// Sections tell the diameter that the profile has reached after their length: cones become cylinders of
    /// their thicker end.
    void takeHolder() {
        double before_mm = 0;
        for (const pugi::xml_node& section : from_.child("holder").children("section")) {
            const double diameter_mm = mm(section, "diameter");
            const double length_mm = mm(section, "length");
            if (length_mm > 0)
                foreign_.tool.holder.push_back({std::max(before_mm, diameter_mm), 0, length_mm});
            before_mm = diameter_mm;
        }
        crib::stackHolder(foreign_.tool);
    }

    /// Newer files have presets, older ones a motion for whatever is cut.
    void takeCutting() {
        const pugi::xml_node presets = from_.child("presets");
        for (const pugi::xml_node& preset : presets.children("preset"))
            takePreset(preset);
        const pugi::xml_node motion = from_.child("motion");
        if (motion && !presets.child("preset")) takeMotion(motion);
    }

    void takePreset(const pugi::xml_node& preset) {
        CuttingData data;
        const std::string name = preset.attribute("name").value();
        const auto parameter = [&](const char* key) {
            const pugi::xml_node found = preset.find_child_by_attribute("parameter", "key", key);
            const char* value = found.attribute("value").value();
            return *value == '\0' ? 0.0 : parsed(value, fmt::format("parameter {}", key));
        };
        data.material = crib::materialName(options_, name, "");
        data.speed_rpm = parameter("tool_spindleSpeed");
        data.feed_mm_per_min = mm_per_unit_ * parameter("tool_feedCutting");
        data.plunge_feed_mm_per_min = mm_per_unit_ * parameter("tool_feedPlunge");
        if (foreign_.tool.isDrill() && data.plunge_feed_mm_per_min > 0)
            data.feed_mm_per_min = data.plunge_feed_mm_per_min;
        data.step_down_mm = mm_per_unit_ * parameter("tool_stepdown");
        data.step_over_mm = mm_per_unit_ * parameter("tool_stepover");
        data.coolant = coolant();
        crib::addCutting(foreign_, name, std::move(data));
    }

    void takeMotion(const pugi::xml_node& motion) {
        CuttingData data;
        data.material = crib::materialName(options_, "motion", "");
        data.speed_rpm = number(motion, "spindle-rpm");
        data.feed_mm_per_min = mm(motion, "cutting-feedrate");
        data.plunge_feed_mm_per_min = mm(motion, "plunge-feedrate");
        if (std::strcmp(motion.attribute("feed-mode").value(), "per-revolution") == 0) {
            data.feed_mm_per_min *= data.speed_rpm;
            data.plunge_feed_mm_per_min *= data.speed_rpm;
        }
        data.coolant = coolant();
        crib::addCutting(foreign_, "motion", std::move(data));
    }

    Coolant coolant() const {
        const std::string mode = from_.child("coolant").attribute("mode").value();
        if (mode == "disabled" || mode == "off" || mode == "air") return Coolant::Off;
        return mode == "mist" ? Coolant::Mist : Coolant::Flood;
    }

    const pugi::xml_node& from_;
    const std::string& file_;
    const ForeignOptions& options_;
    double mm_per_unit_ = 1;
    ForeignTool foreign_;
};

}  // namespace

ForeignLibrary hsmFromText(std::string_view text, const std::string& name, const ForeignOptions& options) {
    pugi::xml_document document;
    // The default: document types are skipped, and entities that one would declare stay as they are written.
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size(), pugi::parse_default);
    if (!parsed)
        crib::refuse(name, fmt::format("byte {}", parsed.offset),
                     fmt::format("expected XML, found a fault: {}", parsed.description()));
    const pugi::xml_node root = document.document_element();
    if (std::strcmp(root.name(), "tool-library") != 0 && std::strcmp(root.name(), "tool-table") != 0)
        crib::refuse(name, "root",
                     fmt::format("expected <tool-library>, found <{}>", fieldText(root.name(), 40)));
    ForeignLibrary library{name, {}};
    for (const pugi::xml_node& tool : root.children("tool")) {
        if (library.tools.size() == crib::kMostTools)
            crib::refuse(name, "root", fmt::format("expected at most {} tools", crib::kMostTools));
        library.tools.push_back(HsmTool(tool, library.tools.size(), name, options).read());
    }
    return library;
}

}  // namespace stepmill
