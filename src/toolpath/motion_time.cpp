// How long a path takes on axes that cannot change their speed at once.

#include <algorithm>
#include <cmath>
#include <limits>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
/// Moves shorter than this are rounding and have no direction [mm].
constexpr double kNoLengthMm = 1e-9;

/// A move as the axes see it. Speeds in mm/s.
struct Stretch {
    double length_mm = 0;
    double speed = 0;  ///< asked for, and what an arc's radius allows
    Vec3 starts_along = Vec3::Zero();
    Vec3 ends_along = Vec3::Zero();
};

/// Unit vector along an arc at one of its points.
Vec2 tangentAt(const Arc& arc, const Vec2& p) {
    const Vec2 out = (p - arc.centre).normalized();
    return arc.ccw ? leftOf(out) : -leftOf(out);
}

Stretch stretchOf(const Vec3& from, const Move& move, double speed, double acceleration) {
    const Vec2 flat_from = from.head<2>();
    const Vec2 flat_to = move.to.head<2>();
    const double flat_mm = length(flat_from, Segment{flat_to, move.arc});
    const double rise_mm = move.to.z() - from.z();
    Stretch stretch;
    stretch.length_mm = std::hypot(flat_mm, rise_mm);
    stretch.speed = speed;
    if (stretch.length_mm <= kNoLengthMm) return stretch;
    const auto inSpace = [&](const Vec2& along) -> Vec3 {
        const Vec2 flat = along * flat_mm;
        return Vec3(flat.x(), flat.y(), rise_mm) / stretch.length_mm;
    };
    if (move.arc) {
        stretch.starts_along = inSpace(tangentAt(*move.arc, flat_from));
        stretch.ends_along = inSpace(tangentAt(*move.arc, flat_to));
        stretch.speed = std::min(speed, std::sqrt(acceleration * move.arc->radius_mm));
    } else {
        stretch.starts_along = (move.to - from) / stretch.length_mm;
        stretch.ends_along = stretch.starts_along;
    }
    return stretch;
}

std::vector<Stretch> stretchesOf(const Toolpath& path, const Machine& machine) {
    std::vector<Stretch> stretches;
    stretches.reserve(path.moves.size());
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const double rate = move.kind == MoveKind::Rapid ? machine.rapid_mm_per_min : path.feedOf(move);
        const Stretch stretch =
            stretchOf(from, move, rate / kSecondsPerMinute, machine.acceleration_mm_per_s2);
        if (stretch.length_mm > kNoLengthMm) stretches.push_back(stretch);
        from = move.to;
    }
    return stretches;
}

/// The speed at which the corner between two directions is passed.
double cornerSpeed(const Vec3& in, const Vec3& out, const Machine& machine) {
    // Half the angle between the way back and the way on: 90 degrees straight on, 0 for a reversal.
    const double cosine = std::clamp(-in.dot(out), -1.0, 1.0);
    const double sine_of_half = std::sqrt((1 - cosine) / 2);
    if (sine_of_half >= 1) return kUnlimited;
    return std::sqrt(machine.acceleration_mm_per_s2 * machine.junction_deviation_mm * sine_of_half /
                     (1 - sine_of_half));
}

/// The speed reached over that length from `speed`.
double reached(double speed, double length_mm, double acceleration) {
    return std::sqrt(speed * speed + 2 * acceleration * length_mm);
}

double timeOf(const Stretch& stretch, double start_speed, double end_speed, double acceleration) {
    // Where the ramps up and down meet, were there no limit between.
    const double peak =
        std::sqrt(acceleration * stretch.length_mm + (start_speed * start_speed + end_speed * end_speed) / 2);
    const double top = std::min(peak, stretch.speed);
    const double ramps_s = (top - start_speed + top - end_speed) / acceleration;
    if (peak <= stretch.speed) return ramps_s;
    const double ramps_mm =
        (2 * top * top - start_speed * start_speed - end_speed * end_speed) / (2 * acceleration);
    return ramps_s + (stretch.length_mm - ramps_mm) / top;
}

}  // namespace

double motionTimeS(const Toolpath& path, const Machine& machine) {
    const double acceleration = machine.acceleration_mm_per_s2;
    STEPMILL_CHECK(acceleration > 0, "an acceleration is given");
    const std::vector<Stretch> stretches = stretchesOf(path, machine);
    const std::size_t n = stretches.size();
    // Speeds at the ends of the stretches: rest at both ends of the path, corners between.
    std::vector<double> speeds(n + 1, 0);
    for (std::size_t i = 1; i < n; ++i)
        speeds[i] = std::min({stretches[i - 1].speed, stretches[i].speed,
                              cornerSpeed(stretches[i - 1].ends_along, stretches[i].starts_along, machine)});
    // No faster than what can be slowed down from, nor than what can be reached.
    for (std::size_t i = n; i-- > 0;)
        speeds[i] = std::min(speeds[i], reached(speeds[i + 1], stretches[i].length_mm, acceleration));
    double time_s = 0;
    for (std::size_t i = 0; i < n; ++i) {
        speeds[i + 1] = std::min(speeds[i + 1], reached(speeds[i], stretches[i].length_mm, acceleration));
        time_s += timeOf(stretches[i], speeds[i], speeds[i + 1], acceleration);
    }
    return time_s;
}

}  // namespace stepmill
