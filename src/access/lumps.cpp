#include "stepmill/access/lumps.h"

#include <algorithm>
#include <cmath>

#include "stepmill/access/collision.h"
#include "stepmill/access/slivers.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {
namespace {

constexpr double kHolderStepMm = 0.1;

}  // namespace

Region within(const Region& region, const Box2& box, const Tolerances& tol) {
    if (region.empty() || !boundingBox(region).intersects(box)) return {};
    return intersect(region, makeRectangle(box.min(), box.max()), tol);
}

Region withoutCrumbs(const Region& region, const Tolerances& tol) {
    const Region wide = access::withoutSliverComponents(region, tol);
    if (wide.empty()) return {};
    // Two areas that should share a wall may leave a strip along it that hangs on to a true piece.
    Region kept;
    for (const Region& piece : components(ClearanceDiagram(wide, tol).withoutStrips(tol.sliver_mm)))
        if (area(piece) > tol.area_mm2) append(kept, piece);
    return kept;
}

std::vector<Region> lumpsOf(const Region& blocked, double apart_mm, const Tolerances& tol) {
    const std::vector<Region> pieces = components(withoutCrumbs(blocked, tol));
    if (pieces.size() < 2) return pieces;
    Region all;
    for (const Region& piece : pieces)
        append(all, piece);
    const std::vector<Region> neighbourhoods = components(offset(all, apart_mm / 2, tol));
    std::vector<Region> lumps(neighbourhoods.size());
    std::vector<std::size_t> order;
    for (const Region& piece : pieces) {
        const Vec2 at = piece.loops.front().start;
        for (std::size_t i = 0; i < neighbourhoods.size(); ++i) {
            if (!contains(neighbourhoods[i], at)) continue;
            if (lumps[i].empty()) order.push_back(i);
            append(lumps[i], piece);
            break;
        }
    }
    std::vector<Region> ordered;
    for (const std::size_t i : order)
        ordered.push_back(std::move(lumps[i]));
    return ordered;
}

Region obstructionWithHolder(const FeatureGround& ground, const ToolAssembly& tool) {
    const std::vector<access::Blocker> blockers = access::blockers(ground.feature(), tool);
    if (blockers.empty()) return ground.feature().obstruction;
    return access::withoutHolder(ground, blockers, tool.radius_mm()).obstruction;
}

double widestClearHolderMm(const FeatureGround& ground, const ToolAssembly& tool, const CutterArea& area) {
    const std::vector<access::Blocker> blockers = access::blockers(ground.feature(), tool);
    const auto isClear = [&](double diameter_mm) {
        return std::none_of(blockers.begin(), blockers.end(), [&](access::Blocker blocker) {
            blocker.radius_mm = std::min(blocker.radius_mm, diameter_mm / 2);
            return access::losesCentres(ground, blocker, area.free_centres);
        });
    };
    double clear_mm = tool.diameter_mm;
    double touching_mm = tool.diameter_mm;
    for (const access::Blocker& blocker : blockers)
        touching_mm = std::max(touching_mm, 2 * blocker.radius_mm);
    while (touching_mm - clear_mm > kHolderStepMm) {
        const double middle_mm = (clear_mm + touching_mm) / 2;
        (isClear(middle_mm) ? clear_mm : touching_mm) = middle_mm;
    }
    const double turned_mm = clear_mm - 2 * tool.holder_clearance_mm;
    return std::max(tool.diameter_mm, std::floor(turned_mm / kHolderStepMm) * kHolderStepMm);
}

Feature lumpFeature(const Feature& feature, const Region& lump, const std::vector<Region>& obstruction,
                    double reach_mm, const Tolerances& tol) {
    Feature small;
    small.id = feature.id;
    small.setup_id = feature.setup_id;
    small.feature_class = FeatureClass::OpenPocket;
    small.top_z_mm = feature.top_z_mm;
    small.floor_z_mm = feature.floor_z_mm;
    small.target = lump;
    const Box2 around = grown(boundingBox(lump), reach_mm);
    std::vector<Region> near;
    for (const Region& standing : obstruction) {
        Region part = within(standing, around, tol);
        if (!part.empty()) near.push_back(std::move(part));
    }
    if (!near.empty()) small.obstruction = unite(near, tol);
    // Open wherever nothing stands: the areas go by target and obstruction.
    small.open_length_mm = perimeter(lump);
    small.area_mm2 = area(lump);
    small.volume_mm3 = small.area_mm2 * small.depth_mm();
    return small;
}

}  // namespace stepmill
