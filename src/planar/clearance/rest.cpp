// The ground that is left to a smaller disc after a larger one.

#include "planar/clearance/boundary_drawer.h"
#include "planar/clearance/outline.h"

namespace stepmill::clearance {

namespace {

/// Where a coarse disc leaves the wall the centres left form a tip of no width. It is cut where it is this
/// wide, so that rounding does not cross its sides [mm].
constexpr double kTipMm = 10 * kGridMm;
constexpr int kHalvings = 50;

/// One turn along a loop's boundary: where a run of either level begins or ends.
struct Mark {
    Place place;
    bool coarse = false;
    bool begins = false;
    int run = 0;
};

/// Walls left between the runs of the fine level and those of the coarse one, and where to go at their ends.
class LeftWalls {
  public:
    LeftWalls(const Profile& profile, const Level& coarse, const Level& fine)
        : profile_(profile), coarse_(coarse), fine_(fine), drawer_(profile, fine.distance) {}

    std::optional<Region> draw();

  private:
    /// A stretch of wall between the tips at which the coarse discs leave it.
    struct Wall {
        Place from;
        Place to;
    };
    bool sortMarks();
    bool drawFrom(std::size_t first);
    void drawBack(const Place& from, const Place& to, LoopDrawer& loop) const;
    /// Nothing where the wall is thinner than a tip all along.
    std::optional<Wall> wallFrom(std::size_t at) const;
    /// Where from a coarse mark on towards `limit` the disc is a tip's width away; nothing if nowhere.
    std::optional<Place> trimmed(const Place& mark, const Place& limit, bool ahead) const;
    /// Does a come before b on the way to `limit`, which lies after a?
    bool comesFirst(const Place& a, const Place& b, const Place& limit) const;

