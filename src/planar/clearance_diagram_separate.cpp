#include "planar/clearance_diagram_sites.h"

#include "stepmill/core/error.h"

namespace stepmill::clearance {

namespace {

__extension__ typedef __int128 Wide;

constexpr int kMaxRounds = 40;
constexpr double kMinSplitUnits = 16;

struct Conflict {
    std::size_t a, b;
};

int orientation(std::int32_t ax, std::int32_t ay, std::int32_t bx, std::int32_t by, std::int32_t px,
                std::int32_t py) {
    const auto d = [](std::int32_t u, std::int32_t v) {
        return static_cast<std::int64_t>(u) - static_cast<std::int64_t>(v);
    };
    const Wide det = static_cast<Wide>(d(bx, ax)) * d(py, ay) - static_cast<Wide>(d(by, ay)) * d(px, ax);
    return det > 0 ? 1 : det < 0 ? -1 : 0;
}

bool inBox(const Chord& c, std::int32_t x, std::int32_t y) {
    return std::min(c.x0, c.x1) <= x && x <= std::max(c.x0, c.x1) && std::min(c.y0, c.y1) <= y &&
           y <= std::max(c.y0, c.y1);
}

/// Is the point on the chord, but not one of its ends?
bool insideChord(const Chord& c, std::int32_t x, std::int32_t y) {
    if ((x == c.x0 && y == c.y0) || (x == c.x1 && y == c.y1)) return false;
    return inBox(c, x, y) && orientation(c.x0, c.y0, c.x1, c.y1, x, y) == 0;
}

bool sameEnds(const Chord& a, const Chord& b) {
    return (a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1) ||
           (a.x0 == b.x1 && a.y0 == b.y1 && a.x1 == b.x0 && a.y1 == b.y0);
}

/// Do they cross, each in its interior?
bool cross(const Chord& a, const Chord& b) {
    return orientation(a.x0, a.y0, a.x1, a.y1, b.x0, b.y0) * orientation(a.x0, a.y0, a.x1, a.y1, b.x1, b.y1) <
               0 &&
           orientation(b.x0, b.y0, b.x1, b.y1, a.x0, a.y0) * orientation(b.x0, b.y0, b.x1, b.y1, a.x1, a.y1) <
               0;
}

bool meet(const Chord& a, const Chord& b) {
    return insideChord(a, b.x0, b.y0) || insideChord(a, b.x1, b.y1) || insideChord(b, a.x0, a.y0) ||
           insideChord(b, a.x1, a.y1) || sameEnds(a, b) || cross(a, b);
}

/// All pairs that meet elsewhere than at common ends: a sweep over the chords sorted by their left ends.
std::vector<Conflict> findConflicts(const std::vector<Chord>& chords) {
    std::vector<std::size_t> order(chords.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        order[k] = k;
    const auto left = [&](std::size_t k) { return std::min(chords[k].x0, chords[k].x1); };
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return left(a) != left(b) ? left(a) < left(b) : a < b; });
    std::vector<Conflict> found;
    std::vector<std::size_t> open;
    for (std::size_t k : order) {
        const Chord& c = chords[k];
        const std::int32_t ymin = std::min(c.y0, c.y1), ymax = std::max(c.y0, c.y1), x = left(k);
        std::size_t kept = 0;
        for (std::size_t j : open) {
            const Chord& o = chords[j];
            if (std::max(o.x0, o.x1) < x) continue;
            open[kept++] = j;
            if (std::max(o.y0, o.y1) < ymin || std::min(o.y0, o.y1) > ymax) continue;
            if (meet(o, c)) found.push_back({j, k});
        }
        open.resize(kept);
        open.push_back(k);
    }
    return found;
}

using SplitPoint = std::pair<std::int32_t, std::int32_t>;

double units(const Chord& c) {
    return std::hypot(static_cast<double>(c.x1) - c.x0, static_cast<double>(c.y1) - c.y0);
}

SplitPoint midPoint(const SiteSet& set, const Chord& c) {
    const Site& site = set.sites[static_cast<std::size_t>(c.site)];
    const Vec2 middle =
        set.toMm((static_cast<double>(c.x0) + c.x1) / 2, (static_cast<double>(c.y0) + c.y1) / 2);
    const Vec2 on_arc = site.centre + site.radius * (middle - site.centre).normalized();
    const Vec2 grid = (on_arc - set.origin) / set.unit_mm;
    return {static_cast<std::int32_t>(std::lround(grid.x())),
            static_cast<std::int32_t>(std::lround(grid.y()))};
}

SplitPoint crossing(const Chord& a, const Chord& b) {
    const double ux = static_cast<double>(a.x1) - a.x0, uy = static_cast<double>(a.y1) - a.y0;
    const double vx = static_cast<double>(b.x1) - b.x0, vy = static_cast<double>(b.y1) - b.y0;
    const double wx = static_cast<double>(b.x0) - a.x0, wy = static_cast<double>(b.y0) - a.y0;
    const double t = (wx * vy - wy * vx) / (ux * vy - uy * vx);
    return {static_cast<std::int32_t>(std::lround(a.x0 + t * ux)),
            static_cast<std::int32_t>(std::lround(a.y0 + t * uy))};
}

class Splitter {
  public:
    explicit Splitter(SiteSet& set) : set_(set), points_(set.chords.size()) {}

