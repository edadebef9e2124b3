#include "report/viewer/packed_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "stepmill/core/error.h"

namespace stepmill::report {
namespace {

using Place = std::array<std::int64_t, 3>;

constexpr std::uint8_t kArcBit = 1U << 3U;
constexpr std::uint8_t kCcwBit = 1U << 4U;
constexpr std::uint8_t kInAirBit = 1U << 5U;
constexpr std::uint8_t kHeightBit = 1U << 6U;
constexpr std::uint8_t kFeedBit = 1U << 7U;

Place placeOf(const Vec3& p) {
    return {packedSteps(p.x()), packedSteps(p.y()), packedSteps(p.z())};
}

/// Writes moves from place to place.
class Writer {
  public:
    explicit Writer(const Vec3& start) : at_(placeOf(start)) {
        for (const std::int64_t value : at_)
            packed_.bytes.number(value);
    }

    void add(const Vec3& from, const Move& move, std::optional<std::uint8_t> load) {
        const Place to = placeOf(move.to);
        // A short arc whose ends round to one place would turn into a whole circle.
        const bool circle = move.arc && move.to.head<2>() == from.head<2>();
        const bool arc = move.arc && (circle || to[0] != at_[0] || to[1] != at_[1]);
        if (!arc && to == at_) return;
        const std::int64_t feed =
            move.kind == MoveKind::Rapid ? feed_mm_per_min_ : std::llround(move.feed_mm_per_min);
        packed_.bytes.byte(headOf(move, arc, to[2] != at_[2], feed != feed_mm_per_min_));
        if (feed != feed_mm_per_min_) packed_.bytes.number(feed);
        feed_mm_per_min_ = feed;
        packed_.bytes.number(to[0] - at_[0]);
        packed_.bytes.number(to[1] - at_[1]);
        if (to[2] != at_[2]) packed_.bytes.number(to[2] - at_[2]);
        if (arc) {
            packed_.bytes.number(packedSteps(move.arc->centre.x()) - at_[0]);
            packed_.bytes.number(packedSteps(move.arc->centre.y()) - at_[1]);
        }
        at_ = to;
        ++packed_.moves;
        if (load) addLoad(*load);
    }

    PackedPath take() && {
        endRun();
        return std::move(packed_);
    }

  private:
    void addLoad(std::uint8_t load) {
        if (load != load_) endRun();
        load_ = load;
        ++run_;
    }

    void endRun() {
        if (run_ == 0) return;
        packed_.loads.number(run_);
        packed_.loads.number(load_);
        run_ = 0;
    }

    static std::uint8_t headOf(const Move& move, bool arc, bool changes_height, bool changes_feed) {
        auto head = static_cast<std::uint8_t>(move.kind);
        if (arc) head |= kArcBit;
        if (arc && move.arc->ccw) head |= kCcwBit;
        if (move.in_air) head |= kInAirBit;
        if (changes_height) head |= kHeightBit;
        if (changes_feed) head |= kFeedBit;
        return head;
    }

    Place at_;
    std::int64_t feed_mm_per_min_ = 0;
    std::int64_t run_ = 0;  ///< so many moves on end have this load
    std::uint8_t load_ = 0;
    PackedPath packed_;
};

double distanceToLine(const Vec3& p, const Vec3& from, const Vec3& to) {
    const Vec3 along = to - from;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0 ? std::clamp((p - from).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (from + share * along - p).norm();
}

/// How far straight moves that come one after another are looked at together.
constexpr std::size_t kMostMerged = 64;

/// The last of the straight moves from `first` on that one straight move can stand for.
std::size_t lastOfStraight(const Toolpath& path, const std::vector<std::uint8_t>& loads, std::size_t first,
                           const Vec3& from, double tolerance_mm) {
    const Move& move = path.moves[first];
    std::size_t last = first;
    while (last + 1 < path.moves.size() && last - first < kMostMerged) {
        const Move& next = path.moves[last + 1];
        if (next.arc || next.kind != move.kind || next.in_air != move.in_air ||
            next.feed_mm_per_min != move.feed_mm_per_min ||
            (!loads.empty() && loads[last + 1] != loads[first]))
            break;
        bool near = true;
        for (std::size_t i = first; near && i <= last; ++i)
            near = distanceToLine(path.moves[i].to, from, next.to) <= tolerance_mm;
        if (!near) break;
        ++last;
    }
    return last;
}

}  // namespace

PackedPath packed(const Toolpath& path, double tolerance_mm, const std::vector<std::uint8_t>& load_classes) {
    STEPMILL_CHECK(load_classes.empty() || load_classes.size() == path.moves.size(), "a load for each move");
    Writer writer(path.start);
    Vec3 from = path.start;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
        if (!path.moves[i].arc) i = lastOfStraight(path, load_classes, i, from, tolerance_mm);
        writer.add(from, path.moves[i], load_classes.empty() ? std::nullopt : std::optional(load_classes[i]));
        from = path.moves[i].to;
    }
    return std::move(writer).take();
}

double fastestFeed(const Toolpath& path) {
    double fastest = 0;
    for (const Move& move : path.moves)
        fastest = std::max(fastest, path.feedOf(move));
    return fastest;
}

PackedBytes packed(const Region& region, double chord_mm) {
    PackedBytes bytes;
    bytes.number(static_cast<std::int64_t>(region.loops.size()));
    for (const Loop& loop : region.loops) {
        const std::vector<Vec2> line = tessellate(loop, chord_mm);
        bytes.number(static_cast<std::int64_t>(line.size()) - 1);
        std::array<std::int64_t, 2> at{0, 0};
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const std::array<std::int64_t, 2> to{packedSteps(line[i].x()), packedSteps(line[i].y())};
            bytes.number(to[0] - at[0]);
            bytes.number(to[1] - at[1]);
            at = to;
        }
    }
    return bytes;
}

}  // namespace stepmill::report
