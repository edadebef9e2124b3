#include "bench/kernels.h"
#include "stepmill/access/access.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill::bench {
namespace {

/// A cutter that gets in everywhere, so that areas are a matter of geometry alone.
ToolAssembly cutter(double radius_mm) {
    ToolAssembly tool;
    tool.id = "cutter";
    tool.diameter_mm = 2 * radius_mm;
    tool.flute_length_mm = tool.stick_out_mm = 100;
    tool.centre_cutting = true;
    CuttingData data;
    data.material = "any";
    data.step_down_mm = 1;
    data.ramp_angle_deg = 3;
    tool.cutting.push_back(data);
    return tool;
}

}  // namespace

double StepmillKernel::openings(const Region& region, const std::vector<double>& radii_mm) const {
    const ClearanceDiagram diagram(region, {});
    double sum = 0;
    for (const double radius : radii_mm)
        sum += area(diagram.opening(radius));
    return sum;
}

double StepmillKernel::insets(const Region& region, const std::vector<double>& distances_mm) const {
    const ClearanceDiagram diagram(region, {});
    double sum = 0;
    for (const double distance : distances_mm)
        sum += area(diagram.offset(-distance));
    return sum;
}

double StepmillKernel::rings(const Region& region, double step_mm) const {
    double sum = 0;
    for (const Region& ring : ClearanceDiagram(region, {}).rings(step_mm / 2, step_mm))
        sum += area(ring);
    return sum;
}

Pairs StepmillKernel::decomposed(const Region& region, const std::vector<double>& radii_mm,
                                 double budget_s) const {
    const double start_s = processorSeconds();
    Feature feature;
    feature.id = "bench";
    feature.target = region;
    feature.floor_z_mm = -1;
    feature.area_mm2 = area(region);
    const FeatureGround ground(feature, {});
    std::vector<AccessibleArea> areas;
    for (const double radius : radii_mm)
        areas.push_back(accessibleArea(ground, cutter(radius), "any"));
    return runPairs(radii_mm.size(), start_s, budget_s, [&](std::size_t m, std::size_t n) {
        return area(decomposedArea(ground, &areas[m], areas[n]).area);
    });
}

}  // namespace stepmill::bench
