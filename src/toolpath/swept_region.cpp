#include "stepmill/toolpath/swept_region.h"

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/disc_sweep.h"

namespace stepmill::toolpath {
namespace {

std::vector<Region> sweeps(const std::vector<Path>& ways, double radius_mm, const Tolerances& tol) {
    std::vector<Region> swept;
    swept.reserve(ways.size());
    for (const Path& way : ways)
        swept.push_back(discSweep(way, radius_mm, tol));
    return swept;
}

}  // namespace

std::vector<Region> piecesBeyondSkins(const Region& region, const Tolerances& tol) {
    std::vector<Region> pieces = components(region);
    std::erase_if(pieces, [&](const Region& piece) {
        const double mean_width_mm = 2 * area(piece) / perimeter(piece);
        return area(piece) <= tol.area_mm2 || mean_width_mm <= kSkinSlivers * tol.sliver_mm;
    });
    return pieces;
}

Region beyondSkins(const Region& region, const Tolerances& tol) {
    Region all;
    for (const Region& piece : piecesBeyondSkins(region, tol))
        append(all, piece);
    return all;
}

Region sweptRegion(const std::vector<Path>& ways, double radius_mm, const Tolerances& tol) {
    return unite(sweeps(ways, radius_mm, tol), tol);
}

Region notSwept(const Region& region, const std::vector<Path>& ways, double radius_mm,
                const Tolerances& tol) {
    return subtract(region, sweeps(ways, radius_mm, tol), tol);
}

}  // namespace stepmill::toolpath
