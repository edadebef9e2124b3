// Faces seen from above.

#include "layers/faces/face_outline.h"

#include <algorithm>
#include <map>

#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>

#include "layers/faces/face_surface.h"
#include "layers/section/plane_curve.h"
#include "layers/section/tidy_loop.h"
#include "stepmill/core/units.h"

namespace stepmill::layers {

namespace {

/// A side of the face's boundary in the sense of its triangle: material counter-clockwise seen from outside.
struct RimSide {
    int from = -1;  ///< nodes
    int to = -1;
    int edge = -1;
    double t_from = 0;
    double t_to = 0;
};

/// Sides that only one triangle of the face has; a seam has two.
std::vector<RimSide> rimOf(const SolidMesh& mesh, int face) {
    std::map<int, int> uses;
    for (const int t : mesh.trianglesOfFace()[face])
        for (const int side : mesh.triangles()[t].side)
            ++uses[side];
    std::vector<RimSide> rim;
    for (const int t : mesh.trianglesOfFace()[face]) {
        const MeshTriangle& triangle = mesh.triangles()[t];
        for (int k = 0; k < 3; ++k) {
            const MeshSide& side = mesh.sides()[triangle.side[k]];
            if (uses[triangle.side[k]] != 1 || side.a == side.b) continue;
            RimSide out{triangle.node[k], triangle.node[(k + 1) % 3], side.edge, side.t_a, side.t_b};
            if (out.from != side.a) std::swap(out.t_from, out.t_to);
            rim.push_back(out);
        }
    }
    return rim;
}

/// Closed chains; nothing where a chain stays open.
std::vector<std::vector<RimSide>> chained(const std::vector<RimSide>& rim) {
    std::multimap<int, int> by_start;
    for (std::size_t i = 0; i < rim.size(); ++i)
        by_start.emplace(rim[i].from, static_cast<int>(i));
    std::vector<std::vector<RimSide>> chains;
    while (!by_start.empty()) {
        std::vector<RimSide> chain;
        for (auto next = by_start.begin(); next != by_start.end();) {
            chain.push_back(rim[next->second]);
            by_start.erase(next);
            next = by_start.find(chain.back().to);
        }
        if (chain.back().to != chain.front().from) return {};
        chains.push_back(std::move(chain));
    }
    return chains;
}

Vec2 nodeFromAbove(const SolidMesh& mesh, int node) {
    return mesh.nodes()[node].head<2>();
}

PlaneCurve lineThrough(const Vec2& from, const Vec2& to) {
    PlaneCurve curve;
    curve.kind = PlaneCurve::Kind::Line;
    const Vec2 along = (to - from).normalized();
    curve.normal = leftOf(along);
    curve.offset = curve.normal.dot(from);
    return curve;
}

/// Sides on one edge, seen from above.
PlaneCurve curveOfEdge(const SolidMesh& mesh, const std::vector<RimSide>& sides) {
    const Vec2 from = nodeFromAbove(mesh, sides.front().from);
    const Vec2 to = nodeFromAbove(mesh, sides.back().to);
    const int edge = sides.front().edge;
    Handle(Geom_Curve) curve = edge >= 0 ? mesh.curve(edge) : Handle(Geom_Curve)();
    if (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve); !trimmed.IsNull())
        curve = trimmed->BasisCurve();
    if (curve.IsNull() || !Handle(Geom_Line)::DownCast(curve).IsNull()) return lineThrough(from, to);
    PlaneCurve out;
    if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull()) {
        const gp_Dir axis = circle->Axis().Direction();
        if (std::hypot(axis.X(), axis.Y()) < 1e-6) {
            const double turn = sides.back().t_to - sides.front().t_from;
            const gp_Pnt centre = circle->Location();
            out.kind = PlaneCurve::Kind::Circle;
            out.turn = axis.Z() > 0 ? turn : -turn;
            out.arc = {snapToGrid(Vec2(centre.X(), centre.Y())), snapToGrid(circle->Radius()), out.turn > 0};
            return out;
        }
    }
    constexpr int kPiecesPerSide = 4;
    out.points.push_back(from);
    for (const RimSide& side : sides)
        for (int i = 1; i <= kPiecesPerSide; ++i) {
            const gp_Pnt p = curve->Value(side.t_from + (side.t_to - side.t_from) * i / kPiecesPerSide);
            if ((Vec2(p.X(), p.Y()) - out.points.back()).norm() > 1e-5) out.points.emplace_back(p.X(), p.Y());
        }
    return out;
}

