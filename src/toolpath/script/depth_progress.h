#pragma once

#include <optional>
#include <vector>

#include "stepmill/planar/path_parts.h"
#include "toolpath/script/depth_script.h"

namespace stepmill::toolpath {

/// A straight link to a neighbouring pass may be this many step-overs long.
inline constexpr double kNeighbourLink = 2.0;

/// Where a pass would be joined.
struct Joint {
    int pass = 0;
    double distance_mm = 0;
    NearestPoint at;
    bool backwards = false;
};

/// A way over the ground from where the cutter was to where it comes down.
struct Descent {
    std::size_t step;  ///< of the script
    Vec2 from;
    Vec2 to;
    /// The descent, or a link after it, counts on ground that was cleared before.
    bool needs_others;
};

/// One depth of cut while its script is made: which passes are left, where the cutter is, what it has swept.
///
/// Passes are named by their index. The steps from one descent to the next one form a spot.
class DepthProgress {
  public:
    /// Keeps `passes`. `ground`: what is clear before the depth is cut.
    DepthProgress(const std::vector<Pass>& passes, const SweptGround& ground);

    // Passes

    const std::vector<Pass>& passes() const { return passes_; }
    const Pass& pass(int i) const { return passes_[static_cast<std::size_t>(i)]; }
    int count() const { return static_cast<int>(passes_.size()); }
    /// Passes that are neither cut nor found needless.
    int left() const { return left_; }
    bool isDone(int i) const { return done_[static_cast<std::size_t>(i)]; }
    /// Are all passes done that it waits for?
    bool isReady(int i) const;
    bool wasCut(int i) const { return spot_of_[static_cast<std::size_t>(i)].has_value(); }
    /// The spot a pass was cut in.
    /// \pre wasCut(i)
    std::size_t spotOf(int i) const { return spot_of_[static_cast<std::size_t>(i)].value(); }
    /// The pass cut last; -1 before the first.
    int last() const { return last_; }
    /// Marks a pass as done: it is needless, or has been cut.
    void settle(int i);

    /// Where a pass is joined from a point: a ring at its nearest point, others at an end.
    Joint jointWith(int i, const Vec2& from) const;
    /// Passes still to be cut that are ready, or those that are not, nearest to the cutter first.
    std::vector<Joint> waiting(bool ready) const;
    /// The pass as it is cut from the joint on.
    Path from(const Joint& joint) const;

    // Script

    const Vec2& at() const { return at_; }
    /// Direction in which the last pass ends.
    const Vec2& along() const { return along_; }
    /// Adds what the passes of the current spot have swept.
    void addSpotTo(SweptGround& ground) const;
    /// The ground swept so far, and the ground that was clear before.
    const SweptGround& swept() const { return swept_; }
    void addSwept(const Edge& edge) { swept_.add(edge); }
    const std::vector<ScriptStep>& steps() const { return steps_; }
    const std::vector<Descent>& descents() const { return descents_; }

    void descend(const ScriptStep& step, const Vec2& to, bool needs_others = true);
    /// Says that the current spot counts on ground that other spots have cleared.
    void needOthers() { descents_.back().needs_others = true; }
    /// Says where the descent has left the cutter.
    void standAt(const Vec2& at) { at_ = at; }
    void link(const Vec2& to, bool in_air);
    void cut(const Joint& joint);
    /// Says that a pass has been cut along that path.
    void finish(int i, const Path& path);

  private:
    const std::vector<Pass>& passes_;
    std::vector<bool> done_;
    std::vector<std::optional<std::size_t>> spot_of_;
    int left_;
    int last_ = -1;
    SweptGround swept_;
    std::vector<ScriptStep> steps_;
    std::vector<Descent> descents_;
    Vec2 at_ = Vec2::Zero();
    Vec2 along_ = Vec2::UnitX();
};

}  // namespace stepmill::toolpath
