// From crossed faces to the curves they show.

#include "layers/section/section_path.h"

#include <Geom_CylindricalSurface.hxx>

#include "layers/section/section_points.h"
#include "layers/section/tidy_loop.h"
#include "stepmill/core/units.h"

namespace stepmill::layers {

namespace {

/// Where a run begins and ends, on the true edges.
struct Ends {
    Vec2 from;
    Vec2 to;
};

PlaneCurve lineOf(const MeshFace& face, double z_mm) {
    PlaneCurve curve;
    curve.kind = PlaneCurve::Kind::Line;
    const double length = face.normal.head<2>().norm();
    curve.normal = face.normal.head<2>() / length;
    curve.offset = (face.offset_mm - face.normal.z() * z_mm) / length;
    return curve;
}

/// A lying cylinder shows a line on either side of its axis. Which one, the ends on the edges tell; a
/// loop cannot run over this face alone. None so near to its ridge that facets need not show both lines, as
/// theirs is a little lower: there a run passes over the strip between them.
std::optional<PlaneCurve> lineOfLying(const FaceRun& run, const Ends& ends, double z_mm, double near_mm) {
    const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(run.face->surface);
    const gp_Pnt centre = cylinder->Location();
    const double dz = z_mm - centre.Z();
    const double half = std::sqrt(std::max(0.0, cylinder->Radius() * cylinder->Radius() - dz * dz));
    PlaneCurve curve;
    curve.kind = PlaneCurve::Kind::Line;
    curve.normal = Vec2(-run.face->axis.y(), run.face->axis.x());
    const double middle = curve.normal.dot(Vec2(centre.X(), centre.Y()));
    const double side_from = curve.normal.dot(ends.from) - middle;
    const double side_to = curve.normal.dot(ends.to) - middle;
    const bool turns_back =
        side_from * side_to < 0 && std::min(std::abs(side_from), std::abs(side_to)) > 0.5 * half;
    const bool at_ridge = cylinder->Radius() - std::abs(dz) <= near_mm;
    if (turns_back || (at_ridge && ends.from != ends.to)) return std::nullopt;
    const double side = side_from + side_to;
    curve.offset = middle + (side < 0 ? -half : half);
    return curve;
}

/// Where a run passes over such a strip no more than so much of a bore is closed [rad]: no half of one, which
/// has a bar across it.
constexpr double kMostClosedRad = kPi / 2;

/// What closes the loop where a run passes over such a strip. A bore that a lying hole opens there is still
/// round; else the chord will do.
PlaneCurve acrossStrip(const std::optional<PlaneCurve>& before, const std::optional<PlaneCurve>& after,
                       const Ends& ends) {
    const auto isBore = [](const std::optional<PlaneCurve>& curve) {
        return curve && curve->kind == PlaneCurve::Kind::Circle && !curve->arc.ccw;
    };
    if (isBore(before) && isBore(after) && sameCircle(before->arc, after->arc)) {
        PlaneCurve round = *before;
        round.turn = sweepAngle(round.project(ends.from), round.project(ends.to), round.arc);
        if (std::abs(round.turn) <= kMostClosedRad) return round;
    }
    PlaneCurve chord;
    chord.kind = PlaneCurve::Kind::Line;
    chord.normal = leftOf(Vec2((ends.to - ends.from).normalized()));
    chord.offset = chord.normal.dot(ends.from);
    return chord;
}

PlaneCurve circleOf(const FaceRun& run, double z_mm) {
    PlaneCurve curve;
    curve.kind = PlaneCurve::Kind::Circle;
    double distances = 0;
    for (const Crossing& c : run.crossings) {
        const Vec2 a = c.from - run.face->axis;
        const Vec2 b = c.to - run.face->axis;
        curve.turn += turnRad(a, b);
        distances += (a.norm() + b.norm()) / 2;
    }
    const double mean = distances / static_cast<double>(run.crossings.size());
    curve.arc = {run.face->axis, snapToGrid(run.face->radiusAt(z_mm, mean)), curve.turn > 0};
    return curve;
}

/// None for a run that passes over the strip at a lying cylinder's ridge.
std::optional<PlaneCurve> curveOf(const SolidMesh& mesh, const FaceRun& run, const Ends& ends, double z_mm,
                                  const Tolerances& tol) {
    if (run.face->kind == FaceKind::Plane) return lineOf(*run.face, z_mm);
    if (run.face->kind == FaceKind::Turned) return circleOf(run, z_mm);
    if (run.face->kind == FaceKind::Lying) return lineOfLying(run, ends, z_mm, tol.gouge_mm);
    PlaneCurve curve;
    curve.points = pointsOnSurface(mesh, run.crossings, z_mm);
    return curve;
}

}  // namespace

Loop joinRuns(const SolidMesh& mesh, const std::vector<FaceRun>& runs, double z_mm, const Tolerances& tol) {
    if (runs.size() == 1 && runs.front().whole_loop)
        return wholeLoop(curveOf(mesh, runs.front(), {}, z_mm, tol).value(), tol.curve_fit_mm);
    const std::size_t n = runs.size();
    std::vector<Vec2> on_edge;  // point i lies between run i - 1 and run i
    for (const FaceRun& run : runs)
        on_edge.push_back(pointOnEdge(mesh, run.crossings.front().side_in, z_mm));
    const auto endsOf = [&](std::size_t i) { return Ends{on_edge[i], on_edge[(i + 1) % n]}; };
    std::vector<std::optional<PlaneCurve>> known;
    for (std::size_t i = 0; i < n; ++i)
        known.push_back(curveOf(mesh, runs[i], endsOf(i), z_mm, tol));
    std::vector<PlaneCurve> curves;
    for (std::size_t i = 0; i < n; ++i) {
        const std::optional<PlaneCurve>& before = known[(i + n - 1) % n];
        const std::optional<PlaneCurve>& after = known[(i + 1) % n];
        curves.push_back(known[i] ? *known[i] : acrossStrip(before, after, endsOf(i)));
    }
    return joinCurves(curves, on_edge, tol.curve_fit_mm);
}

}  // namespace stepmill::layers
