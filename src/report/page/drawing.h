#pragma once

#include <string>
#include <vector>

#include "report/page/element.h"
#include "stepmill/planar/svg_path.h"

namespace stepmill::report {

/// Features of one picture take the style sheet's tints in turn: "tint3" for number 3 and for number 11.
std::string tintClass(int number);

/// Collects shapes in drawing coordinates (y up, mm) into one <svg>. The style sheet gives each class its
/// colour and line; line widths do not scale with the drawing.
class Drawing {
  public:
    /// \param frame  what the picture shows; a small margin is added around it
    /// \param label  what it shows in words, for those who cannot see it
    Drawing(const Box2& frame, std::string label);

    void region(const Region& shape, const std::string& css_class);
    void path(const Path& path, const std::string& css_class);
    void paths(const std::vector<Path>& paths, const std::string& css_class);
    void polylines(const std::vector<std::vector<Vec2>>& lines, const std::string& css_class);
    /// Lines that may be drawn in any order and either way, joined where they meet; what is drawn twice is
    /// drawn once.
    void strokes(const std::vector<std::vector<Vec2>>& lines, const std::string& css_class);
    void dot(const Vec2& at, double radius_mm, const std::string& css_class);

    /// The drawing, an <svg> that may stand in a page or in a file of its own.
    Element element() &&;

  private:
    void add(const std::string& css_class, std::string path_data);

    Box2 frame_;
    double unit_mm_;
    std::string label_;
    Element shapes_;
};

/// An empty picture of this size, in units that the page scales to its width, y down.
Element emptySvg(Tag tag, const std::string& view_box, std::string label);

}  // namespace stepmill::report
