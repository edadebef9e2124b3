#include "catalog/library_rules.h"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "stepmill/catalog/json_text.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

using nlohmann::json;

/// Two lengths meant to be equal differ by no more than this share of them: inch sizes are often rounded.
constexpr double kEqualShare = 1e-3;

bool nearlyEqual(double a, double b) {
    return std::abs(a - b) <= kEqualShare * std::max(a, b);
}

std::string lengthText(double value) {
    return fmt::format("{}", value);
}

/// Smallest and largest sensible length or feed, as the schema's descriptions tell them [mm, mm/min].
struct Limits {
    double least;
    double most;
};
constexpr Limits kCutterDiameter{0.01, 500};
constexpr Limits kDiameter{0.01, 2000};
constexpr Limits kHeight{0.01, 5000};
constexpr Limits kStep{0.001, 1000};
constexpr Limits kFeed{1, 100000};
/// Conversion from inches rounds.
constexpr double kLimitRounding = 1e-9;

/// Sharper points are those of spot drills [deg].
constexpr double kLeastDrillPointDeg = 90;

/// Passes closer together than this share of the diameter cut nothing worth the time, and a wide pocket takes
/// more of them than fit in memory.
constexpr double kLeastStepOverShare = 1e-3;
/// A life shorter than this makes a tool's wear cost more than any part [min].
constexpr double kShortestLifeMin = 0.1;

/// Checks one tool; findings carry pointers into the file.
class ToolRules {
  public:
    ToolRules(const json& tool, std::string pointer, double mm_per_unit,
              std::vector<CatalogFinding>& findings)
        : tool_(tool),
          pointer_(std::move(pointer)),
          mm_per_unit_(mm_per_unit),
          findings_(findings),
          diameter_(tool["diameter"]) {}

    void check() {
        checkLimits();
        checkCornerRadius();
        checkCone();
        checkPoint();
        checkThread();
        checkPlunge();
        checkLengths();
        checkShank();
        checkHolder();
        checkCutting();
    }

  private:
    void expect(bool holds, const std::string& pointer, const std::string& expected, const json& found) {
        if (!holds) findings_.push_back({pointer, "expected " + expected + ", found " + quoted(found)});
    }

    void doubt(const std::string& pointer, const std::string& text) {
        findings_.push_back({pointer, text, true});
    }

    /// A number of an object, where it is given.
    void checkLimit(const json& from, const char* field, const Limits& limits, const std::string& pointer) {
        if (!from.contains(field) || !from[field].is_number()) return;
        const double value = from[field].get<double>() * mm_per_unit_;
        const bool within =
            value >= limits.least * (1 - kLimitRounding) && value <= limits.most * (1 + kLimitRounding);
        expect(within, childPointer(pointer, field),
               fmt::format("{:g} to {:g} mm{}", limits.least, limits.most, &limits == &kFeed ? "/min" : ""),
               from[field]);
    }

    void checkLimits() {
        checkLimit(tool_, "diameter", kCutterDiameter, pointer_);
        for (const char* field : {"flute_length", "stick_out"})
            checkLimit(tool_, field, kHeight, pointer_);
        if (isRange())
            for (const char* field : {"min", "max"})
                checkLimit(tool_["stick_out"], field, kHeight, childPointer(pointer_, "stick_out"));
        if (tool_.contains("shank")) {
            checkLimit(tool_["shank"], "diameter", kDiameter, childPointer(pointer_, "shank"));
            checkLimit(tool_["shank"], "from", kHeight, childPointer(pointer_, "shank"));
        }
        checkEach("holder", [this](const json& cylinder, const std::string& at) {
            checkLimit(cylinder, "diameter", kDiameter, at);
            checkLimit(cylinder, "bottom", kHeight, at);
            checkLimit(cylinder, "top", kHeight, at);
        });
        checkEach("cutting", [this](const json& data, const std::string& at) {
            for (const char* field : {"step_over", "step_down", "slot_step_down"})
                checkLimit(data, field, kStep, at);
            for (const char* field : {"feed", "plunge_feed", "slot_feed"})
                checkLimit(data, field, kFeed, at);
            if (!data.contains("adaptive")) return;
            const std::string adaptive = childPointer(at, "adaptive");
            for (const char* field : {"step_over", "step_down", "lift"})
                checkLimit(data["adaptive"], field, kStep, adaptive);
            checkLimit(data["adaptive"], "feed", kFeed, adaptive);
        });
        const double life_min = tool_.value("life_min", 0.0);
        expect(life_min == 0 || life_min >= kShortestLifeMin, childPointer(pointer_, "life_min"),
               fmt::format("0 (not given) or at least {:g} minutes", kShortestLifeMin), life_min);
    }

