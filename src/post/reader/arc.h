#pragma once

#include <optional>

#include "post/reader/where.h"
#include "stepmill/planar/region.h"

namespace stepmill::reader {

/// An arc's centre as its words give it [mm].
struct ArcWords {
    std::optional<double> i;
    std::optional<double> j;
    std::optional<double> r;
    bool absolute_centre = false;  ///< G90.1
};

struct ArcShape {
    Vec2 centre = Vec2::Zero();
    double radii_differ_mm = 0;
};

/// The arc between two places, refused where a controller refuses it [RS274/NGC, 3.5.3].
ArcShape arcShape(const Vec2& from, const Vec2& to, bool ccw, const ArcWords& words, const Where& where);

/// Length of an arc of so many turns that also goes up or down by `rise_mm`.
double arcLengthMm(const Vec2& from, const Vec2& to, const Vec2& centre, bool ccw, int turns, double rise_mm);

}  // namespace stepmill::reader
