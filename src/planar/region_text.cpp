#include "stepmill/planar/region_text.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "planar/segment.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/edge.h"

namespace stepmill {

namespace {

using planar::kLargestMm;
using planar::radiusThrough;

/// Shortest decimal of the 1 nm grid: "12.5", "0", "-0.000001".
std::string number(double value_mm) {
    std::string text = fmt::format("{:.6f}", value_mm);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string numbers(const Vec2& p) {
    return number(p.x()) + " " + number(p.y());
}

bool equal(const Path& a, const Path& b) {
    if (a.start != b.start || a.segments.size() != b.segments.size()) return false;
    for (std::size_t i = 0; i < a.segments.size(); ++i)
        if (a.segments[i].to != b.segments[i].to || a.segments[i].arc != b.segments[i].arc) return false;
    return true;
}

Loop circle(const Vec2& centre, double radius_mm, bool ccw) {
    const Loop loop = makeCircle(centre, radius_mm).loops.front();
    return ccw ? loop : reversed(loop);
}

std::string textOf(const Loop& loop) {
    if (!loop.segments.empty() && loop.segments.front().arc) {
        const Arc& arc = *loop.segments.front().arc;
        if (equal(loop, circle(arc.centre, arc.radius_mm, arc.ccw)))
            return fmt::format("circle {} radius {} {}", numbers(arc.centre), number(arc.radius_mm),
                               arc.ccw ? "ccw" : "cw");
    }
    std::string text = "loop " + numbers(loop.start);
    for (std::size_t i = 0; i < loop.segments.size(); ++i) {
        const Segment& segment = loop.segments[i];
        if (!segment.arc) {
            if (i + 1 < loop.segments.size()) text += "  line " + numbers(segment.to);
            continue;
        }
        const Arc& arc = *segment.arc;
        text += fmt::format("  arc {} centre {}", numbers(segment.to), numbers(arc.centre));
        if (radiusThrough(segment.to, arc.centre) != arc.radius_mm)
            text += " radius " + number(arc.radius_mm);
        text += arc.ccw ? " ccw" : " cw";
    }
    return text + "  close";
}

/// Reads the words of one line; every complaint names subject and line.
class LineReader {
  public:
    LineReader(std::string_view line, int line_number, const std::string& subject)
        : line_number_(line_number), subject_(subject) {
        line = line.substr(0, line.find('#'));
        while (true) {
            const auto begin = line.find_first_not_of(" \t\r");
            if (begin == std::string_view::npos) break;
            line.remove_prefix(begin);
            const auto end = std::min(line.find_first_of(" \t\r"), line.size());
            words_.push_back(line.substr(0, end));
            line.remove_prefix(end);
        }
    }

    bool atEnd() const { return next_ == words_.size(); }
    std::string_view peek() const { return atEnd() ? "the end of the line" : words_[next_]; }

    bool take(std::string_view word) {
        if (atEnd() || words_[next_] != word) return false;
        ++next_;
        return true;
    }

    void expect(std::string_view word) {
        if (!take(word)) fail(fmt::format("'{}'", word));
    }

    double takeNumber() {
        double value = 0;
        if (atEnd()) fail("a number");
        const std::string_view word = words_[next_];
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (code != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            fail("a number");
        if (std::abs(value) > kLargestMm) fail("a length of a kilometre at most");
        ++next_;
        return snapToGrid(value);
    }

    double takeRadius() {
        const std::size_t here = next_;
        const double radius_mm = takeNumber();
        if (radius_mm > 0) return radius_mm;
        next_ = here;
        fail("a positive radius");
    }

    Vec2 takePoint() {
        const double x = takeNumber();
        return {x, takeNumber()};
    }

    bool takeSense() {
        if (take("ccw")) return true;
        if (take("cw")) return false;
        fail("'ccw' or 'cw'");
    }

    [[noreturn]] void fail(const std::string& expected) const {
        throw Error(ErrorCode::InvalidRegion, subject_,
                    fmt::format("line {}: expected {}, found {}", line_number_, expected,
                                atEnd() ? std::string(peek()) : fmt::format("'{}'", peek())));
    }

  private:
    std::vector<std::string_view> words_;
    std::size_t next_ = 0;
    int line_number_;
    const std::string& subject_;
};

Segment readArc(LineReader& reader) {
    const Vec2 to = reader.takePoint();
    reader.expect("centre");
    Arc arc{reader.takePoint(), 0, true};
    arc.radius_mm = reader.take("radius") ? reader.takeRadius() : radiusThrough(to, arc.centre);
    arc.ccw = reader.takeSense();
    return {to, arc};
}

Loop readLoop(LineReader& reader) {
    Loop loop{reader.takePoint(), {}};
    while (!reader.take("close")) {
        if (reader.take("line"))
            loop.segments.push_back({reader.takePoint(), std::nullopt});
        else if (reader.take("arc"))
            loop.segments.push_back(readArc(reader));
        else
            reader.fail("'line', 'arc' or 'close'");
    }
    if (loop.end() != loop.start) loop.segments.push_back({loop.start, std::nullopt});
    return loop;
}

Loop readCircle(LineReader& reader) {
    const Vec2 centre = reader.takePoint();
    reader.expect("radius");
    const double radius_mm = reader.takeRadius();
    return circle(centre, radius_mm, reader.takeSense());
}

}  // namespace

std::string toText(const Region& region) {
    std::string text;
    for (const Loop& loop : region.loops)
        text += textOf(loop) + "\n";
    return text;
}

Region regionFromText(std::string_view text, const std::string& subject) {
    Region region;
    for (int line_number = 1; !text.empty(); ++line_number) {
        const auto end = std::min(text.find('\n'), text.size());
        LineReader reader(text.substr(0, end), line_number, subject);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (reader.atEnd()) continue;
        if (reader.take("loop"))
            region.loops.push_back(readLoop(reader));
        else if (reader.take("circle"))
            region.loops.push_back(readCircle(reader));
        else
            reader.fail("'loop' or 'circle'");
        if (!reader.atEnd()) reader.fail("the end of the line");
    }
    return region;
}

}  // namespace stepmill
