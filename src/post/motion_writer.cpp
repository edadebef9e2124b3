#include "post/motion_writer.h"

#include <fmt/format.h>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// An arc's two radii may differ by this much in the program [mm]; controllers refuse arcs much worse.
constexpr double kRadiusAgreementMm = 1e-3;
/// Controllers refuse arcs of next to no radius; their ends are as good as one point [mm].
constexpr double kLeastWrittenRadiusMm = 4e-4;
/// Arcs that leave their chord by less than half the last metric decimal are lines.
constexpr double kStraightMm = 0.5e-4;
/// Longer arcs are written as two: a full circle's end is its start, and close ends are ambiguous once
/// rounded.
constexpr double kLongestSweepRad = 1.5 * kPi;

/// Rounding raises no feed by more than this share: slow ones are cut off instead.
constexpr double kFeedRaise = 5e-4;

/// Inches have less in front of the point, so one decimal more.
std::string feedWord(double feed_mm_per_min, bool inch) {
    const double feed = inch ? mmToInch(feed_mm_per_min) : feed_mm_per_min;
    const int decimals = inch ? 3 : 2;
    const double steps = feed * std::pow(10.0, decimals);
    const bool raised = std::round(steps) > steps * (1 + kFeedRaise);
    return fmt::format(" F{:.{}f}", raised ? std::floor(steps) / std::pow(10.0, decimals) : feed, decimals);
}

/// A pitch needs more decimals than a place: a turn's error adds up with the turns.
std::string pitchWord(double pitch_mm, bool inch) {
    const int decimals = inch ? 8 : 6;
    std::string number = fmt::format("{:.{}f}", inch ? mmToInch(pitch_mm) : pitch_mm, decimals);
    number.erase(number.find_last_not_of('0') + 1);
    return " K" + number;
}

/// Of a tap: pitch x speed, rounded to the last decimal and to nothing else.
std::string tapFeedWord(const TapCycle& cycle, bool inch) {
    const double feed = cycle.pitch_mm * cycle.speed_rpm;
    return fmt::format(" F{:.{}f}", inch ? mmToInch(feed) : feed, inch ? 3 : 2);
}

