#include "report/viewer/part_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <BRepMesh_IncrementalMesh.hxx>

#include "report/page/facets.h"
#include "report/page/hidden_lines.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::report {
namespace {

/// How far facets may be off the part as a share of its diagonal, and how far they turn [rad].
constexpr double kChordShare = 4e-4;
constexpr double kFacetAngle = 0.3;
/// More facets are made coarser, as often as that takes.
constexpr std::size_t kMostTriangles = 150000;
constexpr double kCoarser = 2;
constexpr int kMostTries = 4;

/// As few as kMostTriangles where that can be.
std::vector<SolidFacet> meshed(const Part& part) {
    std::vector<SolidFacet> facets;
    double coarser = 1;
    for (int tries = 0; tries < kMostTries; ++tries, coarser *= kCoarser) {
        const TopoDS_Shape solid = solidIn(part, Eigen::Isometry3d::Identity());
        const BRepMesh_IncrementalMesh mesh(solid, coarser * kChordShare * part.bbox_mm.diagonal().norm(),
                                            false, coarser * kFacetAngle);
        facets = facetsOf(solid);
        if (facets.size() <= kMostTriangles) break;
    }
    return facets;
}

std::uint16_t shareOfRange(double value, double low, double high) {
    constexpr double kMost = 65535;
    const double range = std::max(1e-9, high - low);
    return static_cast<std::uint16_t>(std::lround(std::clamp((value - low) / range, 0.0, 1.0) * kMost));
}

/// Numbers the corners of facets, each once a face.
class Corners {
  public:
    explicit Corners(PartMesh& packed) : packed_(packed) {}

    std::int64_t numberOf(const Vec3& corner, std::size_t face) {
        std::array<std::uint16_t, 3> place{};
        for (int axis = 0; axis < 3; ++axis)
            place[axis] = shareOfRange(corner[axis], packed_.box_mm.min()[axis], packed_.box_mm.max()[axis]);
        const auto [found, is_new] = numbers_.try_emplace({face, place}, packed_.corners);
        if (is_new) {
            ++packed_.corners;
            for (const std::uint16_t share : place)
                packed_.places.half(share);
        }
        return static_cast<std::int64_t>(found->second);
    }

  private:
    PartMesh& packed_;
    std::map<std::pair<std::size_t, std::array<std::uint16_t, 3>>, std::size_t> numbers_;
};

}  // namespace

PartMesh partMesh(const Part& part) {
    std::vector<SolidFacet> facets;
    guardOcct(ErrorCode::GeometryKernel, "facets of " + part.name, [&] { facets = meshed(part); });
    PartMesh packed;
    packed.triangles = facets.size();
    for (const SolidFacet& facet : facets)
        for (const Vec3& corner : facet.corners)
            packed.box_mm.extend(corner);
    Corners corners(packed);
    std::int64_t before = 0;
    for (SolidFacet& facet : facets) {
        if (facet.reversed) std::swap(facet.corners[1], facet.corners[2]);
        for (const Vec3& corner : facet.corners) {
            const std::int64_t number = corners.numberOf(corner, facet.face);
            packed.sides.number(number - before);
            before = number;
        }
    }
    return packed;
}

}  // namespace stepmill::report
