#include "planar/clearance/level.h"

#include <algorithm>

namespace stepmill::clearance {

namespace {

/// Two walls this close to the disc's diameter, or an arc this close to its radius, are a tie: what rounding
/// to the grid leaves of equality [mm].
constexpr double kTieMm = 2 * kGridMm;
/// A level keeps this distance from the clearances of all vertices [mm].
constexpr double kMarginMm = 1e-9;
/// Steps tried before a level between two vertices is given up.
constexpr int kMostSteps = 1000;
/// Where ends and beginnings do not pair, beside vertices that rounding has moved, a clearance a little
/// larger is tried: ten of them, up to 0.1 um [mm].
constexpr double kFirstAsideMm = 5e-9;
constexpr int kAttempts = 10;
/// Ends and beginnings farther apart than both do not belong together: a length [mm], and the angle by which
/// rounding turns the ends of short edges, over the clearance [rad].
constexpr double kPairMm = 0.1;
constexpr double kPairRad = 3e-3;

/// Has a vertex of the diagram this clearance?
bool onVertex(const Profile& profile, double distance) {
    for (int i = 0; i < static_cast<int>(profile.sites().size()); ++i) {
        for (const Piece& piece : profile.pieces(i))
            if (std::abs(piece.at_from - distance) < kMarginMm ||
                std::abs(piece.at_to - distance) < kMarginMm)
                return true;
    }
    return false;
}

/// Clearances that are ties with the disc.
struct Ties {
    std::optional<double> neck;     ///< largest of the narrowest places between walls
    std::optional<double> low_arc;  ///< smallest and largest of the concave arcs
    std::optional<double> high_arc;
};

Ties tiesAt(const Profile& profile, double distance) {
    Ties ties;
    const auto close = [&](double clearance) { return std::abs(clearance - distance) <= kTieMm; };
    const std::vector<Site>& sites = profile.sites();
    for (int i = 0; i < static_cast<int>(sites.size()); ++i) {
        Piece before = profile.pieces(sites[i].previous).back();
        for (const Piece& piece : profile.pieces(i)) {
            const double clearance = piece.at_from;
            const bool level = close(piece.at_to) && piece.to - piece.from > kTieMm;
            const bool lowest = before.at_from > before.at_to && piece.at_to > clearance;
            if (close(clearance) && piece.stop == kOwnCentre) {
                ties.low_arc = std::min(ties.low_arc.value_or(clearance), clearance);
                ties.high_arc = std::max(ties.high_arc.value_or(clearance), clearance);
            } else if (close(clearance) && (level || lowest)) {
                ties.neck = std::max(ties.neck.value_or(clearance), clearance);
            }
            before = piece;
        }
    }
    return ties;
}

/// The clearance at which to cut: the distance itself, or just beside it where vertices or ties ask for that.
/// Nothing if no level lies between the vertices.
std::optional<double> cuttingClearance(const Profile& profile, double distance, Tie tie) {
    const Ties ties = tiesAt(profile, distance);
    double cut = distance, step = 2 * kMarginMm;
    if (tie == Tie::Filled && ties.low_arc && !ties.neck) {
        step = -step;
        cut = std::min(cut, *ties.low_arc) + step;
    } else if (ties.neck || ties.high_arc) {
        cut = std::max({cut, ties.neck.value_or(0), ties.high_arc.value_or(0)}) + step;
    }
    for (int k = 0; k < kMostSteps; ++k, cut += step)
        if (!onVertex(profile, cut)) return cut;
    return std::nullopt;
}

/// A place where the boundary comes above the level, or falls below it.
struct Passing {
    Place place;
    bool rises = false;
};

std::vector<Passing> passings(const Profile& profile, double distance, int first_site, int last_site,
                              bool& above) {
    std::vector<Passing> found;
    const auto add = [&](int site, double u, const Piece& piece, bool rises) {
        found.push_back({{site, u, piece.stop, profile.centreAt(site, u, distance)}, rises});
    };
    const Piece last = profile.pieces(last_site - 1).back();
    bool inside = last.at_to > distance;
    for (int site = first_site; site < last_site; ++site) {
        for (const Piece& piece : profile.pieces(site)) {
            const bool starts = piece.at_from > distance, ends = piece.at_to > distance;
            if (starts != inside) add(site, piece.from, piece, starts);
            if (starts != ends) add(site, profile.crossing(site, piece, distance), piece, ends);
            inside = ends;
        }
    }
    above = inside;
    return found;
}

void appendRuns(const Profile& profile, int loop, int first_site, int last_site, Level& level) {
    bool above = false;
    const std::vector<Passing> found = passings(profile, level.cut, first_site, last_site, above);
    if (found.empty()) {
        if (above) level.runs.push_back({loop, true, {}, {}, static_cast<int>(level.runs.size())});
        return;
    }
    // Passings alternate; a run that goes on past the loop's first site ends at its first passing.
    for (std::size_t k = 0; k < found.size(); ++k)
        if (found[k].rises)
            level.runs.push_back({loop, false, found[k].place, found[(k + 1) % found.size()].place, kNone});
}

/// Pairs the end of each run with the beginning at the same disc.
class Pairing {
  public:
    explicit Pairing(Level& level)
        : runs_(level.runs), distance_(level.distance), taken_(level.runs.size(), false) {
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            if (runs_[i].whole) continue;
            by_x_.push_back(i);
        }
        std::sort(by_x_.begin(), by_x_.end(), [&](std::size_t a, std::size_t b) {
            return runs_[a].begin.centre.x() < runs_[b].begin.centre.x();
        });
    }

