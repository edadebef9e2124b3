#pragma once

#include <optional>

#include "toolpath/emit.h"
#include "toolpath/patterns/passes.h"
#include "toolpath/script/depth_script.h"
#include "toolpath/script/engagement.h"

namespace stepmill::toolpath {

/// Do shank or holder come below the top of what the task cuts?
bool dips(const ClearingTask& task);

/// How one component of the free centres is cut at every depth, by one pattern.
struct RegionCut {
    std::vector<DepthBlock> blocks;  ///< one after another, each over all depths
    PatternTime time;
};

/// Is the one taken for the other: does it save more than rounding?
bool isQuicker(const PatternTime& one, const PatternTime& other);

/// The components' cuts: every pattern is weighed by the moves it really takes.
class RegionCutter {
  public:
    /// `frame`: a path without moves, for depths and feeds. Keeps its arguments.
    RegionCutter(const DepthTask& task, const PassMaker& passes, const Toolpath& frame, double ramp_angle_rad,
                 const Machine& machine);

    /// The cut by the pattern the task asks for or, of all, the quickest; nothing where there is nothing to
    /// cut. `weighed`: what was weighed, the one that is taken first.
    std::optional<RegionCut> choose(const RingFamily::Component& component, const Entry& entry,
                                    RegionPatterns& weighed) const;

    /// Writes the cuts of several components, each over all depths, in the order with the shortest ways
    /// between them, and retracts.
    /// \param weighed  what was weighed for each: goes into the path in the same order
    void write(const std::vector<RegionCut>& cuts, std::vector<RegionPatterns> weighed, Toolpath& path) const;
    /// The cut's pattern with the time that it takes.
    PatternTime timed(const RegionCut& cut) const;

  private:
    void write(const RegionCut& cut, Over first_over, MoveWriter& writer) const;
    RegionCut cut(const RingFamily::Component& component, const Entry& entry,
                  const RingFamily::Variant& variant, const std::vector<Pass>& passes) const;
    double leastTime(const std::vector<Pass>& passes) const;
    double timeOf(const RegionCut& cut) const;
    double floorOf(int depth) const;
    DepthHeights heights(int from_depth, int to_depth) const;
    void takeIfQuicker(RegionCut& cut, std::vector<DepthBlock> blocks) const;
    bool writeLoneRing(const DepthBlock& block, Over first_over, MoveWriter& writer) const;
    void writeDownAlong(const Path& ring, Over first_over, MoveWriter& writer) const;

    const DepthTask& task_;
    const PassMaker& passes_;
    const Toolpath& frame_;
    double ramp_angle_rad_;
    const Machine& machine_;
    Engagement untouched_;  ///< where each way to cut begins
};

}  // namespace stepmill::toolpath
