#pragma once

#include <vector>

#include "toolpath/script/depth_progress.h"

namespace stepmill::toolpath {

/// Down through material, or beside it, as the entry of a component says.
class EntryDescent {
  public:
    /// Keeps its arguments. `before`: what was clear before the depth; `passes_ground`: what its passes will
    /// sweep.
    EntryDescent(const DepthTask& task, const RingFamily::Component& component, const Entry& entry,
                 const SweptGround& before, const SweptGround& passes_ground, DepthProgress& progress);

    const Entry& entry() const { return entry_; }
    bool isOpen() const { return entry_.kind == EntryKind::OpenEdge; }
    /// Has a tool before cleared the place within the component, as the drill that makes room for a mill?
    bool isCleared() const;

    /// May the axis go straight from a to b? An open edge's entry may lie outside the component, clear of
    /// everything.
    bool isFree(const Vec2& a, const Vec2& b) const;

    /// Adds the way down; false when the entry does not keep the guard from the walls.
    bool goDown(const Vec2& towards);
    /// The same straight down at the entry's place.
    /// \pre not over an open edge
    bool goDownPlunge();

    /// Is a curve no narrower than the helix or ramp found for the tool? A narrower one would be steep for
    /// the cutter's middle, where it may not cut.
    /// Where no helix or ramp was found, a curve that is no mere turning on the spot will do.
    bool isAsWide(const Path& curve) const;

    /// The first part of a way in over an open edge, up to where the disc meets the target.
    void linkThroughAir(const Vec2& to);

  private:
    bool goDownHelix(const Vec2& towards);
    bool goDownRamp();
    bool goDownBeside();
    bool needsLevel(const std::vector<Edge>& descent);

    const DepthTask& task_;
    const RingFamily::Component& component_;
    const Entry& entry_;
    const SweptGround& before_;
    const SweptGround& passes_ground_;
    DepthProgress& progress_;
};

}  // namespace stepmill::toolpath
