// How low form cutters may go, along ways over the ground.

#include "stepmill/access/form_floor.h"

#include <algorithm>
#include <cmath>

#include "stepmill/access/collision.h"
#include "stepmill/feature/heights.h"

namespace stepmill {
namespace {

/// Which bands are near is found for stretches of a way no longer than so many radii.
constexpr double kStretchRadii = 0.5;

std::vector<IndexedRegion> indexed(const std::vector<Obstacle>& obstacles) {
    std::vector<IndexedRegion> sections;
    sections.reserve(obstacles.size());
    for (const Obstacle& obstacle : obstacles)
        sections.emplace_back(obstacle.section);
    return sections;
}

}  // namespace

/// What counts over a stretch.
struct FormFloor::Stretch {
    double lowest_mm = 0;
    std::vector<std::size_t> near;  ///< bands whose boundary is, from above
};

FormFloor::FormFloor(const FormGround& ground, const ToolAssembly& tool, const Tolerances& tol,
                     const Deadline& deadline)
    : ground_(ground),
      tool_(tool),
      form_(tool),
      guard_mm_(tol.guard_mm),
      deadline_(deadline),
      bands_(indexed(ground.must_stand)),
      obstacles_(indexed(ground.obstacles)) {}

std::vector<double> FormFloor::over(const std::vector<Vec2>& way) const {
    deadline_.check(ground_.id);
    std::vector<double> lowest_mm;
    std::vector<WalkInside> along = walks();
    std::vector<WalkInside> within = along;
    const double most_mm = kStretchRadii * form_.fullRadiusMm();
    for (std::size_t first = 0; first + 1 < way.size();) {
        std::size_t last = first + 1;
        while (last + 1 < way.size() && (way[last + 1] - way[first]).norm() <= most_mm)
            ++last;
        const Stretch stretch = stretchOver(makeLine(way[first], way[last]), along);
        for (; first < last; ++first)
            lowest_mm.push_back(lowestOver(makeLine(way[first], way[first + 1]), stretch, within));
    }
    return lowest_mm;
}

std::vector<WalkInside> FormFloor::walks() const {
    std::vector<WalkInside> walks;
    walks.reserve(bands_.size());
    for (const IndexedRegion& band : bands_)
        walks.emplace_back(band);
    return walks;
}

FormFloor::Stretch FormFloor::stretchOver(const Edge& stretch, std::vector<WalkInside>& walks) const {
    const std::vector<Obstacle>& bands = ground_.must_stand;
    Stretch found{bands.front().bottom_z_mm, {}};
    for (std::size_t i = bands.size(); i-- > 0;) {
        if (bands_[i].boundary().empty()) continue;
        if (bands_[i].boundary().anyNearer(stretch, form_.fullRadiusMm() + guard_mm_)) {
            found.near.push_back(i);
        } else if (walks[i].isInside(stretch)) {
            found.lowest_mm = bands[i].top_z_mm;
            break;
        }
    }
    found.lowest_mm = holderOver(stretch, found.lowest_mm);
    return found;
}

double FormFloor::lowestOver(const Edge& piece, const Stretch& stretch,
                             std::vector<WalkInside>& walks) const {
    double tip_mm = stretch.lowest_mm;
    for (const std::size_t i : stretch.near) {
        const double top_mm = ground_.must_stand[i].top_z_mm;
        if (top_mm <= tip_mm + kSameHeightMm) break;
        const double limit_mm = form_.radiusAt(top_mm - tip_mm) + guard_mm_;
        const double distance_mm = bands_[i].boundary().distanceTo(piece, limit_mm);
        if (distance_mm <= 0 || walks[i].isInside(piece))
            tip_mm = top_mm;
        else if (distance_mm < limit_mm)
            tip_mm = std::max(tip_mm, top_mm - form_.heightUnder(distance_mm - guard_mm_));
    }
    return tip_mm;
}

/// The height or, where shank or holder would meet something there, the lowest above it where they do not.
double FormFloor::holderOver(const Edge& stretch, double tip_mm) const {
    const std::vector<Obstacle>& obstacles = ground_.obstacles;
    for (const HolderCylinder& cylinder : access::cylindersOf(tool_))
        while (const auto over =
                   access::obstacleAbove(obstacles, tip_mm + cylinder.bottom_mm, kSameHeightMm)) {
            const IndexedRegion& section = obstacles_[*over];
            if (!section.isNear(stretch, cylinder.diameter_mm / 2 + guard_mm_)) break;
            tip_mm = obstacles[*over].top_z_mm - cylinder.bottom_mm;
        }
    return tip_mm;
}

std::vector<Vec2> equalPieces(const Vec2& from, const Vec2& to, int pieces) {
    std::vector<Vec2> ends;
    ends.reserve(static_cast<std::size_t>(pieces) + 1);
    for (int i = 0; i < pieces; ++i)
        ends.emplace_back(from + i * (to - from) / pieces);
    ends.push_back(to);
    return ends;
}

}  // namespace stepmill
