// Regions as JSON.

#include "stepmill/planar/region_json.h"

#include <cmath>

#include <fmt/format.h>

#include "planar/segment.h"
#include "stepmill/core/error.h"

namespace stepmill {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kNmPerMm = 1e6;
constexpr double kLargestNm = planar::kLargestMm * kNmPerMm;

/// Numbers of a line, an arc, and an arc with its radius told.
constexpr std::size_t kLine = 2;
constexpr std::size_t kArc = 5;
constexpr std::size_t kArcWithRadius = 6;

std::int64_t nanometres(double value_mm) {
    return std::llround(value_mm * kNmPerMm);
}

Json point(const Vec2& p) {
    return Json::array({nanometres(p.x()), nanometres(p.y())});
}

/// \param from  where it starts
Json segmentToJson(const Vec2& from, const Segment& segment) {
    const auto told = [&](const Vec2& p, int axis) { return nanometres(p[axis]) - nanometres(from[axis]); };
    Json json = Json::array({told(segment.to, 0), told(segment.to, 1)});
    if (!segment.arc) return json;
    const Arc& arc = *segment.arc;
    json.push_back(told(arc.centre, 0));
    json.push_back(told(arc.centre, 1));
    json.push_back(arc.ccw ? 1 : -1);
    if (planar::radiusThrough(segment.to, arc.centre) != arc.radius_mm)
        json.push_back(nanometres(arc.radius_mm));
    return json;
}

/// Reads one loop, from its start on.
class LoopReader {
  public:
    explicit LoopReader(const std::string& subject) : subject_(subject) {}

    Loop loop(const Json& json) {
        if (!json.is_array() || json.empty()) fail("a start and segments");
        for (const Json& step : json)
            if (!step.is_array()) fail("lists of numbers");
        if (json[0].size() != 2) fail("a start of two numbers");
        Loop loop{move(json[0], 0), {}};
        for (std::size_t i = 1; i < json.size(); ++i)
            loop.segments.push_back(segment(json[i]));
        return loop;
    }

  private:
    Segment segment(const Json& json) {
        if (json.size() != kLine && json.size() != kArc && json.size() != kArcWithRadius)
            fail("a line of two numbers or an arc of five or six");
        const Vec2 centre = json.size() == kLine ? Vec2::Zero() : at(json, 2);
        Segment segment{move(json, 0), std::nullopt};
        if (json.size() == kLine) return segment;
        const double turn = nanometresAt(json, 4);
        if (turn != 1 && turn != -1) fail("a turn of 1 or -1");
        segment.arc = Arc{centre, 0, turn == 1};
        segment.arc->radius_mm = json.size() == kArc ? planar::radiusThrough(segment.to, centre)
                                                     : millimetres(nanometresAt(json, 5));
        if (!(segment.arc->radius_mm > 0)) fail("a positive radius");
        return segment;
    }

    /// The point told by two numbers, from where the last segment ended.
    Vec2 at(const Json& json, std::size_t first) const {
        return {millimetres(x_nm_ + nanometresAt(json, first)),
                millimetres(y_nm_ + nanometresAt(json, first + 1))};
    }

    /// The same point; the next ones are told from there.
    Vec2 move(const Json& json, std::size_t first) {
        Vec2 to = at(json, first);
        x_nm_ += nanometresAt(json, first);
        y_nm_ += nanometresAt(json, first + 1);
        return to;
    }

    double nanometresAt(const Json& json, std::size_t i) const {
        if (!json[i].is_number()) fail("a number");
        const double value_nm = json[i].get<double>();
        if (value_nm != std::round(value_nm)) fail("whole nanometres");
        return value_nm;
    }

    double millimetres(double value_nm) const {
        if (!(std::abs(value_nm) <= kLargestNm)) fail("a length of a kilometre at most");
        return snapToGrid(value_nm / kNmPerMm);
    }

    [[noreturn]] void fail(const std::string& expected) const {
        throw Error(ErrorCode::InvalidRegion, subject_, "expected " + expected);
    }

    const std::string& subject_;
    double x_nm_ = 0;  // whole and below 2^53, so exact
    double y_nm_ = 0;
};

}  // namespace

Json loopToJson(const Loop& loop) {
    Json json = Json::array({point(loop.start)});
    Vec2 from = loop.start;
    for (const Segment& segment : loop.segments) {
        json.push_back(segmentToJson(from, segment));
        from = segment.to;
    }
    return json;
}

Loop loopFromJson(const Json& json, const std::string& subject) {
    return LoopReader(subject).loop(json);
}

std::size_t RegionTables::Table::add(Json row) {
    const auto [found, is_new] = numbers.emplace(row.dump(), rows.size());
    if (is_new) rows.push_back(std::move(row));
    return found->second;
}

std::size_t RegionTables::add(const Region& region) {
    Json row = Json::array();
    for (const Loop& loop : region.loops)
        row.push_back(loops_.add(loopToJson(loop)));
    return regions_.add(std::move(row));
}

}  // namespace stepmill
