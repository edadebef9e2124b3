#include "stepmill/feature/hole.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// Axes closer than this are one [mm]: what is bored in one clamping lies closer, what is not is two holes.
constexpr double kSameAxisMm = 0.01;
constexpr double kSameDirectionRad = 1e-4;
/// Faces of one bore, added up, go all round but for this [rad]: room for keyways and cross holes.
constexpr double kMissingRad = 0.6;
/// Steps farther apart along the axis than this do not open into each other [mm].
constexpr double kGapMm = 0.01;

/// Axes looking to both sides are one: the first component that is not zero is positive.
Vec3 canonical(const Vec3& axis) {
    for (int i = 0; i < 3; ++i)
        if (std::abs(axis[i]) > kSameDirectionRad) return axis[i] < 0 ? Vec3(-axis) : axis;
    return axis;
}

/// A bore or cone between two places along an axis.
struct Stretch {
    bool cone = false;
    double from = 0;  ///< along the axis, ascending
    double to = 0;
    double radius_from = 0;
    double radius_to = 0;
    double angle_rad = 0;
    std::vector<int> faces;

    double radiusAt(bool upper) const { return upper ? radius_to : radius_from; }
};

/// Everything hollow and round about one axis, and the bosses that stand about it.
struct AxisLine {
    Vec3 point;
    Vec3 axis;
    std::vector<Stretch> stretches;
    std::vector<Stretch> bosses;
};

bool isRoundWall(const FaceShape& face) {
    return face.surface == "cylinder" || face.surface == "cone";
}

bool sameLine(const AxisLine& line, const FaceShape& face) {
    if (line.axis.cross(face.axis).norm() > kSameDirectionRad) return false;
    const Vec3 between = face.origin - line.point;
    return (between - between.dot(line.axis) * line.axis).norm() <= kSameAxisMm;
}

double along(const AxisLine& line, const Vec3& p) {
    return line.axis.dot(p - line.point);
}

Stretch stretchOf(const AxisLine& line, const FaceShape& face) {
    Stretch stretch;
    stretch.from = 1e300;
    stretch.to = -1e300;
    for (const Vec3& p : face.outline) {
        stretch.from = std::min(stretch.from, along(line, p));
        stretch.to = std::max(stretch.to, along(line, p));
    }
    stretch.angle_rad = face.angle_rad;
    stretch.faces = {face.index};
    stretch.cone = face.surface == "cone";
    if (!stretch.cone) {
        stretch.radius_from = stretch.radius_to = face.radius_mm;
        return stretch;
    }
    const double apex = along(line, face.origin);
    const double slope = std::tan(face.half_angle_rad);
    // A cone that runs to its apex has no outline there.
    if (face.pointed) (apex < stretch.from ? stretch.from : stretch.to) = apex;
    stretch.radius_from = std::abs(stretch.from - apex) * slope;
    stretch.radius_to = std::abs(stretch.to - apex) * slope;
    return stretch;
}

/// Halves of one bore become one stretch.
void addStretch(std::vector<Stretch>& all, const Stretch& added) {
    for (Stretch& known : all) {
        const bool same = known.cone == added.cone &&
                          std::abs(known.radius_from - added.radius_from) <= kSameAxisMm &&
                          std::abs(known.radius_to - added.radius_to) <= kSameAxisMm;
        const bool overlap = added.from <= known.to + kGapMm && added.to >= known.from - kGapMm;
        if (!same || !overlap) continue;
        known.from = std::min(known.from, added.from);
        known.to = std::max(known.to, added.to);
        known.angle_rad += added.angle_rad;
        known.faces.insert(known.faces.end(), added.faces.begin(), added.faces.end());
        return;
    }
    all.push_back(added);
}

/// Does a boss stand in it? The outer wall of a ring groove is no bore.
bool isRing(const Stretch& wall, const std::vector<Stretch>& bosses) {
    return std::any_of(bosses.begin(), bosses.end(), [&](const Stretch& boss) {
        const bool beside = boss.from < wall.to - kGapMm && boss.to > wall.from + kGapMm;
        return beside && std::max(boss.radius_from, boss.radius_to) <
                             std::min(wall.radius_from, wall.radius_to) + kSameAxisMm;
    });
}

