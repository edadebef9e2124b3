#pragma once

#include "toolpath/patterns/passes.h"
#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

/// Where an adaptive path may go in one region, and where it may begin.
struct AdaptiveRoom {
    Region room;     ///< centres that it has to clear, and air beside them
    Region cleared;  ///< of these, where the disc meets no material
};

/// Finds the rooms of a task's regions.
class RoomFinder {
  public:
    /// Keeps its arguments.
    RoomFinder(const ClearingTask& task, double radius_mm, bool limited, const Tolerances& tol);

    AdaptiveRoom roomOf(const RingFamily::Component& component) const;

  private:
    Region airBeside(const RingFamily::Component& component) const;

    const ClearingTask& task_;
    double radius_mm_;
    bool limited_;
    const Tolerances& tol_;
};

}  // namespace stepmill::toolpath
