#include "part/step/elementary_surface.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Ax3.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS.hxx>

#include <Eigen/SVD>

#include "part/face_sample.h"
#include "part/occt_values.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// Per direction; on a grid of one span's width no spline of the degrees in use bulges unseen.
constexpr int kFewestAcrossFace = 9;
constexpr int kAcrossSpan = 5;
constexpr int kMostAcrossFace = 65;

/// Radii beyond this are planes or noise [mm].
constexpr double kLargestRadius_mm = 1e5;

using SurfacePoints = std::vector<FaceSample>;

gp_Pnt point(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

gp_Dir direction(const Vec3& d) {
    return {d.x(), d.y(), d.z()};
}

/// A direction whose rounding is gone where it lies along an axis.
Vec3 tidied(Vec3 axis) {
    constexpr double kRounding = 1e-10;
    for (int i = 0; i < 3; ++i)
        if (std::abs(axis[i]) < kRounding) axis[i] = 0;
    return axis.normalized();
}

int samplesAlong(int spans) {
    return std::clamp(kAcrossSpan * spans, kFewestAcrossFace, kMostAcrossFace);
}

/// A grid over a face's parameters, its rim included, with the normals of the surface, whichever of its sides
/// the face shows.
struct FaceGrid {
    SurfacePoints points;
    std::optional<Vec3> pole;  ///< a point without a normal
};

/// \param across, along  points in either direction of the parameters
FaceGrid gridOn(const TopoDS_Face& face, int across, int along) {
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    const BRepAdaptor_Surface surface(face);
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    FaceGrid grid;
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < along; ++j) {
            const FaceSample sample = sampleAt(forward, surface, u0 + (u1 - u0) * i / (across - 1),
                                               v0 + (v1 - v0) * j / (along - 1));
            if (sample.normal.isZero())
                grid.pole = sample.at;
            else
                grid.points.push_back(sample);
        }
    return grid;
}

/// So fine that no span of the surface can bulge unseen.
FaceGrid fineGridOn(const TopoDS_Face& face) {
    const BRepAdaptor_Surface surface(face);
    return gridOn(face, samplesAlong(surface.NbUIntervals(GeomAbs_CN)),
                  samplesAlong(surface.NbVIntervals(GeomAbs_CN)));
}

/// Solves rows * x = values in the sense of least squares.
/// \param rowsOf  fills in the rows and values that a point gives
template <int kUnknowns, int kRowsEach, typename RowsOf>
Eigen::Matrix<double, kUnknowns, 1> leastSquares(const SurfacePoints& points, const RowsOf& rowsOf) {
    const auto count = static_cast<Eigen::Index>(points.size());
    Eigen::Matrix<double, Eigen::Dynamic, kUnknowns> rows(count * kRowsEach, kUnknowns);
    Eigen::VectorXd values(count * kRowsEach);
    for (Eigen::Index i = 0; i < count; ++i) {
        Eigen::Matrix<double, kRowsEach, kUnknowns> own_rows;
        Eigen::Matrix<double, kRowsEach, 1> own_values;
        rowsOf(points[static_cast<std::size_t>(i)], own_rows, own_values);
        rows.template middleRows<kRowsEach>(i * kRowsEach) = own_rows;
        values.template segment<kRowsEach>(i * kRowsEach) = own_values;
    }
    return rows.colPivHouseholderQr().solve(values);
}

/// The direction that rows of three have least to do with.
Vec3 leastDirection(const Eigen::Matrix<double, Eigen::Dynamic, 3>& rows) {
    const Eigen::Matrix3d squares = rows.transpose() * rows;
    return tidied(squares.jacobiSvd(Eigen::ComputeFullU).matrixU().col(2));
}

