#pragma once

#include <optional>

#include "toolpath/emit.h"
#include "toolpath/layer_script.h"
#include "toolpath/passes.h"

namespace stepmill::toolpath {

/// How one component of the free centres is cut at every depth, by one pattern.
struct RegionCut {
    std::vector<LayerBlock> blocks;  ///< one after another, each over all depths
    PatternTime time;
};

/// The components' cuts: every pattern is weighed by the moves it really takes.
class RegionCutter {
  public:
    /// `frame`: a path without moves, for layers and feeds. Keeps its arguments.
    RegionCutter(const LayerTask& task, const PassMaker& passes, const Toolpath& frame, double ramp_angle_rad,
                 const Machine& machine);

    /// The cut by the pattern the task asks for or, of all, the quickest; nothing where there is nothing to
    /// cut. `weighed`: what was weighed, the one that is taken first.
    std::optional<RegionCut> choose(const RingFamily::Component& component, const Entry& entry,
                                    RegionPatterns& weighed) const;

    /// Writes a cut over all depths.
    void write(const RegionCut& cut, Over first_over, MoveWriter& writer) const;

  private:
    RegionCut cut(const RingFamily::Component& component, const Entry& entry,
                  const RingFamily::Variant& variant, const std::vector<Pass>& passes) const;
    double leastTime(const std::vector<Pass>& passes) const;
    double timeOf(const RegionCut& cut) const;
    double levelOf(int layer) const;
    LayerHeights heights(int from_layer, int to_layer) const;
    bool writeLoneRing(const LayerBlock& layer, MoveWriter& writer) const;

    const LayerTask& task_;
    const PassMaker& passes_;
    const Toolpath& frame_;
    double ramp_angle_rad_;
    const Machine& machine_;
};

}  // namespace stepmill::toolpath
