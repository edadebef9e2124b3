#include "report/page/drawing.h"

#include <fmt/format.h>

#include "report/page/words.h"
#include "stepmill/planar/region_text.h"

namespace stepmill::report {

namespace {

/// Room around the drawing as a share of its longer side.
constexpr double kMarginShare = 0.03;
/// How many tints the style sheet has.
constexpr int kTints = 8;

}  // namespace

std::string tintClass(int number) {
    return fmt::format("tint{}", number % kTints);
}

Drawing::Drawing(const Box2& frame, std::string label)
    : frame_(frame), label_(std::move(label)), shapes_(Element("g").with("transform", "scale(1,-1)")) {
    if (frame_.isEmpty()) frame_.extend(Vec2::Zero());
    frame_ = grown(frame_, std::max(1e-3, kMarginShare * frame_.sizes().maxCoeff()));
}

void Drawing::add(const std::string& css_class, std::string path_data) {
    if (path_data.empty()) return;
    shapes_.add(Element("path").with("class", css_class).with("d", std::move(path_data)));
}

void Drawing::region(const Region& shape, const std::string& css_class) {
    add(css_class, toSvgPath(shape));
}

void Drawing::path(const Path& path, const std::string& css_class) {
    paths({path}, css_class);
}

void Drawing::paths(const std::vector<Path>& paths, const std::string& css_class) {
    std::string data;
    for (const Path& path : paths)
        data += toSvgPath(path);
    add(css_class, std::move(data));
}

void Drawing::polylines(const std::vector<std::vector<Vec2>>& lines, const std::string& css_class) {
    std::string data;
    for (const std::vector<Vec2>& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i)
            fmt::format_to(std::back_inserter(data), "{}{:.3f} {:.3f}", i == 0 ? 'M' : 'L', line[i].x(),
                           line[i].y());
    add(css_class, std::move(data));
}

void Drawing::dot(const Vec2& at, double radius_mm, const std::string& css_class) {
    shapes_.add(Element("circle")
                    .with("class", css_class)
                    .with("cx", fixed(at.x(), 3))
                    .with("cy", fixed(at.y(), 3))
                    .with("r", fixed(radius_mm, 3)));
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
