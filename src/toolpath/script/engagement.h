#pragma once

#include <vector>

#include "stepmill/planar/indexed_region.h"
#include "toolpath/script/depth_script.h"

namespace stepmill::toolpath {

/// Cuts up to this many times the step-over run at the cutting feed: rounding and cusps, no more.
inline constexpr double kWidestCutShare = 1.1;

/// Tells how wide the cutter cuts on its way through a depth of cut. It knows the ground swept there before.
class Engagement {
  public:
    Engagement(const ClearingTask& task, double radius_mm, double step_over_mm);

    /// Splits the path where the cut becomes wider than the step-over or narrower again, and adds it to the
    /// swept ground. `wide` gets one entry for each segment of the result. The width is taken at points a few
    /// tenths of the radius apart; a wide stretch reaches from the last narrow point to the next one.
    Path mark(const Path& path, std::vector<bool>& wide);

    /// Adds a way that has a feed of its own, whatever its width.
    void add(const Path& path);

    /// Width of the part of the cutter's front rim that stands in material, across the direction of travel
    /// [mm].
    double widthAt(const Vec2& at, const Vec2& along) const { return widthAt(at, along, swept_); }

  private:
    double widthAt(const Vec2& at, const Vec2& along, const std::vector<Edge>& swept) const;
    bool isMaterial(const Vec2& p, const std::vector<Edge>& swept) const;

    IndexedRegion target_;
    IndexedRegion cleared_;  ///< centres
    double radius_mm_;
    double step_over_mm_;
    std::vector<Edge> swept_;
};

/// Marks the wide stretches of a script's cuts and links, in the order they are made.
void markWideCuts(std::vector<ScriptStep>& steps, Engagement& engagement);

}  // namespace stepmill::toolpath
