// What each tool axis reaches, asked in front of every face: small features count as well as large ones,
// which no grid over the whole stock would give. And in sharp corners, which stay round to a tool along them.

#include "setup/reach_samples.h"

#include <limits>

#include <BRepAdaptor_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "setup/ray_tree.h"
#include "stepmill/core/parallel.h"
#include "stepmill/part/face_graph.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::setup {

namespace {

/// Places on every face, and further ones shared out by area.
constexpr double kLeastOfFace = 12;
constexpr double kSharedOut = 3000;

/// All sharp corners of the part together count as so much of a face: half a setup, which alone pays for
/// none, and more than the side that is best held.
constexpr double kCornersCount = 0.25;
/// Places in a corner, as shares of its length.
constexpr std::array kAlongCorner{0.25, 0.5, 0.75};

/// Thinner layers over a face are the stock's own skin, nothing to remove [mm].
constexpr double kOverSurfaceMm = 0.02;

/// How far in front of the face: a share of the free height there, at most of the part's size. Near enough to
/// be inside a groove, far enough to clear the facets of the face itself.
constexpr double kGapShare = 0.25;
constexpr double kSizeShare = 2e-3;

/// Deeper than this many times the gap's width end mills get slim and slow.
constexpr double kDeepRatio = 6;
/// Deeper than this common end mills do not reach at all [mm].
constexpr double kDeepMm = 100;

/// A hollow cylinder that goes round by this much is a gap between its own sides [rad].
constexpr double kGapTurnRad = 2.5;

/// Is an axis parallel to a direction, either way? To a zero vector none is.
bool isAlong(const Vec3& direction, const Vec3& axis) {
    return !direction.isZero() && direction.cross(axis).norm() < kUprightSine;
}

/// How wide a hollow round face is to a tool along its axis.
struct RoundGap {
    Vec3 axis = Vec3::Zero();
    double width_mm = std::numeric_limits<double>::infinity();

