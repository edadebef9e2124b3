#pragma once

#include <array>
#include <initializer_list>

#include "stepmill/planar/edge.h"

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

/// A few points in one place: Booleans ask for them so often that a list's allocation would cost more than
/// the points.
class FewPoints {
  public:
    FewPoints() = default;
    FewPoints(std::initializer_list<Vec2> points) {
        for (const Vec2& p : points)
            push_back(p);
    }
    void push_back(const Vec2& p) { points_[size_++] = p; }
    const Vec2* begin() const { return points_.data(); }
    const Vec2* end() const { return points_.data() + size_; }

  private:
    std::array<Vec2, 6> points_;  // four ends and two crossings
    std::size_t size_ = 0;
};

/// Points shared by the whole lines or circles on which the two segments lie: none, one (tangent) or two.
/// Nothing for parallel lines and for circles that coincide.
FewPoints carrierIntersections(const Vec2& from1, const Segment& segment1, const Vec2& from2,
                               const Segment& segment2, const MeetingTolerance& tolerance);

/// Points at which the two edges meet: ends of one that come within `reach_mm` of the other, crossings,
/// and touching points whose gap is at most `reach_mm`. Unsorted; may name a point more than once.
FewPoints contacts(const Edge& a, const Edge& b, double reach_mm);

/// Distance from p to the whole line or circle.
double distanceToCarrier(const Vec2& p, const Vec2& from, const Segment& segment);

/// The nearest point of the whole line or circle.
Vec2 projectOnCarrier(const Vec2& p, const Vec2& from, const Segment& segment);

}  // namespace stepmill::planar
