#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "post/drill_cycle.h"
#include "post/tap_cycle.h"
#include "stepmill/post/post.h"

namespace stepmill {

/// Of coordinates.
inline constexpr int kMetricDecimals = 4;
inline constexpr int kInchDecimals = 5;

/// Writes moves as numbered G-code blocks, in mm with 4 decimals or in inches with 5.
///
/// Positions are kept as the controller will read them, in whole last decimals, so that rounding never adds
/// up and an arc's centre fits the points that are really in the program.
class MotionWriter {
  public:
    explicit MotionWriter(std::string& out, bool inch = false);

    /// The number of the next block, as a word, for a block that is written elsewhere.
    std::string nextNumber();
    /// To the first place of an operation; the blocks name place and feed in full, whatever was before.
    /// \param z_words  go with the block in z: the tool's length offset
    /// \param from_home  at the top of the machine's travel over, then down; else up first, then over
    void approach(const Vec3& to, std::string_view z_words, bool from_home);
    /// Moves that start at `start`, where the tool is.
    void write(const Vec3& start, const std::vector<FedMove>& moves);
    /// A hole from where the tool is, as G81, or G83 with pecks, or G82 with `dwell_word` (" P0.5").
    void drill(const DrillCycle& cycle, std::string_view dwell_word);

    /// Holes from where the tool is, as G33.1, which LinuxCNC couples to the spindle both ways.
    void tapCoupled(const TapCycle& cycle);
    /// The same as M29 and G84 of a Fanuc, with F as pitch x speed.
    void tapRigid(const TapCycle& cycle);

  private:
    using Grid = std::int64_t;

    struct Point {
        Grid x = 0;
        Grid y = 0;
        Grid z = 0;
        bool operator==(const Point&) const = default;
    };

    Grid gridOf(double value_mm) const;
    double mm(Grid grid) const;
    std::string number(Grid grid) const;
    Point toGrid(const Vec3& point) const;

    void straight(int g_word, const Point& to, double feed_mm_per_min);
    void arc(const Vec3& from, const FedMove& move);
    void arcPiece(const Point& to, const Arc& arc, double feed_mm_per_min);
    void begin(int g_word);
    void feed(double feed_mm_per_min);

    std::string& out_;
    bool inch_;
    double grid_per_mm_;
    Point at_;
    double feed_ = 0;
    long block_ = 0;
};

}  // namespace stepmill
