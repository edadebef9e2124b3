#include "report/page/svg.h"

#include <fmt/format.h>

#include "stepmill/planar/region_text.h"

namespace stepmill {

namespace {

/// Room around the drawing as a share of its longer side.
constexpr double kMarginShare = 0.03;

}  // namespace

SvgDrawing::SvgDrawing(const Box2& frame) {
    frame_ = frame;
    if (frame_.isEmpty()) frame_.extend(Vec2::Zero());
    frame_ = grown(frame_, std::max(1e-3, kMarginShare * frame_.sizes().maxCoeff()));
}

void SvgDrawing::region(const Region& shape, const std::string& css_class) {
    if (shape.empty()) return;
    body_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", css_class, toSvgPath(shape));
}

void SvgDrawing::path(const Path& path, const std::string& css_class) {
    paths({path}, css_class);
}

void SvgDrawing::paths(const std::vector<Path>& paths, const std::string& css_class) {
    if (paths.empty()) return;
    std::string data;
    for (const Path& path : paths)
        data += toSvgPath(path);
    body_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", css_class, data);
}

void SvgDrawing::polylines(const std::vector<std::vector<Vec2>>& lines, const std::string& css_class) {
    if (lines.empty()) return;
    std::string data;
    for (const std::vector<Vec2>& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i)
            data += fmt::format("{}{:.3f} {:.3f}", i == 0 ? 'M' : 'L', line[i].x(), line[i].y());
    body_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", css_class, data);
}

void SvgDrawing::dot(const Vec2& at, double radius_mm, const std::string& css_class) {
    body_ += fmt::format("<circle class=\"{}\" cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"{:.3f}\"/>\n", css_class,
                         at.x(), at.y(), radius_mm);
}

std::string SvgDrawing::text() const {
    const Vec2 size = frame_.sizes();
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.3f} {:.3f} {:.3f} {:.3f}\" "
        "preserveAspectRatio=\"xMidYMid meet\"><g transform=\"scale(1,-1)\">\n{}</g></svg>\n",
        frame_.min().x(), -frame_.max().y(), size.x(), size.y(), body_);
}

}  // namespace stepmill
