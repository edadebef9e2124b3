#pragma once

#include <vector>

#include "stepmill/toolpath/toolpath.h"
#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

/// One cut at a depth: a closed ring, what clipping has left of one, in climb direction, or joined lines.
struct Pass {
    Path path;
    bool closed = false;
    bool reversible = false;  ///< may as well be cut from its end
    /// Count of step-overs from the boundary the pattern starts at.
    int level = 0;
    /// A disc at the start of an open pass meets no material: the cutter may come down there in air.
    bool starts_in_air = false;
    bool ends_in_air = false;  ///< the same of its end
    /// Passes that come before this one, so that it cuts no wider than the step-over.
    std::vector<int> after;
    /// Passes one step-over away: the straight link to them cuts no wider than the step-over.
    std::vector<int> neighbours;
};

/// Clips the curves of a pattern to what one task has left to cut.
class PassMaker {
  public:
    /// Keeps its arguments.
    PassMaker(const ClearingTask& task, const RingFamily& family, const Tolerances& tol);

    /// Is there anything to do in the component?
    bool concerns(const RingFamily::Component& component) const;

    /// Are the task's centres less than the free ones without those that are cleared?
    bool isLimited() const { return limited_; }

    /// The passes that clear the task's centres at one depth in the component. Every point of the target that
    /// a disc of radius r reaches from there lies within r of a pass, or has been cleared before
    /// [docs/algorithms/contour-parallel.md, docs/algorithms/parallel-lines.md].
    std::vector<Pass> make(const RingFamily::Component& component, const RingFamily::Variant& variant) const;

  private:
    class Clipper;

    const ClearingTask& task_;
    const RingFamily& family_;
    const Tolerances& tol_;
    IndexedRegion target_;
    IndexedRegion cleared_;  ///< centres
    IndexedRegion centres_;  ///< where the task is limited
    /// The task's centres are less than free centres without cleared ones.
    bool limited_ = false;
    Box2 wanted_;
};

}  // namespace stepmill::toolpath
