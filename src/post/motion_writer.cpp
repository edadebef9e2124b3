#include "post/motion_writer.h"

#include <fmt/format.h>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

constexpr double kGridPerMm = 1e4;

/// An arc's two radii may differ by this much in the program [mm]; controllers refuse arcs much worse.
constexpr double kRadiusAgreementMm = 1e-3;
/// Arcs that leave their chord by less than half the last decimal are lines.
constexpr double kStraightMm = 0.5 / kGridPerMm;
/// Longer arcs are written as two: a full circle's end is its start, and close ends are ambiguous once
/// rounded.
constexpr double kLongestSweepRad = 1.5 * kPi;

std::string number(std::int64_t grid) {
    const std::int64_t whole = std::abs(grid) / 10000;
    const std::int64_t part = std::abs(grid) % 10000;
    return fmt::format("{}{}.{:04}", grid < 0 ? "-" : "", whole, part);
}

double mm(std::int64_t grid) {
    return static_cast<double>(grid) / kGridPerMm;
}

std::int64_t gridOf(double value_mm) {
    return std::llround(value_mm * kGridPerMm);
}

/// How far the arc bulges from its chord.
double sagitta(double radius_mm, double sweep_rad) {
    return radius_mm * (1 - std::cos(std::abs(sweep_rad) / 2));
}

/// The point nearest to `centre` that is equally far from both ends: the centre the rounded ends ask for.
Vec2 centreBetween(const Vec2& from, const Vec2& to, const Vec2& centre) {
    const Vec2 chord = to - from;
    const Vec2 along = chord.normalized();
    return centre - along * along.dot(centre - (from + to) / 2);
}

}  // namespace

MotionWriter::Point MotionWriter::toGrid(const Vec3& point) {
    return {gridOf(point.x()), gridOf(point.y()), gridOf(point.z())};
}

void MotionWriter::forgetState() {
    known_ = false;
    feed_ = 0;
}

void MotionWriter::begin(int g_word) {
    out_ += fmt::format("N{} G{}", ++block_, g_word);
}

void MotionWriter::feed(double feed_mm_per_min) {
    if (feed_mm_per_min == feed_) return;
    out_ += fmt::format(" F{:.2f}", feed_mm_per_min);
    feed_ = feed_mm_per_min;
}

void MotionWriter::approach(const Vec3& to) {
    const Point target = toGrid(to);
    if (known_ && target == at_) return;
    begin(0);
    out_ += " Z" + number(target.z) + "\n";
    begin(0);
    out_ += " X" + number(target.x) + " Y" + number(target.y) + "\n";
    at_ = target;
    known_ = true;
}

void MotionWriter::straight(int g_word, const Point& to, double feed_mm_per_min) {
    if (to == at_) return;
    begin(g_word);
    if (to.x != at_.x) out_ += " X" + number(to.x);
    if (to.y != at_.y) out_ += " Y" + number(to.y);
    if (to.z != at_.z) out_ += " Z" + number(to.z);
    if (g_word != 0) feed(feed_mm_per_min);
    out_ += "\n";
    at_ = to;
}

void MotionWriter::arcPiece(const Point& to, const Arc& arc, double feed_mm_per_min) {
    const Vec2 from(mm(at_.x), mm(at_.y));
    const Vec2 end(mm(to.x), mm(to.y));
    const auto disagreement = [&](std::int64_t i, std::int64_t j) {
        const Vec2 centre = from + Vec2(mm(i), mm(j));
        return std::abs((centre - from).norm() - (centre - end).norm());
    };
    std::int64_t i = gridOf(arc.centre.x()) - at_.x;
    std::int64_t j = gridOf(arc.centre.y()) - at_.y;
    if (disagreement(i, j) > kRadiusAgreementMm) {
        const Vec2 centre = centreBetween(from, end, arc.centre);
        i = gridOf(centre.x()) - at_.x;
        j = gridOf(centre.y()) - at_.y;
    }
    if (to.x == at_.x && to.y == at_.y) return straight(1, to, feed_mm_per_min);
    const double radius_mm = std::hypot(mm(i), mm(j));
    const double sweep =
        (i == 0 && j == 0) ? 0 : sweepAngle(from, end, Arc{from + Vec2(mm(i), mm(j)), radius_mm, arc.ccw});
    // Rounding may have turned the ends of a tiny arc past each other: then it would run the long way round.
    const bool turned = std::abs(sweep) > kLongestSweepRad + kPi / 4;
    if (sweep == 0 || turned || sagitta(radius_mm, sweep) < kStraightMm)
        return straight(1, to, feed_mm_per_min);
    begin(arc.ccw ? 3 : 2);
    out_ += " X" + number(to.x) + " Y" + number(to.y);
    if (to.z != at_.z) out_ += " Z" + number(to.z);
    out_ += " I" + number(i) + " J" + number(j);
    feed(feed_mm_per_min);
    out_ += "\n";
    at_ = to;
}

void MotionWriter::arc(const Vec3& from, const Move& move, double feed_mm_per_min) {
    const Vec2 start = from.head<2>();
    const Segment segment{move.to.head<2>(), move.arc};
    const double sweep = sweepAngle(start, segment.to, *move.arc);
    if (std::abs(sweep) > kLongestSweepRad) {
        const Vec2 middle = pointAt(start, segment, 0.5);
        const double z = (from.z() + move.to.z()) / 2;
        arcPiece(toGrid(Vec3(middle.x(), middle.y(), z)), *move.arc, feed_mm_per_min);
    }
    arcPiece(toGrid(move.to), *move.arc, feed_mm_per_min);
}

void MotionWriter::write(const Toolpath& path) {
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const double feed_rate = path.feedOf(move.kind);
        if (move.kind == MoveKind::Rapid) {
            straight(0, toGrid(move.to), 0);
        } else if (move.arc) {
            arc(from, move, feed_rate);
        } else {
            straight(1, toGrid(move.to), feed_rate);
        }
        from = move.to;
    }
}

}  // namespace stepmill