Eigen::Matrix<double, Eigen::Dynamic, 3> normalsOf(const SurfacePoints& points) {
    Eigen::Matrix<double, Eigen::Dynamic, 3> normals(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        normals.row(static_cast<Eigen::Index>(i)) = points[i].normal;
    return normals;
}

/// The frame whose seam passes through the first point, where the drawn surface has its own.
gp_Ax3 frame(const Vec3& origin, const Vec3& axis, const SurfacePoints& points) {
    const Vec3 out = points.front().at - origin;
    const Vec3 across = out - out.dot(axis) * axis;
    constexpr double kOnAxis_mm = 1e-6;
    if (across.norm() < kOnAxis_mm) return {point(origin), direction(axis)};
    return {point(origin), direction(axis), direction(tidied(across.normalized()))};
}

Handle(Geom_ElementarySurface) planeThrough(const FaceGrid& grid) {
    const SurfacePoints& points = grid.points;
    Vec3 normal = Vec3::Zero();
    for (const FaceSample& p : points)
        normal += p.normal;
    if (normal.norm() < 0.5 * static_cast<double>(points.size())) return {};
    normal = tidied(normal.normalized());
    double offset = 0;
    for (const FaceSample& p : points)
        offset += normal.dot(p.at) / static_cast<double>(points.size());
    const Vec3 first = points.front().at;
    return new Geom_Plane(point(first + (offset - normal.dot(first)) * normal), direction(normal));
}

Handle(Geom_ElementarySurface) cylinderThrough(const FaceGrid& grid) {
    const SurfacePoints& points = grid.points;
    const Vec3 axis = leastDirection(normalsOf(points));
    const auto flat = [&](const Vec3& v) { return Vec3(v - v.dot(axis) * axis); };
    const Eigen::Vector4d fit =
        leastSquares<4, 3>(points, [&](const FaceSample& p, auto& rows, auto& values) {
            rows << Eigen::Matrix3d::Identity(), flat(p.normal);
            values = flat(p.at);
        });
    const double radius = std::abs(fit[3]);
    if (!(radius > 0 && radius < kLargestRadius_mm)) return {};
    const Vec3 first = points.front().at;
    const Vec3 origin = fit.head<3>() + first.dot(axis) * axis;
    return new Geom_CylindricalSurface(frame(origin, axis, points), radius);
}

Handle(Geom_ElementarySurface) coneThrough(const FaceGrid& grid) {
    const SurfacePoints& points = grid.points;
    Eigen::Matrix<double, Eigen::Dynamic, 3> normals = normalsOf(points);
    normals.rowwise() -= normals.colwise().mean().eval();
    Vec3 axis = leastDirection(normals);
    const Vec3 apex = leastSquares<3, 1>(points, [](const FaceSample& p, auto& rows, auto& values) {
        rows = p.normal.transpose();
        values[0] = p.normal.dot(p.at);
    });
    const Vec3 first = points.front().at - apex;
    if (first.dot(axis) < 0) axis = -axis;
    const double height = first.dot(axis);
    const double radius = (first - height * axis).norm();
    if (!(height > 0 && radius > 0 && radius < kLargestRadius_mm)) return {};
    const double half_angle = std::atan2(radius, height);
    constexpr double kFlat_rad = 1e-3;
    if (half_angle < kFlat_rad || half_angle > kPi / 2 - kFlat_rad) return {};
    return new Geom_ConicalSurface(frame(apex + height * axis, axis, points), half_angle, radius);
}

/// Its poles are where the face's own surface has one, else away from the face: a loop around a pole is none.
Handle(Geom_ElementarySurface) sphereThrough(const FaceGrid& grid) {
    const SurfacePoints& points = grid.points;
    const Eigen::Vector4d fit = leastSquares<4, 3>(points, [](const FaceSample& p, auto& rows, auto& values) {
        rows << Eigen::Matrix3d::Identity(), p.normal;
        values = p.at;
    });
    const double radius = std::abs(fit[3]);
    if (!(radius > 0 && radius < kLargestRadius_mm)) return {};
    const Vec3 centre = fit.head<3>();
    Vec3 axis = Vec3::Zero();
    if (grid.pole) {
        axis = tidied((*grid.pole - centre).normalized());
    } else {
        Vec3 middle = Vec3::Zero();
        for (const FaceSample& p : points)
            middle += p.normal;
        axis = tidied(middle.unitOrthogonal());
    }
    return new Geom_SphericalSurface(frame(centre, axis, points), radius);
}

/// All normals of what is turned about an axis meet the axis: with Pluecker's coordinates (direction d,
/// moment m) of a normal and (a, b) of the axis, a.m + b.d = 0.
Handle(Geom_ElementarySurface) torusThrough(const FaceGrid& grid) {
    const SurfacePoints& points = grid.points;
    Eigen::Matrix<double, Eigen::Dynamic, 6> lines(static_cast<Eigen::Index>(points.size()), 6);
    for (std::size_t i = 0; i < points.size(); ++i) {
        // Near the points, so that moments are no larger than the face.
        const Vec3 moment = (points[i].at - points.front().at).cross(points[i].normal);
        lines.row(static_cast<Eigen::Index>(i)) << moment.transpose(), points[i].normal.transpose();
    }
    const Eigen::Matrix<double, 6, 6> squares = lines.transpose() * lines;
    const Eigen::Matrix<double, 6, 1> line = squares.jacobiSvd(Eigen::ComputeFullU).matrixU().col(5);
    const Vec3 along = line.head<3>();
    constexpr double kNoAxis = 1e-9;
    if (along.norm() < kNoAxis) return {};
    const Vec3 axis = tidied(along.normalized());
    const Vec3 on_axis = points.front().at + along.cross(line.tail<3>()) / along.squaredNorm();
    // In the half plane of radius and height the profile is a circle.
    const Eigen::Vector3d fit =
        leastSquares<3, 2>(points, [&](const FaceSample& p, auto& rows, auto& values) {
            const Vec3 from = p.at - on_axis;
            const Vec3 across = from - from.dot(axis) * axis;
            const Vec3 out = across.normalized();
            rows << 1, 0, p.normal.dot(out), 0, 1, p.normal.dot(axis);
            values << across.norm(), from.dot(axis);
        });
    const double major = fit[0];
    const double minor = std::abs(fit[2]);
    if (!(major > 0 && minor > 0 && major < kLargestRadius_mm && minor < kLargestRadius_mm)) return {};
    return new Geom_ToroidalSurface(frame(on_axis + fit[1] * axis, axis, points), major, minor);
}

/// Do all points lie on the surface, with its normals or, all of them, with the opposite ones?
std::optional<ElementarySurface> fitted(const Handle(Geom_ElementarySurface) & surface,
                                        const SurfacePoints& points) {
    if (surface.IsNull()) return std::nullopt;
    int same = 0;
    int opposite = 0;
    ShapeAnalysis_Surface analysis(surface);
    for (const FaceSample& p : points) {
        const gp_Pnt2d uv = analysis.ValueOfUV(point(p.at), Precision::Confusion());
        gp_Pnt at;
        gp_Vec du, dv;
        surface->D1(uv.X(), uv.Y(), at, du, dv);
        if ((toVec3(at) - p.at).norm() > kSameForm_mm) return std::nullopt;
        const gp_Vec normal = du.Crossed(dv);
        if (normal.Magnitude() < gp::Resolution()) continue;
        const Vec3 own = Vec3(normal.X(), normal.Y(), normal.Z()).normalized();
        if (own.cross(p.normal).norm() > kSameForm_rad) return std::nullopt;
        ++(own.dot(p.normal) > 0 ? same : opposite);
    }
    if (same > 0 && opposite > 0) return std::nullopt;
    return ElementarySurface{surface, opposite > 0};
}

bool isElementary(const TopoDS_Face& face) {
    switch (BRepAdaptor_Surface(face, Standard_False).GetType()) {
        case GeomAbs_Plane:
        case GeomAbs_Cylinder:
        case GeomAbs_Cone:
        case GeomAbs_Sphere:
        case GeomAbs_Torus:
            return true;
        default:
            return false;
    }
}

}  // namespace

std::optional<ElementarySurface> elementarySurface(const TopoDS_Face& face) {
    if (isElementary(face)) return std::nullopt;
    // Free forms, of which a part may have thousands, are ruled out by few points.
    const FaceGrid grid = gridOn(face, kFewestAcrossFace, kFewestAcrossFace);
    if (grid.points.size() < kFewestAcrossFace) return std::nullopt;
    for (const auto through : {planeThrough, cylinderThrough, coneThrough, sphereThrough, torusThrough})
        if (const auto fit = fitted(through(grid), grid.points))
            return fitted(fit->surface, fineGridOn(face).points);
    return std::nullopt;
}

}  // namespace stepmill
