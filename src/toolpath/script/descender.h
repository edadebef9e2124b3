#pragma once

#include <vector>

#include "toolpath/script/depth_progress.h"
#include "toolpath/script/entry_descent.h"

namespace stepmill::toolpath {

/// Lifts the cutter and comes down for another pass: where it can in air, else by the quickest way that the
/// tool may take through material. See docs/algorithms/entries.md.
class Descender {
  public:
    /// Keeps its arguments. `before`: what was clear before the depth.
    Descender(const DepthTask& task, const RingFamily::Component& component, const SweptGround& before,
              EntryDescent& entry, DepthProgress& progress);

    /// Cuts one more pass.
    /// \pre some are left
    void goOn();
    /// A short way off the wall that the last pass ended beside, over ground that its spot has cleared; none
    /// where there is no such ground.
    void leaveWall();

  private:
    enum class WayDown { AlongPass, PlungeOntoPass, PlungeAtEntry, ByEntry };
    struct PricedWay {
        WayDown way;
        double minutes;  ///< more than a cutter takes that is at depth where the pass begins
    };

    bool comeDownInAir(const Joint& joint);
    bool comeDownOnNeighbour(const Joint& joint);
    void comeDown(const Vec2& at, bool needs_others);
    bool enter(const Joint& joint, bool ready);
    /// The ways that the tool may take, the quickest first.
    std::vector<PricedWay> waysDown(const Joint& joint, const Joint& from_entry) const;
    bool goDown(WayDown way, const Joint& joint, const Joint& from_entry);
    void plungeOnto(const Joint& joint);
    void goOnFromEntry(const Joint& joint, const Joint& from_entry);
    bool mayPlungeOnto(const Pass& pass) const;
    double minutesOfPlunge() const;
    bool mayRampAlong(const Pass& pass) const;
    double minutesAlong(const Pass& pass) const;
    double depthOfCut() const;
    double widthAfterPlunge(const Path& ring) const;
    double minutesByEntry() const;
    void rampInto(const Joint& joint);

    const DepthTask& task_;
    const RingFamily::Component& component_;
    const SweptGround& before_;
    EntryDescent& entry_;
    DepthProgress& progress_;
    bool entered_ = false;
};

}  // namespace stepmill::toolpath