std::vector<AxisLine> axisLines(const FaceGraph& graph) {
    std::vector<AxisLine> lines;
    for (const FaceShape& face : graph.faces) {
        if (!isRoundWall(face)) continue;
        auto line = std::find_if(lines.begin(), lines.end(),
                                 [&](const AxisLine& known) { return sameLine(known, face); });
        if (line == lines.end()) {
            lines.push_back({face.origin, canonical(face.axis), {}, {}});
            line = lines.end() - 1;
        }
        addStretch(face.hollow ? line->stretches : line->bosses, stretchOf(*line, face));
    }
    for (AxisLine& line : lines) {
        std::erase_if(line.stretches, [&](const Stretch& stretch) {
            return stretch.angle_rad < 2 * kPi - kMissingRad || isRing(stretch, line.bosses);
        });
        std::sort(line.stretches.begin(), line.stretches.end(),
                  [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
    }
    return lines;
}

/// Runs of stretches without a gap between them.
std::vector<std::vector<Stretch>> stacks(const std::vector<Stretch>& stretches) {
    std::vector<std::vector<Stretch>> runs;
    for (const Stretch& stretch : stretches) {
        if (runs.empty() || stretch.from > runs.back().back().to + kGapMm)
            runs.push_back({stretch});
        else
            runs.back().push_back(stretch);
    }
    return runs;
}

/// Is the end of a stack closed, by a flat floor across the axis or by a point?
class EndFinder {
  public:
    explicit EndFinder(const FaceGraph& graph) : graph_(graph) {}

    bool closed(const AxisLine& line, const std::vector<Stretch>& stack, bool upper) const {
        const Stretch& end = upper ? stack.back() : stack.front();
        if (end.radiusAt(upper) <= kSameAxisMm) return true;
        const double at = upper ? end.to : end.from;
        for (const FaceEdge& edge : graph_.edges) {
            const bool first = contains(end.faces, edge.first);
            if (first == contains(end.faces, edge.second)) continue;
            const int other = first ? edge.second : edge.first;
            const bool here = std::abs(along(line, edge.from) - at) <= kGapMm &&
                              std::abs(along(line, edge.to) - at) <= kGapMm;
            // Inner edges and fillets run into a floor; a floor looks back along the axis.
            if (here && edge.bend != Bend::Convex && looksBack(line, graph_.faces[other], upper)) return true;
        }
        return false;
    }

  private:
    static bool contains(const std::vector<int>& faces, int face) {
        return std::find(faces.begin(), faces.end(), face) != faces.end();
    }
    static bool looksBack(const AxisLine& line, const FaceShape& face, bool upper) {
        constexpr double kAcross = 0.1;
        return std::any_of(face.samples.begin(), face.samples.end(), [&](const FaceSample& sample) {
            return sample.normal.dot(line.axis) * (upper ? -1 : 1) > kAcross;
        });
    }
    const FaceGraph& graph_;
};

HoleStep stepOf(const Stretch& stretch, double entry, bool entry_above, bool last) {
    HoleStep step;
    const double r0 = stretch.radiusAt(entry_above);
    const double r1 = stretch.radiusAt(!entry_above);
    step.diameter_mm = 2 * std::max(r0, r1);
    step.end_diameter_mm = 2 * r1;
    step.top_mm = std::abs(entry - (entry_above ? stretch.to : stretch.from));
    step.bottom_mm = std::abs(entry - (entry_above ? stretch.from : stretch.to));
    if (stretch.cone) step.kind = last && r1 <= kSameAxisMm ? HoleStep::Kind::Point : HoleStep::Kind::Cone;
    step.faces = stretch.faces;
    std::sort(step.faces.begin(), step.faces.end());
    return step;
}

HoleKind kindOf(const std::vector<HoleStep>& steps) {
    const HoleStep& first = steps.front();
    if (first.kind == HoleStep::Kind::Cone && first.diameter_mm >= kCountersinkShare * first.end_diameter_mm)
        return HoleKind::Countersunk;
    for (std::size_t i = 1; i < steps.size(); ++i)
        if (steps[i].kind == HoleStep::Kind::Bore && steps[i].diameter_mm < first.diameter_mm - kSameAxisMm &&
            first.kind == HoleStep::Kind::Bore)
            return HoleKind::Counterbored;
    return HoleKind::Plain;
}

Hole holeOf(const AxisLine& line, const std::vector<Stretch>& stack, const EndFinder& ends) {
    Hole hole;
    const bool closed_below = ends.closed(line, stack, false);
    const bool closed_above = ends.closed(line, stack, true);
    hole.through = !closed_below && !closed_above;
    // The entry is the open end, of two the wider one.
    const bool entry_above = closed_above   ? false
                             : closed_below ? true
                                            : stack.back().radius_to >= stack.front().radius_from;
    const double entry = entry_above ? stack.back().to : stack.front().from;
    hole.axis = entry_above ? line.axis : Vec3(-line.axis);
    hole.entry = line.point + entry * line.axis;
    std::vector<Stretch> down = stack;
    if (entry_above) std::reverse(down.begin(), down.end());
    for (const Stretch& stretch : down) {
        hole.steps.push_back(stepOf(stretch, entry, entry_above, &stretch == &down.back()));
        hole.faces.insert(hole.faces.end(), stretch.faces.begin(), stretch.faces.end());
    }
    std::sort(hole.faces.begin(), hole.faces.end());
    hole.kind = kindOf(hole.steps);
    hole.drill_point = !hole.through && hole.steps.back().kind == HoleStep::Kind::Point;
    return hole;
}

}  // namespace

double Hole::diameter_mm() const {
    STEPMILL_CHECK(!steps.empty(), "a hole has steps");
    double least = 1e300;
    for (const HoleStep& step : steps)
        if (step.kind == HoleStep::Kind::Bore) least = std::min(least, step.diameter_mm);
    return least < 1e300 ? least : steps.front().diameter_mm;
}

std::string holeName(const Hole& hole) {
    const std::string ends = hole.through ? "through hole" : "blind hole";
    switch (hole.kind) {
        case HoleKind::Plain:
            return ends;
        case HoleKind::Counterbored:
            return "counterbored " + ends;
        case HoleKind::Countersunk:
            return "countersunk " + ends;
    }
    throw Error(ErrorCode::Internal, "hole kind", "unknown value");
}

std::vector<Hole> findHoles(const FaceGraph& graph, const Tolerances& tol) {
    const EndFinder ends(graph);
    std::vector<Hole> holes;
    for (const AxisLine& line : axisLines(graph)) {
        for (const std::vector<Stretch>& stack : stacks(line.stretches)) {
            const bool bored =
                std::any_of(stack.begin(), stack.end(), [](const Stretch& stretch) { return !stretch.cone; });
            const double height = stack.back().to - stack.front().from;
            if (bored && height > tol.sliver_mm) holes.push_back(holeOf(line, stack, ends));
        }
    }
    std::sort(holes.begin(), holes.end(),
              [](const Hole& a, const Hole& b) { return a.faces.front() < b.faces.front(); });
    for (std::size_t i = 0; i < holes.size(); ++i)
        holes[i].id = "H" + std::to_string(i + 1);
    return holes;
}

}  // namespace stepmill