    template <typename Check>
    void checkEach(const char* list, const Check& check) {
        if (!tool_.contains(list)) return;
        for (std::size_t i = 0; i < tool_[list].size(); ++i)
            check(tool_[list][i], childPointer(childPointer(pointer_, list), i));
    }

    void checkCornerRadius() {
        const std::string type = tool_["type"];
        const std::string at = childPointer(pointer_, "corner_radius");
        const double radius = diameter_ / 2;
        if (!tool_.contains("corner_radius")) {
            if (type == "bull")
                findings_.push_back(
                    {pointer_, "expected the field \"corner_radius\" of a bull-nose cutter, found none"});
            return;
        }
        const double corner = tool_["corner_radius"];
        const json& found = tool_["corner_radius"];
        if (type == "ball")
            expect(nearlyEqual(corner, radius), at,
                   "half the diameter of a ball cutter, " + lengthText(radius), found);
        else if (type == "flat" || type == "chamfer" || isForHoles())
            expect(corner == 0, at,
                   "0 for a " + type +
                       (type == "flat"      ? " end mill"
                        : type == "chamfer" ? " mill"
                                            : ""),
                   found);
        else if (type == "bull")
            expect(corner > 0 && corner <= radius, at,
                   "a number greater than 0 and of at most half the diameter, " + lengthText(radius), found);
        else
            expect(corner <= radius, at, "at most half the diameter, " + lengthText(radius), found);
    }

    void checkPoint() {
        const std::string type = tool_["type"];
        const auto only = [&](const char* field, bool fits, const char* expected) {
            if (!fits && tool_.contains(field))
                findings_.push_back({childPointer(pointer_, field), expected});
        };
        only("point_angle_deg", type == "drill" || type == "spot", "expected on a drill or spot drill alone");
        only("self_centring", type == "drill", "expected on a drill alone");
        only("lead", type == "reamer" || type == "boring", "expected on a reamer or boring head alone");
        if (type == "drill" && tool_.contains("point_angle_deg"))
            expect(tool_["point_angle_deg"] >= kLeastDrillPointDeg, childPointer(pointer_, "point_angle_deg"),
                   fmt::format("{:g} degrees or more of a drill", kLeastDrillPointDeg),
                   tool_["point_angle_deg"]);
        if (tool_.contains("lead"))
            expect(tool_["lead"] < tool_["flute_length"], childPointer(pointer_, "lead"),
                   "less than the flute length, " + lengthText(tool_["flute_length"]), tool_["lead"]);
    }

    /// A tap is as wide as its thread, and its cutting part is longer than its lead.
    void checkThread() {
        const bool tap = tool_["type"] == "tap";
        for (const char* field : {"thread", "lead_threads"})
            if (!tap && tool_.contains(field))
                findings_.push_back({childPointer(pointer_, field), "expected on a tap alone"});
        if (!tap) return;
        if (!tool_.contains("thread")) {
            findings_.push_back({pointer_, "expected the field \"thread\" of a tap, found none"});
            return;
        }
        const std::optional<Thread> thread = threadFrom(tool_["thread"].get<std::string>());
        if (!thread)
            return expect(false, childPointer(pointer_, "thread"), "a thread such as M8, M8x1 or 1/4-20 UNC",
                          tool_["thread"]);
        const double major = thread->diameter_mm / mm_per_unit_;
        expect(nearlyEqual(diameter_, major), childPointer(pointer_, "diameter"),
               "that of " + thread->name + ", " + lengthText(major), tool_["diameter"]);
        const double lead = tool_.value("lead_threads", kUsualLeadThreads) * thread->pitch_mm / mm_per_unit_;
        expect(tool_["flute_length"] > lead, childPointer(pointer_, "flute_length"),
               fmt::format("more than the tap's lead, {:g}", lead), tool_["flute_length"]);
        for (std::size_t i = 0; i < tool_["cutting"].size(); ++i)
            checkTapFeed(tool_["cutting"][i], *thread, childPointer(childPointer(pointer_, "cutting"), i));
    }

    /// A tap goes its pitch with every turn, whatever else is written.
    void checkTapFeed(const json& data, const Thread& thread, const std::string& at) {
        const double feed = thread.pitch_mm / mm_per_unit_ * data["speed_rpm"].get<double>();
        for (const char* field : {"feed", "plunge_feed"})
            if (data.contains(field))
                expect(nearlyEqual(data[field], feed), childPointer(at, field),
                       fmt::format("pitch x speed, {:.6g}", feed), data[field]);
    }

