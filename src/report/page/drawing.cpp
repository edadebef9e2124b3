#include "report/page/drawing.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/page/strokes.h"
#include "report/page/words.h"

namespace stepmill::report {

namespace {

/// Room around the drawing as a share of its longer side.
constexpr double kMarginShare = 0.03;
/// How many tints the style sheet has.
constexpr int kTints = 8;
/// A drawing's longer side has at least so many units, and less than ten times as many: more than a printer
/// has dots on its page.
constexpr double kLeastUnits = 5000;
constexpr double kSmallestFrameMm = 0.03;

}  // namespace

std::string tintClass(int number) {
    return fmt::format("tint{}", number % kTints);
}

Drawing::Drawing(const Box2& frame, std::string label)
    : frame_(frame), label_(std::move(label)), shapes_("g") {
    if (frame_.isEmpty()) frame_.extend(Vec2::Zero());
    const double longer_mm = std::max(frame_.sizes().maxCoeff(), kSmallestFrameMm);
    frame_ = grown(frame_, kMarginShare * longer_mm);
    unit_mm_ = std::pow(10, std::floor(std::log10(longer_mm / kLeastUnits)));
    shapes_ = std::move(shapes_).with("transform", fmt::format("scale({0},-{0})", unit_mm_));
}

void Drawing::add(const std::string& css_class, std::string path_data) {
    if (path_data.empty()) return;
    shapes_.add(Element("path").with("class", css_class).with("d", std::move(path_data)));
}

void Drawing::region(const Region& shape, const std::string& css_class) {
    add(css_class, toSvgPath(shape, unit_mm_));
}

void Drawing::path(const Path& path, const std::string& css_class) {
    paths({path}, css_class);
}

void Drawing::paths(const std::vector<Path>& paths, const std::string& css_class) {
    SvgPath drawn(unit_mm_);
    for (const Path& path : paths)
        drawn.add(path);
    add(css_class, drawn.text());
}

void Drawing::polylines(const std::vector<std::vector<Vec2>>& lines, const std::string& css_class) {
    SvgPath drawn(unit_mm_);
    for (const std::vector<Vec2>& line : lines)
        drawn.add(line);
    add(css_class, drawn.text());
}

void Drawing::strokes(const std::vector<std::vector<Vec2>>& lines, const std::string& css_class) {
    SvgPath drawn(unit_mm_);
    const auto dot_of = [&](const Vec2& p) { return drawn.dotOf(p); };
    for (const std::vector<SvgDot>& line : joined(strokesOf(lines, dot_of)))
        drawn.add(line);
    add(css_class, drawn.text());
}

void Drawing::dot(const Vec2& at, double radius_mm, const std::string& css_class) {
    shapes_.add(Element("circle")
                    .with("class", css_class)
                    .with("cx", fixed(at.x() / unit_mm_, 0))
                    .with("cy", fixed(at.y() / unit_mm_, 0))
                    .with("r", fixed(radius_mm / unit_mm_, 0)));
}

Element Drawing::element() && {
    const Vec2 size = frame_.sizes();
    Element svg = emptySvg(
        "svg.drawing",
        fmt::format("{:.3f} {:.3f} {:.3f} {:.3f}", frame_.min().x(), -frame_.max().y(), size.x(), size.y()),
        std::move(label_));
    svg.add(std::move(shapes_));
    return svg;
}

Element emptySvg(Tag tag, const std::string& view_box, std::string label) {
    return Element(tag)
        .with("xmlns", "http://www.w3.org/2000/svg")
        .with("viewBox", view_box)
        .with("role", "img")
        .with("aria-label", std::move(label));
}

}  // namespace stepmill::report
