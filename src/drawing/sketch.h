#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/planar/vector.h"

namespace stepmill::drawing {

/// A rational spline by its poles; knots with their repeats.
struct Spline {
    int degree = 3;
    std::vector<Vec2> poles;
    std::vector<double> weights;  ///< one a pole
    std::vector<double> knots;    ///< poles + degree + 1 of them
};

/// One piece of a profile with its ends.
struct Stroke {
    Vec2 from = Vec2::Zero();
    Vec2 to = Vec2::Zero();
    /// Tangent of a quarter of the arc's angle, positive counter-clockwise, as DXF has it; 0: a line.
    double bulge = 0;
    double circle_radius = 0;              ///< above 0: a whole circle about `from`, which is `to`
    std::shared_ptr<const Spline> spline;  ///< null: a line, an arc or a circle

    std::string layer;
    std::string colour;  ///< as the options name it: "colour:5", "colour:#ff0000"
    std::string place;   ///< in the file, for messages

    bool isLine() const { return !spline && bulge == 0 && circle_radius == 0; }
    bool isCircle() const { return circle_radius > 0; }
};

/// What a drawing holds, in its own unit.
struct Sketch {
    std::vector<Stroke> strokes;
    double mm_per_unit = 0;                      ///< 0: the file does not say
    std::map<std::string, int> left_aside;       ///< entities that are no profile, by layer and kind
    std::map<std::string, std::string> refused;  ///< of a layer or colour: why it cannot be taken whole
};

/// More strokes than any drawing of a milled part has.
inline constexpr std::size_t kMostStrokes = 200000;

/// \throws Error(InvalidCatalog) "file, place: message"
[[noreturn]] void refuse(const std::string& file, const std::string& place, const std::string& message);

/// An elliptic arc about a centre as splines of a quarter turn at most: exact.
/// \param major, minor  its half axes
/// \param start_rad, sweep_rad  on the circle that the ellipse is a picture of
std::vector<Stroke> ellipseArc(const Vec2& centre, const Vec2& major, const Vec2& minor, double start_rad,
                               double sweep_rad);
/// A Bézier curve of any degree.
Stroke bezier(const std::vector<Vec2>& poles);

/// \throws Error(InvalidCatalog)
Sketch readDxf(std::string_view text, const std::string& file);
Sketch readSvg(std::string_view text, const std::string& file);
/// Of a STEP file that holds curves alone, in one plane across z.
Sketch readStepCurves(std::string_view text, const std::string& file);

}  // namespace stepmill::drawing