    void checkPlunge() {
        if (tool_.value("max_plunge", 0.0) <= 0) return;
        const bool drill = tool_["type"] == "drill" || tool_["type"] == "spot";
        expect(tool_.value("centre_cutting", drill), childPointer(pointer_, "max_plunge"),
               "0 for a tool that does not cut at its centre", tool_["max_plunge"]);
        const double flutes = tool_["flute_length"];
        expect(tool_["max_plunge"] <= flutes, childPointer(pointer_, "max_plunge"),
               "no more than the flute length, " + lengthText(flutes), tool_["max_plunge"]);
    }

    /// A chamfer mill or countersink is a cone from its tip to its diameter, as high as its flutes at most.
    void checkCone() {
        const std::string type = tool_["type"];
        const bool cone = ofItsType().hasFlanks();
        for (const char* field : {"tip_diameter", "included_angle_deg"}) {
            if (cone && !tool_.contains(field))
                findings_.push_back(
                    {pointer_, fmt::format("expected the field \"{}\" of a {}, found none", field,
                                           type == "chamfer" ? "chamfer mill" : type)});
            if (!cone && tool_.contains(field))
                findings_.push_back(
                    {childPointer(pointer_, field), "expected on a chamfer mill or countersink alone"});
        }
        if (!cone || !tool_.contains("tip_diameter") || !tool_.contains("included_angle_deg")) return;
        const double tip = tool_["tip_diameter"];
        expect(tip < diameter_, childPointer(pointer_, "tip_diameter"),
               "less than the diameter, " + lengthText(diameter_), tool_["tip_diameter"]);
        const double half_rad = degToRad(tool_["included_angle_deg"].get<double>()) / 2;
        const double cone_height = (diameter_ - tip) / 2 / std::tan(half_rad);
        expect(tool_["flute_length"].get<double>() >= cone_height * (1 - kEqualShare),
               childPointer(pointer_, "flute_length"),
               "at least the height of the cone, " + lengthText(cone_height), tool_["flute_length"]);
    }

    bool isForHoles() const { return ofItsType().isForHoles(); }
    ToolAssembly ofItsType() const {
        ToolAssembly tool;
        tool.type = toolTypeFrom(tool_["type"].get<std::string>()).value_or(ToolType::Flat);
        return tool;
    }
    bool isRange() const { return tool_["stick_out"].is_object(); }
    /// Flutes and shank must be out of the holder at the shortest; the holder's heights are those of the
    /// longest.
    double shortestStickOut() const { return isRange() ? tool_["stick_out"]["min"] : tool_["stick_out"]; }
    double longestStickOut() const { return isRange() ? tool_["stick_out"]["max"] : tool_["stick_out"]; }

    void checkLengths() {
        const double stick_out = shortestStickOut();
        if (isRange())
            expect(longestStickOut() >= stick_out, childPointer(childPointer(pointer_, "stick_out"), "max"),
                   "at least the shortest, " + lengthText(stick_out), tool_["stick_out"]["max"]);
        expect(tool_["flute_length"] <= stick_out, childPointer(pointer_, "flute_length"),
               "at most the stick-out, " + lengthText(stick_out), tool_["flute_length"]);
    }

    void checkShank() {
        if (!tool_.contains("shank")) return;
        const json& from = tool_["shank"]["from"];
        const double flutes = tool_["flute_length"];
        const double stick_out = shortestStickOut();
        const std::string at = childPointer(childPointer(pointer_, "shank"), "from");
        expect(from >= flutes, at, "at least the flute length, " + lengthText(flutes), from);
        expect(from <= stick_out, at, "at most the stick-out, " + lengthText(stick_out), from);
    }

    void checkHolder() {
        const std::string at = childPointer(pointer_, "holder");
        if (!tool_.contains("holder") || tool_["holder"].empty()) {
            doubt(pointer_, "no holder given; nothing above the stick-out can be checked for collisions");
            return;
        }
        double below = longestStickOut();
        std::string below_name = "the stick-out";
        for (std::size_t i = 0; i < tool_["holder"].size(); ++i) {
            const json& cylinder = tool_["holder"][i];
            const std::string here = childPointer(at, i);
            const json& bottom = cylinder["bottom"];
            const json& top = cylinder["top"];
            expect(bottom >= below, childPointer(here, "bottom"),
                   "at least " + below_name + ", " + lengthText(below), bottom);
            expect(top > bottom, childPointer(here, "top"),
                   "more than the cylinder's bottom, " + lengthText(bottom), top);
            if (bottom > below && !nearlyEqual(bottom, below))
                doubt(childPointer(here, "bottom"),
                      "gap over " + below_name + ", " + lengthText(below) + "; nothing is checked there");
            below = std::max(below, top.get<double>());
            below_name = "the top of the cylinder below";
        }
    }

