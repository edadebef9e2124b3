#pragma once

#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::planar {

/// What counts as meeting where two lines or circles nearly touch or coincide.
struct MeetingTolerance {
    double reach_mm = 0;       ///< carriers with a gap no wider than this touch, in its middle
    double coincident_mm = 0;  ///< circles no farther apart than this anywhere are one and meet nowhere
    /// Carriers that miss or overlap each other by less than this are tangent: one touching point.
    double tangent_mm = 0;
};

/// Circles and lines that miss or overlap each other by less than this count as tangent: two intersections
/// of curves rounded to the 1 nm grid would otherwise lie micrometres apart where one touching point is
/// meant.
inline constexpr double kTangentMm = 5 * kGridMm;

/// Nothing is forgiven: curves as they are.
inline constexpr MeetingTolerance kExactly{};
/// What Booleans ask for, whose curves are rounded.
inline constexpr MeetingTolerance kRounded{0, 0, kTangentMm};

/// Points shared by the whole lines or circles on which the two segments lie: none, one (tangent) or two.
/// Nothing for parallel lines and for circles that coincide.
std::vector<Vec2> carrierIntersections(const Vec2& from1, const Segment& segment1, const Vec2& from2,
                                       const Segment& segment2, const MeetingTolerance& tolerance);

/// Points at which the two segments meet: ends of one that come within `reach_mm` of the other, crossings,
/// and touching points whose gap is at most `reach_mm`. Unsorted; may name a point more than once.
std::vector<Vec2> contacts(const Vec2& from1, const Segment& segment1, const Vec2& from2,
                           const Segment& segment2, double reach_mm);

/// Distance from p to the whole line or circle.
double distanceToCarrier(const Vec2& p, const Vec2& from, const Segment& segment);

/// The nearest point of the whole line or circle.
Vec2 projectOnCarrier(const Vec2& p, const Vec2& from, const Segment& segment);

}  // namespace stepmill::planar