    double along(const Vec3& tool_axis) const {
        return isAlong(axis, tool_axis) ? width_mm : std::numeric_limits<double>::infinity();
    }
};

RoundGap roundGapOf(const TopoDS_Face& face) {
    const BRepAdaptor_Surface surface(face);
    if (surface.GetType() != GeomAbs_Cylinder) return {};
    const double from = surface.FirstUParameter();
    const double to = surface.LastUParameter();
    if (to - from < kGapTurnRad) return {};
    // The normals of a cylinder in a right-handed frame look away from its axis.
    const bool hollow = surface.Cylinder().Direct() == (face.Orientation() == TopAbs_REVERSED);
    if (!hollow) return {};
    const gp_Dir axis = surface.Cylinder().Axis().Direction();
    return {Vec3(axis.X(), axis.Y(), axis.Z()), 2 * surface.Cylinder().Radius()};
}

std::vector<RoundGap> roundGapsOf(const Part& part) {
    std::vector<RoundGap> gaps;
    for (TopExp_Explorer faces(part.shape->solid, TopAbs_FACE); faces.More(); faces.Next())
        gaps.push_back(roundGapOf(TopoDS::Face(faces.Current())));
    return gaps;
}

struct Place {
    Vec3 at;
    Vec3 normal;
    double area_mm2 = 0;  ///< of the face, that it stands for; 0 in a corner
    double of_face = 0;
    bool ruled = false;
    RoundGap round_gap = {};        ///< of its face
    Vec3 corner = Vec3::Zero();     ///< the way along the sharp corner it lies in; zero on a face
    double volume_mm3 = 0;          ///< to be removed in front of it
    std::vector<Reach> reach = {};  ///< by axis; empty where there is nothing to remove
    std::vector<double> depth_mm = {};
};

Vec3 areaVector(const Facet& facet) {
    return (facet[1] - facet[0]).cross(facet[2] - facet[0]) / 2;
}

/// The k-th point of a sequence that fills a triangle evenly from its middle on (additive recurrence,
/// folded). Points on an edge would lie in the plane of the next face, and rays along that would meet it by
/// chance.
Vec3 pointIn(const Facet& facet, int k) {
    constexpr double kMiddle = 1.0 / 3;
    constexpr double kFirst = 0.7548776662466927;
    constexpr double kSecond = 0.5698402909980532;
    double s = std::fmod(kMiddle + kFirst * k, 1.0);
    double t = std::fmod(kMiddle + kSecond * k, 1.0);
    if (s + t > 1) {
        s = 1 - s;
        t = 1 - t;
    }
    return facet[0] + s * (facet[1] - facet[0]) + t * (facet[2] - facet[0]);
}

bool isRuled(const PartFace& face) {
    return face.surface == "plane" || face.surface == "cylinder" || face.surface == "cone";
}

/// Places on the skin of the part, face by face, in the order of the facets.
std::vector<Place> placesOn(const Part& part, const FaceFacets& mesh) {
    std::vector<double> face_mm2(part.faces.size(), 0.0);
    double skin_mm2 = 0;
    for (std::size_t i = 0; i < mesh.facets.size(); ++i) {
        const double facet_mm2 = areaVector(mesh.facets[i]).norm();
        face_mm2[mesh.face[i]] += facet_mm2;
        skin_mm2 += facet_mm2;
    }
    const std::vector<RoundGap> round_gaps = roundGapsOf(part);
    std::vector<Place> places;
    int face = -1;
    double due_mm2 = 0;
    double step_mm2 = 0;
    for (std::size_t i = 0; i < mesh.facets.size(); ++i) {
        if (mesh.face[i] != face) {
            face = mesh.face[i];
            step_mm2 = face_mm2[face] / (kLeastOfFace + kSharedOut * face_mm2[face] / skin_mm2);
            due_mm2 = step_mm2 / 2;
        }
        const Vec3 across = areaVector(mesh.facets[i]);
        if (across.norm() <= 0) continue;
        due_mm2 += across.norm();
        for (int k = 0; due_mm2 >= step_mm2; ++k, due_mm2 -= step_mm2)
            places.push_back({.at = pointIn(mesh.facets[i], k),
                              .normal = across.normalized(),
                              .area_mm2 = step_mm2,
                              .of_face = step_mm2 / face_mm2[face],
                              .ruled = isRuled(part.faces[face]),
                              .round_gap = round_gaps[face]});
    }
    return places;
}

/// Outward, by face; zero where a face is not a plane.
std::vector<Vec3> planeNormals(const Part& part, const FaceFacets& mesh) {
    std::vector<Vec3> normals(part.faces.size(), Vec3::Zero());
    for (std::size_t i = 0; i < mesh.facets.size(); ++i)
        if (part.faces[mesh.face[i]].surface == "plane") normals[mesh.face[i]] += areaVector(mesh.facets[i]);
    for (Vec3& normal : normals)
        normal.normalize();
    return normals;
}

/// Places in the sharp corners between two planes, away from both of them.
std::vector<Place> placesInCorners(const Part& part, const FaceFacets& mesh) {
    const std::vector<Vec3> normals = planeNormals(part, mesh);
    std::vector<Place> places;
    double length_mm = 0;
    for (const FaceEdge& edge : faceEdges(part, Tolerances{})) {
        const Vec3 out = normals[edge.first] + normals[edge.second];
        if (!edge.straight || edge.bend != Bend::Concave || normals[edge.first].isZero() ||
            normals[edge.second].isZero())
            continue;
        length_mm += edge.length_mm;
        for (const double share : kAlongCorner)
            places.push_back({.at = edge.from + share * (edge.to - edge.from),
                              .normal = out.normalized(),
                              .of_face = kCornersCount * edge.length_mm / kAlongCorner.size(),
                              .corner = (edge.to - edge.from).normalized()});
    }
    for (Place& place : places)
        place.of_face /= length_mm;
    return places;
}

/// How far a point inside a box lies from its skin in a direction.
double wayOut(const Box3& box, const Vec3& from, const Vec3& direction) {
    double way = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        if (direction[i] == 0) continue;
        const double side = direction[i] > 0 ? box.max()[i] : box.min()[i];
        way = std::min(way, (side - from[i]) / direction[i]);
    }
    return way;
}

