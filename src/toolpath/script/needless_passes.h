#pragma once

#include <vector>

#include "toolpath/script/depth_progress.h"

namespace stepmill::toolpath {

/// Settles passes that would take skins alone.
class NeedlessPasses {
  public:
    /// Keeps its arguments.
    NeedlessPasses(const DepthTask& task, DepthProgress& progress);

    /// Drops innermost rings whose ground the next rings out sweep too. These are then the ones that cut full
    /// width, as innermost rings always do.
    /// \pre no pass has been cut
    void dropInnermost();

    /// Drops passes that are ready and lie over ground that is proven clear by now, as along an open side
    /// that the next ring in has reached before. Looks at each pass once.
    void dropCleared();

    /// The ground that the passes still to be cut will sweep.
    SweptGround groundOfPasses() const { return groundOfPasses(-1); }

  private:
    SweptGround groundOfPasses(int without) const;
    bool isInnermost(const Pass& pass) const;
    bool isNeedless(const SweptGround& ground, const Path& path) const;

    const DepthTask& task_;
    DepthProgress& progress_;
    std::vector<bool> looked_at_;  ///< by dropCleared()
};

}  // namespace stepmill::toolpath
