// Regions as JSON.

#include "stepmill/planar/region_json.h"

#include <cmath>

#include <fmt/format.h>

#include "planar/segment.h"
#include "stepmill/core/error.h"

namespace stepmill {

namespace {

using Json = nlohmann::ordered_json;

/// Digits of the grid alone, the same on every machine. The quotient by the exact 10^6 is the double nearest
/// to the decimal, and prints as that.
double number(double value_mm) {
    constexpr double kPerMm = 1e6;
    const double rounded = std::round(value_mm * kPerMm) / kPerMm;
    return rounded == 0 ? 0.0 : rounded;
}

Json point(const Vec2& p) {
    return Json::array({number(p.x()), number(p.y())});
}

Json segmentToJson(const Segment& segment) {
    Json json{{"to", point(segment.to)}};
    if (!segment.arc) return json;
    const Arc& arc = *segment.arc;
    json["centre"] = point(arc.centre);
    if (planar::radiusThrough(segment.to, arc.centre) != arc.radius_mm)
        json["radius"] = number(arc.radius_mm);
    json["ccw"] = arc.ccw;
    return json;
}

/// Reads one loop; every complaint names subject and loop.
class LoopReader {
  public:
    LoopReader(std::size_t index, const std::string& subject) : index_(index), subject_(subject) {}

    Loop loop(const Json& json) const {
        Loop loop{pointAt(member(json, "start")), {}};
        const Json& segments = member(json, "segments");
        if (!segments.is_array()) fail("a list of segments");
        for (const Json& segment : segments)
            loop.segments.push_back(segmentAt(segment));
        return loop;
    }

  private:
    Segment segmentAt(const Json& json) const {
        Segment segment{pointAt(member(json, "to")), std::nullopt};
        if (!json.contains("centre")) return segment;
        const Json& ccw = member(json, "ccw");
        if (!ccw.is_boolean()) fail("'ccw' true or false");
        Arc arc{pointAt(json["centre"]), 0, ccw.get<bool>()};
        arc.radius_mm =
            json.contains("radius") ? length(json["radius"]) : planar::radiusThrough(segment.to, arc.centre);
        if (!(arc.radius_mm > 0)) fail("a positive radius");
        segment.arc = arc;
        return segment;
    }

    const Json& member(const Json& json, const char* name) const {
        if (!json.is_object() || !json.contains(name)) fail(fmt::format("'{}'", name));
        return json[name];
    }

    Vec2 pointAt(const Json& json) const {
        if (!json.is_array() || json.size() != 2) fail("a point of two numbers");
        return {length(json[0]), length(json[1])};
    }

    double length(const Json& json) const {
        if (!json.is_number()) fail("a number");
        const double value_mm = json.get<double>();
        if (!(std::abs(value_mm) <= planar::kLargestMm)) fail("a length of a kilometre at most");
        return snapToGrid(value_mm);
    }

    [[noreturn]] void fail(const std::string& expected) const {
        throw Error(ErrorCode::InvalidRegion, subject_,
                    fmt::format("loop {}: expected {}", index_, expected));
    }

    std::size_t index_;
    const std::string& subject_;
};

}  // namespace

Json regionToJson(const Region& region) {
    Json loops = Json::array();
    for (const Loop& loop : region.loops) {
        Json segments = Json::array();
        for (const Segment& segment : loop.segments)
            segments.push_back(segmentToJson(segment));
        loops.push_back({{"hole", signedArea(loop) < 0},
                         {"start", point(loop.start)},
                         {"segments", std::move(segments)}});
    }
    return {{"loops", std::move(loops)}};
}

Region regionFromJson(const Json& json, const std::string& subject) {
    if (!json.is_object() || !json.contains("loops") || !json["loops"].is_array())
        throw Error(ErrorCode::InvalidRegion, subject, "expected 'loops', a list");
    Region region;
    for (const Json& loop : json["loops"])
        region.loops.push_back(LoopReader(region.loops.size(), subject).loop(loop));
    return region;
}

}  // namespace stepmill
