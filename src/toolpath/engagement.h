#pragma once

#include <vector>

#include "toolpath/layer_script.h"

namespace stepmill::toolpath {

/// Cuts up to this many times the step-over run at the cutting feed: rounding and cusps, no more.
inline constexpr double kWidestCutShare = 1.1;

/// Tells how wide the cutter cuts on its way through a layer, from what it has swept there before.
class Engagement {
  public:
    /// Keeps `task`.
    Engagement(const ClearingTask& task, double radius_mm, double step_over_mm);

    /// Splits the path where the cut becomes wider than the step-over or narrower again, and adds it to what
    /// is swept. `wide` gets one entry for each segment of the result. Seen at points a few tenths of the
    /// radius apart; stretches are told wide from the last narrow point on to the next one.
    Path mark(const Path& path, std::vector<bool>& wide);

    /// Adds a way that is gone at a feed of its own.
    void add(const Path& path);

    /// Across the direction of travel, what of the front half of the cutter's rim stands in material [mm].
    double widthAt(const Vec2& at, const Vec2& along) const { return widthAt(at, along, swept_); }

  private:
    double widthAt(const Vec2& at, const Vec2& along, const std::vector<Edge>& swept) const;
    bool isMaterial(const Vec2& p, const std::vector<Edge>& swept) const;

    const ClearingTask* task_;
    double radius_mm_;
    double step_over_mm_;
    std::vector<Edge> swept_;
};

/// Marks the wide stretches of a layer's cuts and links, in the order they are made.
void markWideCuts(std::vector<ScriptStep>& steps, Engagement& engagement);

}  // namespace stepmill::toolpath