class Sampler {
  public:
    Sampler(const Facets& part, const Stock& stock, const Facets& stock_facets, const std::vector<Vec3>& axes)
        : part_(part), stock_(stock), stock_tree_(stock_facets), axes_(axes) {
        size_mm_ = stock.bbox_mm.diagonal().norm();
    }

    /// Moves the place off the face and finds what reaches it, if there is something to remove.
    void ask(Place& place) const {
        const double to_skin = wayToSkin(place.at, place.normal);
        if (!(to_skin > kOverSurfaceMm) || std::isinf(to_skin)) return;
        const double to_part = part_.distance(place.at + 1e-6 * size_mm_ * place.normal, place.normal);
        place.volume_mm3 = place.area_mm2 * (to_part < to_skin ? to_part / 2 : to_skin);
        const double gap = std::min(kGapShare * std::min(to_part, to_skin), kSizeShare * size_mm_);
        const Vec3 from = place.at + gap * place.normal;
        const double gap_mm = to_part < to_skin ? to_part : std::numeric_limits<double>::infinity();
        for (const Vec3& axis : axes_) {
            const bool blocked = isAlong(place.corner, axis) || part_.blocked(from, axis);
            place.depth_mm.push_back(blocked ? 0 : wayToSkin(from, axis));
            const double width_mm = std::min(gap_mm, place.round_gap.along(axis));
            const bool deep = place.depth_mm.back() > std::min(kDeepMm, kDeepRatio * width_mm);
            place.reach.push_back(blocked                                ? Reach::None
                                  : deep                                 ? Reach::Poor
                                  : isUprightOrLevel(place.normal, axis) ? Reach::Finished
                                                                         : Reach::Steps);
        }
    }

  private:
    static bool isUprightOrLevel(const Vec3& normal, const Vec3& axis) {
        const double up = normal.dot(axis);
        return std::abs(up) < kUprightSine || (up > 0 && isAlong(normal, axis));
    }

    double wayToSkin(const Vec3& from, const Vec3& direction) const {
        return stock_.kind == Stock::Kind::Box ? wayOut(stock_.bbox_mm, from, direction)
                                               : stock_tree_.distance(from, direction);
    }

    RayTree part_;
    const Stock& stock_;
    RayTree stock_tree_;
    const std::vector<Vec3>& axes_;
    double size_mm_ = 0;
};

}  // namespace

std::vector<SampleGroup> sampleReach(const Part& part, const FaceFacets& part_facets, const Stock& stock,
                                     const Facets& stock_facets, const std::vector<Vec3>& axes) {
    std::vector<Place> places = placesOn(part, part_facets);
    const std::vector<Place> corners = placesInCorners(part, part_facets);
    places.insert(places.end(), corners.begin(), corners.end());
    const Sampler sampler(part_facets.facets, stock, stock_facets, axes);
    parallelFor(places.size(), [&](std::size_t i) { sampler.ask(places[i]); });
    double total_mm3 = 0;
    for (const Place& place : places)
        total_mm3 += place.volume_mm3;
    std::map<std::vector<Reach>, SampleGroup> groups;
    for (const Place& place : places) {
        if (place.reach.empty()) continue;
        SampleGroup& group = groups[place.reach];
        group.volume_share += place.volume_mm3 / total_mm3;
        group.depth_mm.resize(axes.size(), 0.0);
        for (std::size_t axis = 0; axis < axes.size(); ++axis)
            if (std::isfinite(place.depth_mm[axis]))
                group.depth_mm[axis] += place.depth_mm[axis] * place.volume_mm3 / total_mm3;
        group.faces += place.of_face;
        if (place.ruled) group.ruled_share += place.volume_mm3 / total_mm3;
    }
    std::vector<SampleGroup> found;
    for (auto& [reach, group] : groups) {
        group.reach = reach;
        for (double& depth_mm : group.depth_mm)
            depth_mm /= group.volume_share > 0 ? group.volume_share : 1;
        found.push_back(std::move(group));
    }
    return found;
}

}  // namespace stepmill::setup
