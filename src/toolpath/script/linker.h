#pragma once

#include "toolpath/script/depth_progress.h"

namespace stepmill::toolpath {

/// Goes on to the next pass at depth, without lifting the cutter.
class Linker {
  public:
    /// Keeps its arguments. `before`: what was clear before the depth.
    Linker(const DepthTask& task, const RingFamily::Component& component, const SweptGround& before,
           DepthProgress& progress);

    /// Links to one of the nearest passes that are ready and cuts it; false where no straight way to one of
    /// them is free and quick.
    bool linkOn();

  private:
    bool tryLink(const Joint& joint);
    bool isNeighbour(const Joint& joint) const;
    bool isShorter(const Joint& joint) const;

    const DepthTask& task_;
    const RingFamily::Component& component_;
    const SweptGround& before_;
    DepthProgress& progress_;
};

}  // namespace stepmill::toolpath
