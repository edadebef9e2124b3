#include "drawing/sketch.h"

#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill::drawing {

void refuse(const std::string& file, const std::string& place, const std::string& message) {
    throw Error(ErrorCode::InvalidCatalog, file + ", " + place, message);
}

std::vector<Stroke> ellipseArc(const Vec2& centre, const Vec2& major, const Vec2& minor, double start_rad,
                               double sweep_rad) {
    constexpr double kQuarter = kPi / 2;
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep_rad) / kQuarter - 1e-9)));
    const auto at = [&](double angle, double scale) -> Vec2 {
        return centre + scale * (std::cos(angle) * major + std::sin(angle) * minor);
    };
    std::vector<Stroke> strokes;
    for (int i = 0; i < pieces; ++i) {
        const double a = start_rad + sweep_rad * i / pieces;
        const double b = start_rad + sweep_rad * (i + 1) / pieces;
        const double half = std::cos((b - a) / 2);
        Stroke stroke = bezier({at(a, 1), at((a + b) / 2, 1 / half), at(b, 1)});
        auto spline = std::make_shared<Spline>(*stroke.spline);
        spline->weights[1] = half;
        stroke.spline = std::move(spline);
        strokes.push_back(std::move(stroke));
    }
    return strokes;
}

Stroke bezier(const std::vector<Vec2>& poles) {
    auto spline = std::make_shared<Spline>();
    spline->degree = static_cast<int>(poles.size()) - 1;
    spline->poles = poles;
    spline->weights.assign(poles.size(), 1.0);
    spline->knots.assign(poles.size(), 0.0);
    spline->knots.insert(spline->knots.end(), poles.size(), 1.0);
    Stroke stroke;
    stroke.from = poles.front();
    stroke.to = poles.back();
    stroke.spline = std::move(spline);
    return stroke;
}

}  // namespace stepmill::drawing
