#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

/// Writes moves as numbered G-code blocks with 4 decimals.
///
/// Positions are kept as the controller will read them, in whole ten-thousandths of a millimetre, so that
/// rounding never adds up and an arc's centre fits the points that are really in the program.
class MotionWriter {
  public:
    explicit MotionWriter(std::string& out) : out_(out) {}

    /// After a tool change nothing is taken for granted: the next block names its place and feed in full.
    void forgetState();
    /// Straight up or down to `z_mm`, then over to x, y: how a tool comes to its first cut.
    void approach(const Vec3& to);
    /// Moves of a path that starts where the tool is.
    void write(const Toolpath& path);

  private:
    using Grid = std::int64_t;

    struct Point {
        Grid x = 0;
        Grid y = 0;
        Grid z = 0;
        bool operator==(const Point&) const = default;
    };

    static Point toGrid(const Vec3& point);
    void straight(int g_word, const Point& to, double feed_mm_per_min);
    void arc(const Vec3& from, const Move& move, double feed_mm_per_min);
    void arcPiece(const Point& to, const Arc& arc, double feed_mm_per_min);
    void begin(int g_word);
    void feed(double feed_mm_per_min);

    std::string& out_;
    Point at_;
    bool known_ = false;
    double feed_ = 0;
    long block_ = 0;
};

}  // namespace stepmill