    void checkCutting() {
        const std::string at = childPointer(pointer_, "cutting");
        std::map<std::string, std::size_t> seen;
        if (tool_["cutting"].empty()) doubt(at, "no cutting data; the tool is never used");
        for (std::size_t i = 0; i < tool_["cutting"].size(); ++i) {
            const json& data = tool_["cutting"][i];
            const std::string here = childPointer(at, i);
            const auto [first, is_new] = seen.emplace(data["material"].get<std::string>(), i);
            expect(is_new, childPointer(here, "material"),
                   "each material once (it is also in " + childPointer(at, first->second) + ")",
                   data["material"]);
            checkSteps(data, here);
        }
    }

    void checkSteps(const json& data, const std::string& at) {
        const double flutes = tool_["flute_length"];
        const bool mills = !isForHoles();
        for (const char* name : {"step_over", "step_down"})
            if (mills && !data.contains(name))
                findings_.push_back(
                    {at, "expected the field \"" + std::string(name) + "\" of a milling cutter, found none"});
        if (data.contains("step_over")) {
            expect(data["step_over"] <= diameter_, childPointer(at, "step_over"),
                   "at most the diameter, " + lengthText(diameter_), data["step_over"]);
            expect(data["step_over"] >= kLeastStepOverShare * diameter_, childPointer(at, "step_over"),
                   fmt::format("at least {:g} of the diameter, {:g}", kLeastStepOverShare,
                               kLeastStepOverShare * diameter_),
                   data["step_over"]);
        }
        for (const char* name : {"step_down", "slot_step_down"})
            if (data.contains(name))
                expect(data[name] <= flutes, childPointer(at, name),
                       "at most the flute length, " + lengthText(flutes), data[name]);
        if (data.contains("adaptive")) checkAdaptive(data["adaptive"], flutes, childPointer(at, "adaptive"));
        checkRating(data, at);
    }

    /// Half the diameter engages a quarter of the rim; wider cuts are no light ones.
    void checkAdaptive(const json& data, double flutes, const std::string& at) {
        const double step_over = data["step_over"];
        expect(step_over <= diameter_ / 2, childPointer(at, "step_over"),
               "at most half the diameter, " + lengthText(diameter_ / 2), data["step_over"]);
        expect(step_over >= kLeastStepOverShare * diameter_, childPointer(at, "step_over"),
               fmt::format("at least {:g} of the diameter, {:g}", kLeastStepOverShare,
                           kLeastStepOverShare * diameter_),
               data["step_over"]);
        expect(data["step_down"] <= flutes, childPointer(at, "step_down"),
               "at most the flute length, " + lengthText(flutes), data["step_down"]);
    }

    /// More than a full slot at step-down and feed no cut can remove.
    void checkRating(const json& data, const std::string& at) {
        if (!data.contains("rated_removal_cm3_per_min") || !data.contains("step_down")) return;
        const double slot = diameter_ * data["step_down"].get<double>() * data["feed"].get<double>();
        const double most = slot * mm_per_unit_ * mm_per_unit_ * mm_per_unit_ / kMm3PerCm3;
        expect(data["rated_removal_cm3_per_min"] <= most * (1 + kLimitRounding),
               childPointer(at, "rated_removal_cm3_per_min"),
               fmt::format("at most what a full slot at step-down and feed removes, {:g}", most),
               data["rated_removal_cm3_per_min"]);
    }

    const json& tool_;
    std::string pointer_;
    double mm_per_unit_;
    std::vector<CatalogFinding>& findings_;
    double diameter_;
};

/// Ids and numbers name a tool on their own, so no two tools share one.
void checkUnique(const json& tools, const char* field, std::vector<CatalogFinding>& findings) {
    std::map<json, std::size_t> seen;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const auto [first, is_new] = seen.emplace(tools[i][field], i);
        if (is_new) continue;
        findings.push_back({childPointer(childPointer("#/tools", i), field),
                            "expected a value no other tool has, found " + quoted(tools[i][field]) +
                                " as in " + childPointer("#/tools", first->second)});
    }
}

}  // namespace

std::vector<CatalogFinding> checkLibraryRules(const json& library) {
    std::vector<CatalogFinding> findings;
    const json& tools = library["tools"];
    const double mm_per_unit = library["unit"] == "inch" ? kMillimetresPerInch : 1.0;
    checkUnique(tools, "id", findings);
    checkUnique(tools, "number", findings);
    for (std::size_t i = 0; i < tools.size(); ++i)
        ToolRules(tools[i], childPointer("#/tools", i), mm_per_unit, findings).check();
    return findings;
}

}  // namespace stepmill
