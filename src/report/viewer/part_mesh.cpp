#include "report/viewer/part_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "report/page/facets.h"

namespace stepmill::report {
namespace {

/// More facets are made coarser, as often as that takes.
constexpr std::size_t kMostTriangles = 150000;
constexpr double kCoarser = 2;
constexpr int kMostTries = 4;

/// As few as kMostTriangles where that can be.
std::vector<SolidFacet> fewFacetsOf(const FacetedPart& faceted) {
    std::vector<SolidFacet> facets = facetsOf(faceted.solid());
    double coarser = kCoarser;
    for (int tries = 1; tries < kMostTries && facets.size() > kMostTriangles; ++tries, coarser *= kCoarser)
        facets = facetsOf(FacetedPart(faceted.part(), coarser).solid());
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

PartMesh partMesh(const FacetedPart& faceted) {
    std::vector<SolidFacet> facets = fewFacetsOf(faceted);
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
