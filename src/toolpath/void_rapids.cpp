// Rapids at depth over negative islands: where the cutter is fed over holes and windows it cuts nothing.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/indexed_region.h"
#include "stepmill/toolpath/toolpath.h"
#include "toolpath/emit.h"

namespace stepmill {
namespace {

/// A rapid that saves less than this is not worth its two blocks [s].
constexpr double kLeastSavingS = 0.1;

/// Of a way from edge to edge of a void so much may lie on its edges, by rounding [mm].
constexpr double kEndsMm = 1e-3;

/// A place on a path: a share of the length of one of its moves.
struct Place {
    std::size_t move = 0;
    double share = 0;
};

/// A piece of the path: where the cutter meets nothing for a while, and what is between.
struct Run {
    Place begin;
    Place end;

    /// Of a move within it, the shares between which it is the run's.
    std::pair<double, double> sharesOf(std::size_t move) const {
        return {move == begin.move ? begin.share : 0, move == end.move ? end.share : 1};
    }
};

class VoidRapids {
  public:
    /// \param reach  centres from where the cutter, or what it keeps off by, meets something that stands
    VoidRapids(const Toolpath& path, const Region& reach, const Machine& machine)
        : path_(path), machine_(machine), reach_(reach) {
        Vec3 from = path.start;
        for (const Move& move : path.moves) {
            starts_.push_back(from);
            from = move.to;
        }
    }

    /// Nothing where no rapid is worth while.
    std::optional<Toolpath> make() const {
        std::vector<Run> worth;
        for (const Run& run : runs())
            for (const Run& part : straightAcross(run))
                if (saves(part)) worth.push_back(part);
        if (worth.empty()) return std::nullopt;
        Toolpath made = path_;
        made.moves = movesWith(worth);
        return made;
    }

  private:
    Edge edgeOf(std::size_t i) const {
        const Move& move = path_.moves[i];
        return stepmill::edgeOf(starts_[i], move);
    }

    bool isLevelFeed(std::size_t i) const {
        const Move& move = path_.moves[i];
        const bool level = move.kind == MoveKind::Feed || move.kind == MoveKind::Slot;
        return level && !isGlide(move) && starts_[i].z() == move.to.z();
    }

    /// Stretches of an edge that lie over nothing, as shares of its length.
    std::vector<std::pair<double, double>> stretchesOverVoid(const Edge& edge) const {
        const std::vector<double> shares = sharesWhereMet(edge, reach_.boundary());
        std::vector<std::pair<double, double>> stretches;
        for (std::size_t k = 1; k < shares.size(); ++k)
            if (shares[k] > shares[k - 1] && !reach_.contains(pointAt(edge, (shares[k - 1] + shares[k]) / 2)))
                stretches.emplace_back(shares[k - 1], shares[k]);
        return stretches;
    }

    std::vector<Run> runs() const {
        std::vector<Run> runs;
        for (std::size_t i = 0; i < path_.moves.size(); ++i) {
            if (!isLevelFeed(i)) continue;
            for (const auto& [from, to] : stretchesOverVoid(edgeOf(i))) {
                const bool goes_on = !runs.empty() && isSame(runs.back().end, {i, from});
                if (goes_on)
                    runs.back().end = {i, to};
                else
                    runs.push_back({{i, from}, {i, to}});
            }
        }
        return runs;
    }

    static bool isSame(const Place& a, const Place& b) {
        const bool from_move_to_next = b.move == a.move + 1 && a.share == 1 && b.share == 0;
        return from_move_to_next || (b.move == a.move && a.share == b.share);
    }

    Vec2 at(const Place& place) const {
        if (place.share <= 0) return starts_[place.move].head<2>();
        if (place.share >= 1) return path_.moves[place.move].to.head<2>();
        return snapToGrid(pointAt(edgeOf(place.move), place.share));
    }

    /// Does the way stay over the void? Its ends lie on the void's edge, to within rounding.
    bool isOverVoid(const Edge& way) const {
        double over_mm = 0;
        for (const auto& [from, to] : stretchesOverVoid(way))
            over_mm += (to - from) * length(way);
        return over_mm >= length(way) - kEndsMm;
    }

    /// The run as one straight way where that stays over the void, else its straight moves.
    std::vector<Run> straightAcross(const Run& run) const {
        if (isOverVoid(makeLine(at(run.begin), at(run.end)))) return {run};
        std::vector<Run> parts;
        for (std::size_t i = run.begin.move; i <= run.end.move; ++i) {
            const auto [from, to] = run.sharesOf(i);
            if (!path_.moves[i].arc) parts.push_back({{i, from}, {i, to}});
        }
        return parts;
    }

    bool saves(const Run& run) const {
        double fed_s = 0;
        for (std::size_t i = run.begin.move; i <= run.end.move; ++i) {
            const auto [from, to] = run.sharesOf(i);
            fed_s += (to - from) * length(edgeOf(i)) / path_.feedOf(path_.moves[i]) * kSecondsPerMinute;
        }
        const double across_mm = (at(run.end) - at(run.begin)).norm();
        return fed_s - across_mm / machine_.rapid_mm_per_min * kSecondsPerMinute >= kLeastSavingS;
    }

    std::vector<Move> movesWith(const std::vector<Run>& runs) const {
        std::vector<Move> moves;
        Place done;
        for (const Run& run : runs) {
            add({done, run.begin}, moves);
            const Vec2 to = at(run.end);
            moves.push_back({MoveKind::Rapid, Vec3(to.x(), to.y(), starts_[run.end.move].z()), std::nullopt});
            done = run.end;
        }
        add({done, {path_.moves.size(), 0}}, moves);
        return moves;
    }

    void add(const Run& piece, std::vector<Move>& moves) const {
        for (std::size_t i = piece.begin.move; i < path_.moves.size() && i <= piece.end.move; ++i) {
            const auto [from, to] = piece.sharesOf(i);
            if (from >= to) continue;
            Move part = path_.moves[i];
            if (to < 1) part.to.head<2>() = at({i, to});
            moves.push_back(part);
        }
    }

    const Toolpath& path_;
    const Machine& machine_;
    IndexedRegion reach_;
    std::vector<Vec3> starts_;  ///< of the moves
};

}  // namespace

Toolpath withRapidsOverVoids(const Toolpath& path, const ClearingTask& task, double tool_radius_mm,
                             const Machine& machine, const Tolerances& tol) {
    if (path.moves.empty()) return path;
    const double keep_mm =
        std::max({toolpath::kApproachMm, machine.inside_clearance_mm, machine.side_clearance_mm});
    const Region stands = unite(std::vector<Region>{task.target, task.obstruction, task.skirt}, tol);
    std::optional<Toolpath> made =
        VoidRapids(path, offset(stands, tool_radius_mm + keep_mm, tol), machine).make();
    if (!made) return path;
    made->totals = measure(*made, machine);
    return made->totals.motion_time_s < path.totals.motion_time_s ? *std::move(made) : path;
}

}  // namespace stepmill
