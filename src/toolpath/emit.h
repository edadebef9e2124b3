#pragma once

#include <vector>

#include "stepmill/toolpath/toolpath.h"
#include "toolpath/script/depth_script.h"

namespace stepmill::toolpath {

/// Rapids come down to this far over material or over the depth they may reach, then feed [mm].
inline constexpr double kApproachMm = 1.0;
/// Descents through material begin this far over it [mm].
inline constexpr double kDescentStartMm = 0.2;

/// Heights of one depth of cut, and how to descend through material.
struct DepthHeights {
    double above_mm;       ///< the level the depth starts from: the floor of the one before, or the top
    double floor_mm;       ///< the level it is cut to
    double last_floor_mm;  ///< of the feature
    double top_mm;         ///< of the feature
    double retract_mm;
    double ramp_angle_rad;
    double stock_top_mm = 0;  ///< from where lifts for chips count
};

/// Turns scripts into moves.
class MoveWriter {
  public:
    explicit MoveWriter(Toolpath& path) : path_(path) {}

    /// Ends at depth, where the last pass ends.
    void writeDepth(const std::vector<ScriptStep>& script, Over first_over, const DepthHeights& heights);
    /// A closed ring over several depths of cut without leaving it: down along its last `descent_mm`, round
    /// to there, down again, and at last level along the ramp; ends where the ring starts.
    /// \pre descent_mm < length(ring)
    void writeRing(const Path& ring, double descent_mm, Over first_over,
                   const std::vector<DepthHeights>& depths);
    /// Up to the retract height.
    void retract();

    Vec2 at() const { return at_.head<2>(); }

  private:
    void write(const ComeDown& step);
    void write(const RampDown& step);
    void write(const PlungeDown& step);
    void write(const RampAlong& step);
    void write(const Link& step);
    void write(const Cut& step);
    void write(const Glide& step);

    /// Up, over, and down to a height that is known to be clear.
    void approach(const Vec2& at, double clear_z_mm, Over over);
    void descendTo(const Vec2& at, Over over);
    bool staysDown(const Vec2& at) const;
    bool liftsForChips(double each_mm) const;
    double crossingZ(Over over) const;
    /// Feeds the moves from the first on, which go down.
    void feedHelix(std::size_t first, double feed_mm_per_min);
    void along(const Path& path, MoveKind kind, double to_z_mm);
    /// The level leg after a ramp cuts the full width of the slope.
    MoveKind levelKind() const { return path_.slot_feed_mm_per_min > 0 ? MoveKind::Slot : MoveKind::Feed; }
    void add(MoveKind kind, const Vec3& to, const std::optional<Arc>& arc = std::nullopt,
             bool in_air = false);

    Toolpath& path_;
    DepthHeights heights_{};
    Vec3 at_ = Vec3::Zero();
};

/// The highest feed at which a move of that length sinks no faster than the plunge feed; programs round its
/// heights.
double sinkingFeed(double plunge_feed_mm_per_min, double length_mm, double drop_mm);

}  // namespace stepmill::toolpath
