#include "drawing/chain.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "drawing/spline_points.h"
#include "stepmill/drawing/drawing.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::drawing {
namespace {

/// Ends no farther apart are the same point to the geometry kernel: nothing to heal [mm].
constexpr double kSamePointMm = 1e-7;

/// One end of a stroke.
struct End {
    std::size_t stroke = 0;
    bool at_start = true;
};

void turn(Stroke& stroke) {
    std::swap(stroke.from, stroke.to);
    stroke.bulge = -stroke.bulge;
    if (!stroke.spline) return;
    auto spline = std::make_shared<Spline>(*stroke.spline);
    std::reverse(spline->poles.begin(), spline->poles.end());
    std::reverse(spline->weights.begin(), spline->weights.end());
    const double sum = spline->knots.front() + spline->knots.back();
    std::reverse(spline->knots.begin(), spline->knots.end());
    for (double& knot : spline->knots)
        knot = sum - knot;
    stroke.spline = std::move(spline);
}

/// Which ends lie within a gap of each other, by the cells of a grid of that width.
class EndGrid {
  public:
    explicit EndGrid(const std::vector<Stroke>& strokes) : strokes_(strokes) {
        for (std::size_t i = 0; i < strokes.size(); ++i)
            if (!strokes[i].isCircle())
                for (const bool at_start : {true, false})
                    cells_[cellOf(at({i, at_start}))].push_back({i, at_start});
    }

    const Vec2& at(const End& end) const {
        return end.at_start ? strokes_[end.stroke].from : strokes_[end.stroke].to;
    }

    /// The ends of other strokes near this one, and the other end of its own stroke where that is near.
    std::vector<End> near(const End& end) const {
        std::vector<End> found;
        const auto [column, row] = cellOf(at(end));
        for (long x = column - 1; x <= column + 1; ++x)
            for (long y = row - 1; y <= row + 1; ++y)
                if (const auto cell = cells_.find({x, y}); cell != cells_.end())
                    for (const End& other : cell->second) {
                        const bool itself = other.stroke == end.stroke && other.at_start == end.at_start;
                        if (!itself && (at(other) - at(end)).norm() <= kHealedGapMm) found.push_back(other);
                    }
        return found;
    }

  private:
    static std::pair<long, long> cellOf(const Vec2& p) {
        return {std::lround(std::floor(p.x() / kHealedGapMm)), std::lround(std::floor(p.y() / kHealedGapMm))};
    }

    const std::vector<Stroke>& strokes_;
    std::map<std::pair<long, long>, std::vector<End>> cells_;
};

/// Joins strokes by their ends.
class Joiner {
  public:
    Joiner(std::vector<Stroke> strokes, const std::string& file, Healing& healing)
        : strokes_(std::move(strokes)), file_(file), healing_(healing) {}

    std::vector<Profile> join() {
        const EndGrid grid(strokes_);
        std::vector<bool> used(strokes_.size(), false);
        std::vector<Profile> profiles;
        for (std::size_t i = 0; i < strokes_.size(); ++i) {
            if (used[i]) continue;
            used[i] = true;
            Profile profile;
            profile.strokes.push_back(strokes_[i]);
            if (!strokes_[i].isCircle()) follow(grid, i, used, profile.strokes);
            finish(profile);
            profiles.push_back(std::move(profile));
        }
        return profiles;
    }

  private:
    std::string where(const Vec2& p, const Stroke& stroke) const {
        return fmt::format("layer '{}', {}, at ({:.4f}, {:.4f}) mm", stroke.layer, stroke.place, p.x(),
                           p.y());
    }

    /// From the first stroke's end on until its start is reached.
    void follow(const EndGrid& grid, std::size_t first, std::vector<bool>& used, std::vector<Stroke>& chain) {
        End end{first, false};
        for (;;) {
            const End next = onlyNear(grid, end);
            if (next.stroke == first) return;
            used[next.stroke] = true;
            chain.push_back(strokes_[next.stroke]);
            if (!next.at_start) turn(chain.back());
            end = {next.stroke, !next.at_start};
        }
    }