    void pair() {
        // Those that name each other come first, then whatever lies nearest.
        for (const bool mutual : {true, false})
            for (const double reach : {10 * kGridMm, 2e-4, 2e-3, kPairMm, kPairRad * distance_})
                for (Run& run : runs_)
                    if (!run.whole && run.next == kNone) pairEnd(run, reach, mutual);
    }

    /// Has every end found its beginning?
    bool complete() const {
        return std::none_of(runs_.begin(), runs_.end(), [](const Run& run) { return run.next == kNone; });
    }

  private:
    void pairEnd(Run& run, double reach, bool mutual) {
        const Vec2& at = run.end.centre;
        const auto low =
            std::lower_bound(by_x_.begin(), by_x_.end(), at.x() - reach,
                             [&](std::size_t i, double x) { return runs_[i].begin.centre.x() < x; });
        double best = reach;
        for (auto it = low; it != by_x_.end() && runs_[*it].begin.centre.x() <= at.x() + reach; ++it) {
            const Place& begin = runs_[*it].begin;
            if (taken_[*it]) continue;
            if (mutual && (begin.site != run.end.stop || begin.stop != run.end.site)) continue;
            const double apart = (begin.centre - at).norm();
            if (apart > best) continue;
            best = apart;
            run.next = static_cast<int>(*it);
        }
        if (run.next != kNone) taken_[static_cast<std::size_t>(run.next)] = true;
    }

    std::vector<Run>& runs_;
    double distance_;
    std::vector<bool> taken_;
    std::vector<std::size_t> by_x_;
};

}  // namespace

std::optional<Level> levelAt(const Profile& profile, double distance_mm, Tie tie) {
    const std::vector<Site>& sites = profile.sites();
    const std::optional<double> cut = cuttingClearance(profile, distance_mm, tie);
    if (!cut) return std::nullopt;
    double aside = 0;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        Level level;
        level.distance = distance_mm;
        level.cut = *cut + aside;
        for (int first = 0; first < static_cast<int>(sites.size());) {
            int last = first;
            while (last < static_cast<int>(sites.size()) && sites[last].loop == sites[first].loop)
                ++last;
            appendRuns(profile, sites[first].loop, first, last, level);
            first = last;
        }
        Pairing pairing(level);
        pairing.pair();
        if (pairing.complete()) return level;
        aside = aside == 0 ? kFirstAsideMm : 3 * aside;
    }
    return std::nullopt;
}

}  // namespace stepmill::clearance