    const Profile& profile_;
    const Level& coarse_;
    const Level& fine_;
    BoundaryDrawer drawer_;
    std::vector<Mark> marks_;
    std::vector<std::size_t> follower_;     // of each mark, the next one on the same loop
    std::vector<std::size_t> begin_of_[2];  // mark at which a run begins: of the fine level, of the coarse
    std::vector<std::size_t> end_of_[2];
    std::vector<int> before_coarse_;  // coarse run whose end's disc begins this one
    std::vector<bool> drawn_;
    Region region_;
};

/// False where marks do not nest: a wall begins where a fine run begins or a coarse one ends, and ends where
/// a coarse one begins or a fine one ends.
bool LeftWalls::sortMarks() {
    for (const bool coarse : {false, true}) {
        const Level& level = coarse ? coarse_ : fine_;
        begin_of_[coarse].resize(level.runs.size());
        end_of_[coarse].resize(level.runs.size());
        for (std::size_t i = 0; i < level.runs.size(); ++i) {
            if (level.runs[i].whole) continue;
            marks_.push_back({level.runs[i].begin, coarse, true, static_cast<int>(i)});
            marks_.push_back({level.runs[i].end, coarse, false, static_cast<int>(i)});
        }
    }
    std::stable_sort(marks_.begin(), marks_.end(),
                     [](const Mark& a, const Mark& b) { return a.place.before(b.place); });
    const auto loopOf = [&](std::size_t k) { return profile_.sites()[marks_[k].place.site].loop; };
    follower_.resize(marks_.size());
    for (std::size_t first = 0; first < marks_.size();) {
        std::size_t last = first;
        while (last < marks_.size() && loopOf(last) == loopOf(first))
            ++last;
        for (std::size_t k = first; k < last; ++k)
            follower_[k] = k + 1 < last ? k + 1 : first;
        first = last;
    }
    for (std::size_t k = 0; k < marks_.size(); ++k) {
        const Mark& mark = marks_[k];
        const Mark& next = marks_[follower_[k]];
        (mark.begins ? begin_of_ : end_of_)[mark.coarse][static_cast<std::size_t>(mark.run)] = k;
        const bool wall_begins = mark.begins != mark.coarse;
        const bool wall_ends_next = next.begins == next.coarse;
        if (wall_begins != wall_ends_next) return false;
    }
    before_coarse_.assign(coarse_.runs.size(), kNone);
    for (std::size_t i = 0; i < coarse_.runs.size(); ++i)
        if (!coarse_.runs[i].whole)
            before_coarse_[static_cast<std::size_t>(coarse_.runs[i].next)] = static_cast<int>(i);
    return true;
}

std::optional<Place> LeftWalls::trimmed(const Place& mark, const Place& limit, bool ahead) const {
    const std::vector<Site>& sites = profile_.sites();
    const auto gap = [&](int site, double u) {
        const Vec2 centre = contactAt(sites[site], u).centreAt(fine_.distance);
        return (centre - mark.centre).norm() - (coarse_.distance - fine_.distance);
    };
    int site = mark.site;
    double u = mark.u;
    for (bool first = true;; first = false) {
        const bool last = site == limit.site && (!first || (ahead ? u <= limit.u : u >= limit.u));
        const double end = last ? limit.u : ahead ? sites[site].extent : 0;
        // An arc may be away between ends that are not.
        for (const double share : {0.25, 0.5, 0.75, 1.0}) {
            double near = u, far = u + share * (end - u);
            if (gap(site, far) < kTipMm) continue;
            for (int halving = 0; halving < kHalvings; ++halving) {
                const double middle = (near + far) / 2;
                (gap(site, middle) < kTipMm ? near : far) = middle;
            }
            return Place{site, far, kUnbounded, mark.centre};
        }
        if (last) return std::nullopt;
        site = ahead ? sites[site].next : sites[site].previous;
        u = ahead ? 0 : sites[site].extent;
    }
}

bool LeftWalls::comesFirst(const Place& a, const Place& b, const Place& limit) const {
    bool first = true;
    for (int site = a.site;; site = profile_.sites()[site].next, first = false) {
        if (site == b.site && (!first || a.u < b.u)) return true;
        if (site == limit.site && (!first || a.u <= limit.u)) return false;
    }
}

std::optional<LeftWalls::Wall> LeftWalls::wallFrom(std::size_t at) const {
    const Mark& begin = marks_[at];
    const Mark& end = marks_[follower_[at]];
    Wall wall{begin.place, end.place};
    if (begin.coarse) {
        const auto from = trimmed(begin.place, end.place, true);
        if (!from) return std::nullopt;
        wall.from = *from;
    }
    if (end.coarse) {
        const auto to = trimmed(end.place, begin.place, false);
        if (!to) return std::nullopt;
        wall.to = *to;
    }
    if (!comesFirst(wall.from, wall.to, end.place)) return std::nullopt;
    return wall;
}

bool LeftWalls::drawFrom(std::size_t first) {
    LoopDrawer loop;
    std::size_t at = first;
    int thick = 0, thin = 0;
    std::optional<Wall> wall = wallFrom(at);
    if (wall) loop.start(drawer_.pointAt(wall->from));
    do {
        drawn_[at] = true;
        (wall ? thick : thin) += 1;
        const Mark& end = marks_[follower_[at]];
        const int before = end.coarse ? before_coarse_[static_cast<std::size_t>(end.run)] : kNone;
        const int after = end.coarse ? kNone : fine_.runs[static_cast<std::size_t>(end.run)].next;
        const std::size_t next = end.coarse ? end_of_[1][static_cast<std::size_t>(before)]
                                            : begin_of_[0][static_cast<std::size_t>(after)];
        const std::optional<Wall> next_wall = wallFrom(next);
        if (wall && next_wall) {
            drawer_.draw(wall->from, wall->to, loop);
            if (end.coarse) drawBack(wall->to, next_wall->from, loop);
            loop.lineTo(drawer_.pointAt(next_wall->from), kNone);
        }
        at = next;
        wall = next_wall;
        if (at != first && drawn_[at]) return false;
    } while (at != first);
    if (thick > 0 && thin > 0) return false;
    if (thick > 0) loop.closeInto(region_);
    return true;
}

/// Back along the coarse disc between two walls.
void LeftWalls::drawBack(const Place& from, const Place& to, LoopDrawer& loop) const {
    const Vec2 centre = snapToGrid(Vec2((from.centre + to.centre) / 2));
    const Arc arc{centre, coarse_.distance - fine_.distance, false};
    const Vec2 out = drawer_.pointAt(from) - centre, in = drawer_.pointAt(to) - centre;
    loop.lineTo(centre + arc.radius_mm * out.normalized(), kNone);
    loop.arcTo(centre + arc.radius_mm * in.normalized(), arc, -turnRad(out, in), kNone);
}

std::optional<Region> LeftWalls::draw() {
    if (!sortMarks()) return std::nullopt;
    drawn_.assign(marks_.size(), false);
    for (std::size_t k = 0; k < marks_.size(); ++k) {
        const bool wall_begins = marks_[k].begins != marks_[k].coarse;
        if (wall_begins && !drawn_[k] && !drawFrom(k)) return std::nullopt;
    }
    // Loops no coarse disc comes near, and those neither level interrupts.
    std::vector<bool> touched(firstSites(profile_).size(), false);
    for (const Mark& mark : marks_)
        touched[static_cast<std::size_t>(profile_.sites()[mark.place.site].loop)] = true;
    for (const Run& run : coarse_.runs)
        touched[static_cast<std::size_t>(run.loop)] = true;
    const std::vector<int> first_sites = firstSites(profile_);
    for (const Run& run : fine_.runs) {
        if (!run.whole || touched[static_cast<std::size_t>(run.loop)]) continue;
        LoopDrawer loop;
        drawer_.drawAll(first_sites[static_cast<std::size_t>(run.loop)], loop);
        loop.closeInto(region_);
    }
    return region_;
}

}  // namespace

std::optional<Region> centresLeft(const Profile& profile, const Level& coarse, const Level& fine) {
    return LeftWalls(profile, coarse, fine).draw();
}

}  // namespace stepmill::clearance