    End onlyNear(const EndGrid& grid, const End& end) const {
        const std::vector<End> near = grid.near(end);
        const Stroke& stroke = strokes_[end.stroke];
        if (near.empty())
            refuse(file_, where(grid.at(end), stroke),
                   fmt::format("expected a closed profile, found an open end with no other within {:g} mm",
                               kHealedGapMm));
        if (near.size() > 1)
            refuse(
                file_, where(grid.at(end), stroke),
                fmt::format("expected two ends to meet, found {}: a line drawn twice, or profiles that touch",
                            near.size() + 1));
        return near.front();
    }

    void finish(Profile& profile) {
        heal(profile.strokes);
        profile.shape = shapeOf(profile.strokes);
        if (profile.strokes.front().isCircle() || signedArea(profile.shape) > 0) return;
        std::reverse(profile.strokes.begin(), profile.strokes.end());
        for (Stroke& stroke : profile.strokes)
            turn(stroke);
        profile.shape = shapeOf(profile.strokes);
    }

    /// A line reaches for the end of an arc or curve; of two lines and of two arcs the later one does.
    void heal(std::vector<Stroke>& chain) {
        if (chain.front().isCircle()) return;
        const std::size_t count = chain.size();
        for (std::size_t i = 0; i < count; ++i) {
            Stroke& before = chain[i];
            Stroke& after = chain[(i + 1) % count];
            const double gap_mm = (after.from - before.to).norm();
            if (gap_mm > kSamePointMm) {
                ++healing_.gaps;
                healing_.widest_mm = std::max(healing_.widest_mm, gap_mm);
            }
            // A spline's end stays; what it is the end of is told by its poles.
            if (after.spline || (before.isLine() && !after.isLine()))
                moveEnd(before, after.from);
            else
                after.from = before.to;
        }
    }

    void moveEnd(Stroke& stroke, const Vec2& to) const {
        if (!stroke.spline) {
            stroke.to = to;
            return;
        }
        // Between two splines the first one's last pole goes along.
        auto spline = std::make_shared<Spline>(*stroke.spline);
        spline->poles.back() = to;
        stroke.spline = std::move(spline);
        stroke.to = to;
    }

    static Loop shapeOf(const std::vector<Stroke>& strokes) {
        if (strokes.front().isCircle())
            return makeCircle(snapToGrid(strokes.front().from), snapToGrid(strokes.front().circle_radius))
                .loops.front();
        Loop loop;
        loop.start = snapToGrid(strokes.front().from);
        Vec2 at = loop.start;
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            const Stroke& stroke = strokes[i];
            const Vec2 to = i + 1 == strokes.size() ? loop.start : snapToGrid(stroke.to);
            if (stroke.spline)
                for (const Vec2& p : splinePoints(*stroke.spline))
                    addLine(loop, at, snapToGrid(p));
            if (stroke.bulge == 0)
                addLine(loop, at, to);
            else if (at != to) {
                const Arc arc = arcOf(stroke);
                loop.segments.push_back(
                    {to, Arc{snapToGrid(arc.centre), snapToGrid(arc.radius_mm), arc.ccw}});
                at = to;
            }
        }
        return loop;
    }

    static void addLine(Loop& loop, Vec2& at, const Vec2& to) {
        if (at != to) loop.segments.push_back({to, std::nullopt});
        at = to;
    }

    std::vector<Stroke> strokes_;
    const std::string& file_;
    Healing& healing_;
};

}  // namespace

Arc arcOf(const Stroke& stroke) {
    const Vec2 chord = stroke.to - stroke.from;
    // The centre lies off the chord's middle by (1 - b^2) / 4b of the chord, to its left for b > 0.
    const double off = (1 - stroke.bulge * stroke.bulge) / (4 * stroke.bulge);
    Arc arc;
    arc.centre = (stroke.from + stroke.to) / 2 + off * leftOf(chord);
    arc.radius_mm = chord.norm() * (1 + stroke.bulge * stroke.bulge) / (4 * std::abs(stroke.bulge));
    arc.ccw = stroke.bulge > 0;
    return arc;
}

std::vector<Profile> closedProfiles(std::vector<Stroke> strokes, const std::string& file, Healing& healing) {
    std::vector<Profile> profiles;
    guardOcct(ErrorCode::InvalidCatalog, file + ", splines",
              [&] { profiles = Joiner(std::move(strokes), file, healing).join(); });
    return profiles;
}

}  // namespace stepmill::drawing
