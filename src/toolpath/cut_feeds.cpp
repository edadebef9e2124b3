// Feeds by what the moves of a finished path cut.

#include "stepmill/toolpath/cut_feeds.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"
#include "toolpath/emit.h"
#include "toolpath/engagement/feed_pieces.h"

namespace stepmill {
namespace {

/// Widths are told apart by this share of the diameter ...
constexpr double kBandShare = 0.05;
/// ... and one this much over the step-over is still that.
constexpr double kStepOverRounding = 0.005;
/// Swept ground counts as narrower by this share of the radius: twice what proofs take.
constexpr double kCuspShare = 0.01;
/// Cuts narrower than this share of the diameter are air.
constexpr double kAirShare = 0.005;

double bandOf(double width_mm, const CuttingFacts& facts) {
    const double step_mm = kBandShare * facts.diameter_mm;
    const double band_mm = std::ceil(width_mm / step_mm - kStepOverRounding) * step_mm;
    const bool is_step_over = width_mm <= facts.step_over_mm + kStepOverRounding * facts.diameter_mm;
    return is_step_over ? std::min(band_mm, facts.step_over_mm) : band_mm;
}

/// Longer arcs are gone as two, as programs have them: each piece is looked at from its own start.
constexpr double kLongestArcRad = 1.5 * kPi;

/// The moves with their long arcs in halves.
std::vector<Move> withoutLongArcs(const Vec3& start, std::vector<Move> moves) {
    std::vector<Move> halved;
    Vec3 from = start;
    for (Move& move : moves) {
        const Edge edge = edgeOf(from, move);
        if (move.arc && std::abs(sweepAngle(edge.from, edge.to(), *move.arc)) > kLongestArcRad) {
            Move half = move;
            half.to.head<2>() = snapToGrid(pointAt(edge, 0.5));
            half.to.z() = (from.z() + move.to.z()) / 2;
            halved.push_back(half);
        }
        from = move.to;
        halved.push_back(std::move(move));
    }
    return halved;
}

bool isLevelFeed(const Move& move) {
    return move.kind == MoveKind::Feed || move.kind == MoveKind::Slot;
}

class PathFeeds {
  public:
    PathFeeds(Toolpath path, const CutGround& ground, const CuttingModel& model)
        : path_(std::move(path)),
          ground_(ground),
          model_(model),
          followed_(ground, model.facts().diameter_mm / 2, path_.step_down_mm, kCuspShare) {
        path_.moves = withoutLongArcs(path_.start, std::move(path_.moves));
    }

    FedPath make() {
        part();
        CutFollower follower(ground_, model_.facts().diameter_mm / 2, path_.step_down_mm, kCuspShare);
        Vec3 from = path_.start;
        for (std::size_t i = 0; i < path_.moves.size(); ++i) {
            feed(path_.moves[i], cutOf(i, from, follower), from);
            from = path_.moves[i].to;
        }
        finish();
        return {std::move(path_), std::move(loads_), cuts_summary_};
    }

  private:
    /// What a move of the parted path cuts. A whole one is as wide as it was found; how deep it is hangs on
    /// how the line above was parted.
    MoveCut cutOf(std::size_t i, const Vec3& from, CutFollower& follower) const {
        if (!whole_[i]) return follower.next(from, path_.moves[i]);
        MoveCut cut = *whole_[i];
        cut.depth_mm = follower.nextDepth(from, path_.moves[i]).depth_mm;
        return cut;
    }

    /// Parts the moves that cut narrow in one place and wide in another.
    void part() {
        std::vector<Move> parts;
        Vec3 from = path_.start;
        for (const Move& move : path_.moves) {
            const MoveCut cut = followed_.next(from, move);
            const std::size_t before = parts.size();
            if (isLevelFeed(move) && cut.widths_mm != nullptr && !move.in_air)
                addParts(move, cut, from, parts);
            else
                parts.push_back(move);
            const bool stays = parts.size() == before + 1;
            whole_.resize(parts.size(), stays ? std::optional(cut) : std::nullopt);
            from = move.to;
        }
        path_.moves = std::move(parts);
    }

    void addParts(const Move& move, const MoveCut& cut, const Vec3& from, std::vector<Move>& parts) const {
        const Edge edge = edgeOf(from, move);
        const std::vector<double>& widths = *cut.widths_mm;
        std::vector<double> feeds;
        for (std::size_t i = 1; i < widths.size(); ++i)
            feeds.push_back(feedOf(move, std::max(widths[i - 1], widths[i]), cut.depth_mm));
        const std::vector<double> ends = toolpath::feedPieces(feeds, stepMm(), length(edge));
        double begin = 0;
        for (const double end : ends) {
            const std::optional<Edge> piece = end < 1 ? cutOut(edge, begin, end) : std::nullopt;
            if (!piece) continue;  // the rest goes to the move's end
            Move part = move;
            part.to.head<2>() = piece->to();
            parts.push_back(part);
            begin = end;
        }
        parts.push_back(move);
    }

