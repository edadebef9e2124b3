#pragma once

#include "stepmill/planar/region.h"

namespace stepmill::clearance {

/// Builds one loop on the grid from edges that follow each other. It leaves out edges of no length: an edge
/// that rounding makes shorter than a few grid steps becomes a line or is dropped.
class LoopDrawer {
  public:
    void start(const Vec2& at);
    /// `edge`: number of the boundary edge it stands for; stretches of one edge become one again.
    void lineTo(const Vec2& to, int edge);
    /// Closes the gap to a point where the last edge should have ended: draws a line if rounding put the
    /// point farther away than an arc's end may lie off its circle.
    void bridgeTo(const Vec2& to);
    /// \param sweep_rad how far the arc turns; negative where it is more than half a turn by that much less
    ///                  than a whole one. Tells a tiny arc from a full turn
    /// \return whether an arc was drawn
    bool arcTo(const Vec2& to, const Arc& arc, double sweep_rad, int edge);
    /// Adds the loop to the region if it encloses anything.
    void closeInto(Region& region);

  private:
    Loop loop_;
    int last_edge_ = -1;
};

}  // namespace stepmill::clearance