/// G word of the holes [RS274/NGC, 3.5.16].
int cycleCode(const DrillCycle& cycle, bool dwells) {
    if (cycle.peck_mm > 0) return cycle.breaks_chips ? 73 : 83;
    if (cycle.feeds_out) return dwells ? 89 : 85;
    return dwells ? 82 : 81;
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

MotionWriter::MotionWriter(std::string& out, bool inch)
    : out_(out),
      inch_(inch),
      grid_per_mm_(inch ? std::pow(10.0, kInchDecimals) / kMillimetresPerInch
                        : std::pow(10.0, kMetricDecimals)) {}

std::string MotionWriter::number(Grid grid) const {
    const int decimals = inch_ ? kInchDecimals : kMetricDecimals;
    const Grid one = inch_ ? 100000 : 10000;
    return fmt::format("{}{}.{:0{}}", grid < 0 ? "-" : "", std::abs(grid) / one, std::abs(grid) % one,
                       decimals);
}

double MotionWriter::mm(Grid grid) const {
    return static_cast<double>(grid) / grid_per_mm_;
}

MotionWriter::Grid MotionWriter::gridOf(double value_mm) const {
    return std::llround(value_mm * grid_per_mm_);
}

MotionWriter::Point MotionWriter::toGrid(const Vec3& point) const {
    return {gridOf(point.x()), gridOf(point.y()), gridOf(point.z())};
}

std::string MotionWriter::nextNumber() {
    return fmt::format("N{}", ++block_);
}

void MotionWriter::begin(int g_word) {
    out_ += nextNumber() + fmt::format(" G{}", g_word);
}

void MotionWriter::feed(double feed_mm_per_min) {
    if (feed_mm_per_min == feed_) return;
    out_ += feedWord(feed_mm_per_min, inch_);
    feed_ = feed_mm_per_min;
}

void MotionWriter::approach(const Vec3& to, std::string_view z_words, bool from_home) {
    at_ = toGrid(to);
    feed_ = 0;
    const auto over = [&] {
        begin(0);
        out_ += " X" + number(at_.x) + " Y" + number(at_.y) + "\n";
    };
    if (from_home) over();
    begin(0);
    out_ += z_words;
    out_ += " Z" + number(at_.z) + "\n";
    if (!from_home) over();
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
    if (sweep == 0 || turned || radius_mm < kLeastWrittenRadiusMm || sagitta(radius_mm, sweep) < kStraightMm)
        return straight(1, to, feed_mm_per_min);
    begin(arc.ccw ? 3 : 2);
    out_ += " X" + number(to.x) + " Y" + number(to.y);
    if (to.z != at_.z) out_ += " Z" + number(to.z);
    out_ += " I" + number(i) + " J" + number(j);
    feed(feed_mm_per_min);
    out_ += "\n";
    at_ = to;
}

void MotionWriter::arc(const Vec3& from, const FedMove& fed) {
    const Move& move = fed.move;
    const Vec2 start = from.head<2>();
    const Segment segment{move.to.head<2>(), move.arc};
    const double sweep = sweepAngle(start, segment.to, *move.arc);
    if (std::abs(sweep) > kLongestSweepRad) {
        const Vec2 middle = pointAt(start, segment, 0.5);
        const double z = (from.z() + move.to.z()) / 2;
        arcPiece(toGrid(Vec3(middle.x(), middle.y(), z)), *move.arc, fed.feed_mm_per_min);
    }
    arcPiece(toGrid(move.to), *move.arc, fed.feed_mm_per_min);
}

void MotionWriter::write(const Vec3& start, const std::vector<FedMove>& moves) {
    Vec3 from = start;
    for (const FedMove& fed : moves) {
        if (fed.move.kind == MoveKind::Rapid) {
            straight(0, toGrid(fed.move.to), 0);
        } else if (fed.move.arc) {
            arc(from, fed);
        } else {
            straight(1, toGrid(fed.move.to), fed.feed_mm_per_min);
        }
        from = fed.move.to;
    }
}

void MotionWriter::drill(const DrillCycle& cycle, std::string_view dwell_word) {
    const auto over = [&](const Vec2& place) { return toGrid({place.x(), place.y(), cycle.initial_z_mm}); };
    const Point at = over(cycle.places.front());
    if (at != at_) straight(0, at, 0);
    // Back to the height it starts from, so that the next way over is as high as this one.
    out_ += fmt::format("N{} G98 G{} X{} Y{} Z{} R{}", ++block_, cycleCode(cycle, !dwell_word.empty()),
                        number(at.x), number(at.y), number(gridOf(cycle.bottom_z_mm)),
                        number(gridOf(cycle.r_z_mm)));
    // Rounded down: a peck is never deeper than asked.
    if (cycle.peck_mm > 0)
        out_ += " Q" + number(std::max<Grid>(1, static_cast<Grid>(cycle.peck_mm * grid_per_mm_)));
    out_ += dwell_word;
    feed(cycle.feed_mm_per_min);
    out_ += "\n";
    for (auto place = cycle.places.begin() + 1; place != cycle.places.end(); ++place) {
        at_ = over(*place);
        out_ += nextNumber() + " X" + number(at_.x) + " Y" + number(at_.y) + "\n";
    }
    out_ += nextNumber() + " G80\n";
}

void MotionWriter::tapCoupled(const TapCycle& cycle) {
    const auto at = [&](const Vec2& place, double z_mm) { return toGrid({place.x(), place.y(), z_mm}); };
    for (const Vec2& place : cycle.places) {
        straight(0, at(place, cycle.initial_z_mm), 0);
        straight(0, at(place, cycle.r_z_mm), 0);
        out_ += nextNumber() + " G33.1 Z" + number(gridOf(cycle.bottom_z_mm)) +
                pitchWord(cycle.pitch_mm, inch_) + "\n";
        // It comes back to where it began.
        straight(0, at(place, cycle.initial_z_mm), 0);
    }
}

void MotionWriter::tapRigid(const TapCycle& cycle) {
    const auto over = [&](const Vec2& place) { return toGrid({place.x(), place.y(), cycle.initial_z_mm}); };
    straight(0, over(cycle.places.front()), 0);
    out_ += nextNumber() + fmt::format(" M29 S{:.0f}\n", cycle.speed_rpm);
    out_ += nextNumber() + fmt::format(" G98 G84 X{} Y{} Z{} R{}", number(at_.x), number(at_.y),
                                       number(gridOf(cycle.bottom_z_mm)), number(gridOf(cycle.r_z_mm)));
    out_ += tapFeedWord(cycle, inch_) + "\n";
    for (auto place = cycle.places.begin() + 1; place != cycle.places.end(); ++place) {
        at_ = over(*place);
        out_ += nextNumber() + " X" + number(at_.x) + " Y" + number(at_.y) + "\n";
    }
    out_ += nextNumber() + " G80\n";
    feed_ = 0;
}

}  // namespace stepmill
