#include "stepmill/planar/svg_path.h"

#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"

namespace stepmill {

SvgPath::SvgPath(double unit_mm) : unit_mm_(unit_mm) {
    STEPMILL_CHECK(unit_mm > 0, "a picture has a unit");
}

void SvgPath::add(const Path& path) {
    moveTo(dotOf(path.start));
    for (const auto& [from, segment] : eachEdge(path)) {
        if (!segment.arc) {
            lineTo(dotOf(segment.to));
            continue;
        }
        // SVG draws nothing for an arc that ends where it starts, and tells long ones from short by a flag
        // that rounding may prove wrong.
        const Arc& arc = *segment.arc;
        const bool is_long = from == segment.to || std::abs(sweepAngle(from, segment.to, arc)) > kPi;
        if (is_long) arcTo(pointAt(from, segment, 0.5), arc.radius_mm, arc.ccw);
        arcTo(segment.to, arc.radius_mm, arc.ccw);
    }
    if (path.closed()) close();
}

void SvgPath::add(const Region& region) {
    for (const Loop& loop : region.loops)
        add(loop);
}

void SvgPath::add(const std::vector<Vec2>& line) {
    for (std::size_t i = 0; i < line.size(); ++i)
        i == 0 ? moveTo(dotOf(line[i])) : lineTo(dotOf(line[i]));
}

void SvgPath::add(const std::vector<SvgDot>& line) {
    for (std::size_t i = 0; i < line.size(); ++i)
        i == 0 ? moveTo(line[i]) : lineTo(line[i]);
}

SvgDot SvgPath::dotOf(const Vec2& p) const {
    return {std::llround(p.x() / unit_mm_), std::llround(p.y() / unit_mm_)};
}

void SvgPath::moveTo(const SvgDot& to) {
    const bool first = text_.empty();
    command(first ? 'M' : 'm');
    wayTo(to);
    start_ = to;
    if (!first) command_ = 'l';
}

void SvgPath::lineTo(const SvgDot& to) {
    if (to == at_) return;
    command('l');
    wayTo(to);
}

void SvgPath::arcTo(const Vec2& to, double radius_mm, bool ccw) {
    const std::int64_t radius = std::llround(radius_mm / unit_mm_);
    const SvgDot dot = dotOf(to);
    if (radius == 0) return lineTo(dot);
    if (dot == at_) return;
    command('a');
    number(radius);
    number(radius);
    number(0);
    number(0);
    number(ccw ? 1 : 0);
    wayTo(dot);
}

void SvgPath::close() {
    text_ += 'z';
    command_ = 'z';
    at_ = start_;
}

void SvgPath::command(char letter) {
    if (letter == command_) return;
    text_ += letter;
    command_ = letter;
}

void SvgPath::number(std::int64_t value) {
    const bool after_number = !text_.empty() && text_.back() >= '0' && text_.back() <= '9';
    if (after_number && value >= 0) text_ += ' ';
    text_ += std::to_string(value);
}

void SvgPath::wayTo(const SvgDot& to) {
    number(to[0] - at_[0]);
    number(to[1] - at_[1]);
    at_ = to;
}

}  // namespace stepmill
