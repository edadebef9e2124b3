#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill {

/// A point of a picture in whole units of it.
using SvgDot = std::array<std::int64_t, 2>;

/// Path data of an SVG picture, the `d` attribute (y up: the caller flips), written short: every point in
/// whole units and, but for the first, as the way from the one before. Points are rounded before they are
/// told apart, so that the errors of a long path do not add up. Arcs stay arcs; loops of regions may be
/// filled even-odd or non-zero.
class SvgPath {
  public:
    /// \param unit_mm  what the picture tells apart, above 0; the caller scales the path by it
    explicit SvgPath(double unit_mm);

    void add(const Path& path);
    void add(const Region& region);
    void add(const std::vector<Vec2>& line);
    void add(const std::vector<SvgDot>& line);

    SvgDot dotOf(const Vec2& p) const;
    /// Empty before anything was added.
    const std::string& text() const { return text_; }

  private:
    void moveTo(const SvgDot& to);
    void lineTo(const SvgDot& to);
    void arcTo(const Vec2& to, double radius_mm, bool ccw);
    void close();

    void command(char letter);
    void number(std::int64_t value);
    void wayTo(const SvgDot& to);

    double unit_mm_;
    std::string text_;
    char command_ = 0;  ///< whose numbers may follow without a letter; none at first
    SvgDot start_{0, 0};
    SvgDot at_{0, 0};
};

/// Path data of one region or path.
template <typename Shape>
std::string toSvgPath(const Shape& shape, double unit_mm) {
    SvgPath path(unit_mm);
    path.add(shape);
    return path.text();
}

}  // namespace stepmill
