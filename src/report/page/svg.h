#pragma once

#include <string>
#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill {

/// Collects shapes in drawing coordinates (y up, mm) and writes one <svg> element. Styling is by class;
/// line widths do not scale with the drawing.
class SvgDrawing {
  public:
    /// `frame` is what the picture shows, with a small margin added around it.
    explicit SvgDrawing(const Box2& frame);

    void region(const Region& shape, const std::string& css_class);
    void path(const Path& path, const std::string& css_class);
    void paths(const std::vector<Path>& paths, const std::string& css_class);
    void polylines(const std::vector<std::vector<Vec2>>& lines, const std::string& css_class);
    void dot(const Vec2& at, double radius_mm, const std::string& css_class);

    std::string text() const;

  private:
    Box2 frame_;
    std::string body_;
};

}  // namespace stepmill