    /// Never more than the kind's own feed but where that is the cutting feed: thin cuts go faster.
    double feedOf(const Move& move, double width_mm, double depth_mm) const {
        const double by_cut = model_.feedFor(bandOf(width_mm, model_.facts()), depth_mm).feed_mm_per_min;
        return move.kind == MoveKind::Feed ? by_cut : std::min(by_cut, path_.feedOf(move.kind));
    }

    void feed(Move& move, const MoveCut& cut, const Vec3& from) {
        loads_.emplace_back();
        if (move.kind == MoveKind::Rapid) return;
        const Edge edge = edgeOf(from, move);
        const double length_mm = std::hypot(length(edge), move.to.z() - from.z());
        if (move.kind != MoveKind::Plunge && !isGlide(move))
            move.feed_mm_per_min = feedOf(move, cut.widest_mm, cut.depth_mm);
        if (move.kind == MoveKind::Ramp && from.z() > move.to.z())
            move.feed_mm_per_min = std::min(
                move.feed_mm_per_min,
                toolpath::sinkingFeed(path_.plunge_feed_mm_per_min, length_mm, from.z() - move.to.z()));
        const double time_s = length_mm / path_.feedOf(move) * kSecondsPerMinute;
        time_s_ += time_s;
        length_mm_ += length_mm;
        count(move, cut, length_mm, time_s);
    }

    void count(const Move& move, const MoveCut& cut, double length_mm, double time_s) {
        const double feed = path_.feedOf(move);
        const double diameter_mm = model_.facts().diameter_mm;
        if (cut.widest_mm <= kAirShare * diameter_mm || cut.depth_mm <= 0) {
            cuts_summary_.length_shares[0] += length_mm;
            return;
        }
        const double peak_kw = model_.powerKw(cut.widest_mm, cut.depth_mm, feed);
        loads_.back() = {static_cast<float>(cut.widest_mm / diameter_mm), static_cast<float>(peak_kw)};
        cuts_summary_.peak_kw = std::max(cuts_summary_.peak_kw, peak_kw);
        cuts_summary_.deflection_mm =
            std::max(cuts_summary_.deflection_mm, model_.deflectionMm(cut.widest_mm, cut.depth_mm, feed));
        const LimitedFeed limited = model_.feedFor(bandOf(cut.widest_mm, model_.facts()), cut.depth_mm);
        rules_s_[limited.feed_mm_per_min > feed ? FeedLimit::ToolFeed : limited.limit] += time_s;
        if (cut.widths_mm == nullptr) return countWidth(cut.widest_mm, cut, length_mm, time_s, feed);
        const std::vector<double>& widths = *cut.widths_mm;
        double counted = 0;
        for (std::size_t i = 1; i < widths.size(); ++i) {
            const double step = i + 1 < widths.size() ? stepMm() / length_mm : 1 - counted;
            countWidth((widths[i - 1] + widths[i]) / 2, cut, step * length_mm, step * time_s, feed);
            counted += step;
        }
    }

    /// How far apart widths are asked.
    double stepMm() const { return kCutStepShare * model_.facts().diameter_mm / 2; }

    void countWidth(double width_mm, const MoveCut& cut, double length_mm, double time_s, double feed) {
        const double share = width_mm / model_.facts().diameter_mm;
        const int quarter = share <= kAirShare ? 0 : std::min(4, static_cast<int>(std::ceil(4 * share)));
        cuts_summary_.length_shares[static_cast<std::size_t>(quarter)] += length_mm;
        work_ += model_.powerKw(width_mm, cut.depth_mm, feed) * time_s;
    }

    void finish() {
        for (double& share : cuts_summary_.length_shares)
            share = length_mm_ > 0 ? share / length_mm_ : 0;
        cuts_summary_.mean_kw = time_s_ > 0 ? work_ / time_s_ : 0;
        double longest_s = 0;
        for (const auto& [limit, rules_s] : rules_s_)
            if (rules_s > longest_s) {
                longest_s = rules_s;
                cuts_summary_.limit = limit;
            }
    }

    Toolpath path_;
    const CutGround& ground_;
    const CuttingModel& model_;
    CutFollower followed_;  ///< holds the widths that whole_ points to
    /// Of the parted path's moves, what those cut that are whole.
    std::vector<std::optional<MoveCut>> whole_;
    std::vector<MoveLoad> loads_;
    CutSummary cuts_summary_;
    std::map<FeedLimit, double> rules_s_;
    double work_ = 0;  ///< kW s
    double time_s_ = 0;
    double length_mm_ = 0;
};

}  // namespace

FedPath withCutFeeds(Toolpath path, const CutGround& ground, const CuttingModel& model) {
    return PathFeeds(std::move(path), ground, model).make();
}

}  // namespace stepmill