Loop loopOf(const SolidMesh& mesh, const std::vector<RimSide>& chain, double tolerance_mm) {
    std::size_t first = 0;
    const std::size_t n = chain.size();
    // An edge's parameter jumps where a closed edge begins again.
    const auto goesOn = [&](const RimSide& a, const RimSide& b) {
        return a.edge == b.edge && a.edge >= 0 && a.t_to == b.t_from;
    };
    while (first < n && goesOn(chain[(first + n - 1) % n], chain[first]))
        ++first;
    std::vector<std::vector<RimSide>> runs;
    for (std::size_t k = 0; k < n; ++k) {
        const RimSide& side = chain[(first + k) % n];
        if (runs.empty() || !goesOn(runs.back().back(), side)) runs.emplace_back();
        runs.back().push_back(side);
    }
    if (runs.size() == 1) return wholeLoop(curveOfEdge(mesh, runs.front()), tolerance_mm);
    std::vector<PlaneCurve> curves;
    std::vector<Vec2> joints;
    for (const std::vector<RimSide>& run : runs) {
        curves.push_back(curveOfEdge(mesh, run));
        joints.push_back(nodeFromAbove(mesh, run.front().from));
    }
    return joinCurves(curves, joints, tolerance_mm);
}

struct Range {
    double low = 1e300;
    double high = -1e300;
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

Path footprintOfPlane(const SolidMesh& mesh, int index) {
    const MeshFace& face = mesh.faces()[index];
    const Vec2 normal = face.normal.head<2>().normalized();
    const Vec2 along(-normal.y(), normal.x());
    Range reach;
    for (const RimSide& side : rimOf(mesh, index)) {
        reach.add(along.dot(nodeFromAbove(mesh, side.from)));
        if (side.edge >= 0)
            widenByCurve(*mesh.curve(side.edge), Vec3(along.x(), along.y(), 0), side.t_from, side.t_to,
                         reach.low, reach.high);
    }
    const Vec2 foot = normal * (face.offset_mm / face.normal.head<2>().norm());
    return Path{snapToGrid(Vec2(foot + reach.low * along)),
                {{snapToGrid(Vec2(foot + reach.high * along)), std::nullopt}}};
}

/// Which surface parameter runs along the plane: the one whose curves do not rise.
bool uRunsLevel(const MeshFace& face, const gp_Pnt2d& at) {
    gp_Pnt p;
    gp_Vec du;
    gp_Vec dv;
    face.surface->D1(at.X(), at.Y(), p, du, dv);
    return std::abs(du.Z()) * dv.Magnitude() <= std::abs(dv.Z()) * du.Magnitude();
}

Path footprintOfCurved(const SolidMesh& mesh, int index, double tolerance_mm) {
    const MeshFace& face = mesh.faces()[index];
    const gp_Pnt2d at = mesh.triangles()[mesh.trianglesOfFace()[index].front()].uv[0];
    const bool level_u = uRunsLevel(face, at);
    Range range;
    for (const int t : mesh.trianglesOfFace()[index])
        for (const gp_Pnt2d& uv : mesh.triangles()[t].uv)
            range.add(level_u ? uv.X() : uv.Y());
    const auto pointAt = [&](double t) {
        const gp_Pnt p = level_u ? face.surface->Value(t, at.Y()) : face.surface->Value(at.X(), t);
        return Vec2(p.X(), p.Y());
    };
    // Material lies on the left of the travel if the outward normal lies on its right.
    const double middle = (range.low + range.high) / 2;
    const double step = 1e-3 * (range.high - range.low);
    const Vec2 travel = pointAt(middle + step) - pointAt(middle);
    const Vec3 normal = normalAt(face, level_u ? gp_Pnt2d(middle, at.Y()) : gp_Pnt2d(at.X(), middle));
    const bool forward = travel.y() * normal.x() - travel.x() * normal.y() > 0;
    const double from = forward ? range.low : range.high;
    const double to = forward ? range.high : range.low;
    PlaneCurve curve;
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(face.surface); !cylinder.IsNull()) {
        curve.kind = PlaneCurve::Kind::Circle;
        const bool ccw = (face.reversed ? -1 : 1) > 0;
        curve.turn = (ccw ? 1 : -1) * (range.high - range.low);
        curve.arc = {face.axis, snapToGrid(cylinder->Radius()), ccw};
        if (range.high - range.low > 2 * kPi - 1e-6) return wholeLoop(curve, tolerance_mm);
    } else {
        constexpr int kPieces = 256;
        for (int i = 0; i <= kPieces; ++i)
            curve.points.push_back(pointAt(from + (to - from) * i / kPieces));
        if ((curve.points.front() - curve.points.back()).norm() < 1e-6) return wholeLoop(curve, tolerance_mm);
    }
    return openPath(curve, pointAt(from), pointAt(to), tolerance_mm);
}

}  // namespace

Region outlineFromAbove(const SolidMesh& mesh, int face, const Tolerances& tol) {
    Region region;
    for (const std::vector<RimSide>& chain : chained(rimOf(mesh, face))) {
        Loop loop = loopOf(mesh, chain, tol.curve_fit_mm);
        if (loop.segments.empty()) continue;
        region.loops.push_back(mesh.faces()[face].greatest_normal_z > 1e-6
                                   ? std::move(loop)
                                   : tidyLoop(reversed(loop).segments));
    }
    sortLoops(region);
    return diagnose(region) ? Region{} : region;
}

Path footprintOf(const SolidMesh& mesh, int face, const Tolerances& tol) {
    return mesh.faces()[face].kind == FaceKind::Plane ? footprintOfPlane(mesh, face)
                                                      : footprintOfCurved(mesh, face, tol.curve_fit_mm);
}

}  // namespace stepmill::layers
