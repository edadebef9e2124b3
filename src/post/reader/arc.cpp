#include "post/reader/arc.h"

#include <cmath>

#include <fmt/format.h>

#include "stepmill/core/units.h"

namespace stepmill::reader {
namespace {

/// Ends less equally far from the centre are refused: no controller takes much more (LinuxCNC: 0.028 mm or
/// 0.1 %) [mm].
constexpr double kArcDisagreementMm = 0.02;
/// A radius so much shorter than half the way to the end makes a half circle, as in LinuxCNC [mm].
constexpr double kShortRadiusMm = 1.27e-3;
/// Least radius of an arc [mm].
constexpr double kLeastRadiusMm = 3e-4;

ArcShape fromRadius(const Vec2& from, const Vec2& to, bool ccw, double r, const Where& where) {
    const Vec2 chord = to - from;
    const double half_mm = chord.norm() / 2;
    if (half_mm == 0) where.refuse("an arc by its radius that ends where it starts");
    const double radius_mm = std::abs(r);
    if (half_mm > radius_mm + kShortRadiusMm)
        where.refuse(fmt::format("an arc of radius {:.4f} mm does not reach an end {:.4f} mm away", radius_mm,
                                 2 * half_mm));
    const double height_mm = std::sqrt(std::max(0.0, radius_mm * radius_mm - half_mm * half_mm));
    // A positive radius is the shorter way round: its centre lies left of the chord when it turns left.
    const Vec2 left = leftOf(chord).normalized();
    const bool is_left = ccw == (r > 0);
    return {from + chord / 2 + (is_left ? height_mm : -height_mm) * left, 0};
}

}  // namespace

ArcShape arcShape(const Vec2& from, const Vec2& to, bool ccw, const ArcWords& words, const Where& where) {
    const bool by_centre = words.i || words.j;
    if (by_centre && words.r) where.refuse("an arc by both its centre (I, J) and its radius (R)");
    if (words.r) return fromRadius(from, to, ccw, *words.r, where);
    if (!by_centre) where.refuse("an arc without I, J or R");
    if (words.absolute_centre && !(words.i && words.j)) where.refuse("an arc after G90.1 needs both I and J");
    const Vec2 given(words.i.value_or(0), words.j.value_or(0));
    const Vec2 centre = words.absolute_centre ? given : from + given;
    const double start_mm = (from - centre).norm();
    const double end_mm = (to - centre).norm();
    if (std::min(start_mm, end_mm) < kLeastRadiusMm) where.refuse("an arc without a radius");
    if (std::abs(start_mm - end_mm) > kArcDisagreementMm)
        where.refuse(
            fmt::format("the arc's ends are {:.4f} and {:.4f} mm from its centre", start_mm, end_mm));
    return {centre, start_mm - end_mm};
}

double arcLengthMm(const Vec2& from, const Vec2& to, const Vec2& centre, bool ccw, int turns,
                   double rise_mm) {
    const double radius_mm = (from - centre).norm();
    const double flat_mm =
        radius_mm * (std::abs(sweepAngle(from, to, Arc{centre, radius_mm, ccw})) + 2 * kPi * (turns - 1));
    return std::hypot(flat_mm, rise_mm);
}

}  // namespace stepmill::reader
