#include "feature/classify.h"

#include <algorithm>
#include <cmath>

#include "stepmill/feature/hole_group.h"

namespace stepmill::feature {
namespace {

/// Walls of a slot that lie no farther from parallel face each other [rad]: short ones on the grid do.
constexpr double kFacingRad = 1.4e-3;

struct StraightWall {
    Vec2 at;
    Vec2 direction;
};

std::optional<StraightWall> straightWall(const Vec2& from, const Segment& segment) {
    if (segment.arc || segment.to == from) return std::nullopt;
    return StraightWall{from, (segment.to - from).normalized()};
}

/// The wall of a piece that is straight as a whole.
std::optional<StraightWall> straightWall(const Path& path, const Tolerances& tol) {
    if (path.closed()) return std::nullopt;
    const Vec2 chord = path.end() - path.start;
    const bool straight =
        std::all_of(path.segments.begin(), path.segments.end(), [&](const Segment& segment) {
            const Vec2 offset = segment.to - path.start;
            return !segment.arc && std::abs(cross(chord, offset)) <= tol.sliver_mm * chord.norm();
        });
    if (!straight) return std::nullopt;
    return StraightWall{path.start, chord.normalized()};
}

/// Two walls face each other across the target, which is nowhere wider than they are apart.
bool faceEachOther(const StraightWall& a, const StraightWall& b, const Region& target,
                   const Tolerances& tol) {
    const Vec2 inward(-a.direction.y(), a.direction.x());
    const double apart = inward.dot(b.at - a.at);
    if (apart <= 0 || a.direction.dot(b.direction) > -std::cos(kFacingRad)) return false;
    double least = 0;
    double most = 0;
    for (const Loop& loop : target.loops) {
        for (const Vec2& p : tessellate(loop, tol.chord_mm)) {
            least = std::min(least, inward.dot(p - a.at));
            most = std::max(most, inward.dot(p - a.at));
        }
    }
    return least >= -2 * tol.sliver_mm && most <= apart + 2 * tol.sliver_mm;
}

bool isThroughSlot(const std::vector<const BoundaryPiece*>& walls, const Region& target,
                   const Tolerances& tol) {
    if (walls.size() != 2) return false;
    const auto a = straightWall(walls[0]->path, tol);
    const auto b = straightWall(walls[1]->path, tol);
    return a && b && faceEachOther(*a, *b, target, tol);
}

bool isBlindSlot(const std::vector<const BoundaryPiece*>& walls, const Region& target,
                 const Tolerances& tol) {
    if (walls.size() != 1 || walls[0]->path.segments.size() < 2) return false;
    const Path& wall = walls[0]->path;
    const auto first = straightWall(wall.start, wall.segments.front());
    const auto last = straightWall(wall.segments[wall.segments.size() - 2].to, wall.segments.back());
    return first && last && faceEachOther(*first, *last, target, tol);
}

}  // namespace

FeatureClass classify(const Region& target, const std::vector<BoundaryPiece>& boundary, bool through,
                      const Tolerances& tol) {
    std::vector<const BoundaryPiece*> walls;
    for (const BoundaryPiece& piece : boundary)
        if (!piece.open) walls.push_back(&piece);
    if (walls.empty()) return FeatureClass::Face;
    if (walls.size() == boundary.size()) {
        if (isFullCircles(target)) return through ? FeatureClass::HoleThrough : FeatureClass::HoleBlind;
        return through ? FeatureClass::ThroughPocket : FeatureClass::ClosedPocket;
    }
    if (through) return FeatureClass::OpenProfile;
    if (target.loops.size() != 1) return FeatureClass::OpenPocket;
    if (walls.size() == 1 && straightWall(walls[0]->path, tol)) return FeatureClass::Step;
    if (isThroughSlot(walls, target, tol)) return FeatureClass::SlotThrough;
    if (isBlindSlot(walls, target, tol)) return FeatureClass::SlotBlind;
    return FeatureClass::OpenPocket;
}

}  // namespace stepmill::feature