    void resolve(const Conflict& conflict) {
        const Chord a = set_.chords[conflict.a], b = set_.chords[conflict.b];
        if (sameEnds(a, b)) {
            const bool split = splitArc(conflict.a) | splitArc(conflict.b);
            if (!split) doubled_.push_back(conflict);
            return;
        }
        bool touched = false;
        const auto touch = [&](std::size_t chord, std::int32_t x, std::int32_t y) {
            if (!insideChord(set_.chords[chord], x, y)) return;
            points_[chord].push_back({x, y});
            touched = true;
        };
        touch(conflict.a, b.x0, b.y0);
        touch(conflict.a, b.x1, b.y1);
        touch(conflict.b, a.x0, a.y0);
        touch(conflict.b, a.x1, a.y1);
        if (touched) return;
        const bool split = splitArc(conflict.a) | splitArc(conflict.b);
        if (split) return;
        const SplitPoint p = crossing(a, b);
        points_[conflict.a].push_back(p);
        points_[conflict.b].push_back(p);
    }

    void apply();

  private:
    /// A chord that stands for an arc comes closer to it when split.
    bool splitArc(std::size_t chord) {
        const Chord& c = set_.chords[chord];
        if (set_.sites[static_cast<std::size_t>(c.site)].kind != SiteKind::Arc || units(c) < kMinSplitUnits)
            return false;
        points_[chord].push_back(midPoint(set_, c));
        return true;
    }

    SiteSet& set_;
    std::vector<std::vector<SplitPoint>> points_;
    std::vector<Conflict> doubled_;
};

void Splitter::apply() {
    // Two chords of a few nanometres on top of each other bound nothing: drop both.
    for (const Conflict& pair : doubled_) {
        set_.chords[pair.a].site = -1;
        set_.chords[pair.b].site = -1;
    }
    std::vector<Chord> result;
    for (std::size_t k = 0; k < set_.chords.size(); ++k) {
        const Chord c = set_.chords[k];
        if (c.site < 0) continue;
        std::vector<SplitPoint>& cuts = points_[k];
        const double ux = static_cast<double>(c.x1) - c.x0, uy = static_cast<double>(c.y1) - c.y0;
        const auto along = [&](const SplitPoint& p) {
            return (static_cast<double>(p.first) - c.x0) * ux + (static_cast<double>(p.second) - c.y0) * uy;
        };
        std::sort(cuts.begin(), cuts.end(),
                  [&](const SplitPoint& a, const SplitPoint& b) { return along(a) < along(b); });
        Chord rest = c;
        for (const SplitPoint& p : cuts) {
            if ((p.first == rest.x0 && p.second == rest.y0) || (p.first == c.x1 && p.second == c.y1))
                continue;
            Chord head = rest;
            head.x1 = p.first;
            head.y1 = p.second;
            head.end_site = c.site;
            rest.x0 = p.first;
            rest.y0 = p.second;
            rest.start_site = c.site;
            result.push_back(head);
        }
        result.push_back(rest);
    }
    set_.chords = std::move(result);
}

}  // namespace

void separateChords(SiteSet& set) {
    for (int round = 0; round < kMaxRounds; ++round) {
        const std::vector<Conflict> conflicts = findConflicts(set.chords);
        if (conflicts.empty()) return;
        Splitter splitter(set);
        for (const Conflict& c : conflicts)
            splitter.resolve(c);
        splitter.apply();
    }
    throw Error(ErrorCode::GeometryKernel, "clearance diagram",
                "boundary edges cross and cannot be separated on the nanometre grid");
}

}  // namespace stepmill::clearance
