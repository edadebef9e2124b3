#pragma once

#include <vector>

#include "stepmill/planar/indexed_region.h"

namespace stepmill::toolpath {

/// How much of the front half of a cutter's rim stands in material.
struct Engaged {
    double width_mm = 0;   ///< across the direction of travel
    double angle_rad = 0;  ///< along the rim
};

/// The front half of a cutter's rim at one place of its way: which of it lies in swept ground, and how wide
/// the rest is. Angles are to the direction of travel, from -90 to 90 degrees.
class Rim {
  public:
    struct Span {
        double from_rad;
        double to_rad;
    };
    using Spans = std::vector<Span>;

    /// \param along  unit direction of travel
    Rim(const Vec2& centre, const Vec2& along, double radius_mm);

    /// What lies within `reach_mm` of the edge was swept.
    void cover(const Edge& swept, double reach_mm);
    /// Is nothing of the rim left?
    bool isCovered();
    /// Across the direction of travel, of what is left [mm].
    double freeWidthMm();
    /// The same, of what is left inside the region.
    /// \param near  its edges that may meet the rim
    double freeWidthInMm(const IndexedRegion& region, const std::vector<const Edge*>& near);
    /// The parts of what is left that lie inside the region; neighbours may share an end.
    Spans freeIn(const IndexedRegion& region, const std::vector<const Edge*>& near);
    /// What is left inside the region, but for grazes: stretches that hold none of the deep parts.
    Engaged engagedIn(const IndexedRegion& region, const std::vector<const Edge*>& near, const Spans& deep);

  private:
    Vec2 at(double angle_rad) const;
    Vec2 at(double angle_rad, double radius_mm) const;
    bool isInside(const IndexedRegion& region, double angle_rad) const;
    double angleOf(const Vec2& direction) const;
    void addAngle(double angle_rad, std::vector<double>& into) const;
    void meetCircle(const Vec2& centre, double radius_mm, std::vector<double>& into) const;
    void meetLine(const Vec2& p, const Vec2& along, std::vector<double>& into) const;
    void meetEdge(const Edge& edge, std::vector<double>& into) const;
    void settle();

    Vec2 centre_;
    Vec2 along_;
    double radius_mm_;
    Spans covered_;
    Spans free_;
    bool settled_ = false;
    std::vector<double> angles_;  ///< reused
};

}  // namespace stepmill::toolpath
