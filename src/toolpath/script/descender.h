#pragma once

#include "toolpath/script/depth_progress.h"
#include "toolpath/script/entry_descent.h"

namespace stepmill::toolpath {

/// Lifts the cutter and comes down for another pass: where it can in air, else as the entry of the component
/// says, at worst along the pass itself.
class Descender {
  public:
    /// Keeps its arguments. `before`: what was clear before the depth.
    Descender(const DepthTask& task, const RingFamily::Component& component, const SweptGround& before,
              EntryDescent& entry, DepthProgress& progress);

    /// Cuts one more pass. \pre some are left
    void goOn();

  private:
    bool comeDownInAir(const Joint& joint);
    bool comeDownOnNeighbour(const Joint& joint);
    void comeDown(const Vec2& at, bool needs_others);
    bool enter(const Joint& joint, bool ready);
    void goOnFromEntry(const Joint& joint, const Joint& from_entry);
    bool rampIsBetter(const Joint& joint) const;
    void rampInto(const Joint& joint);

    const DepthTask& task_;
    const RingFamily::Component& component_;
    const SweptGround& before_;
    EntryDescent& entry_;
    DepthProgress& progress_;
    bool entered_ = false;
};

}  // namespace stepmill::toolpath
