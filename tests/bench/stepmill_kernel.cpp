#include "bench/kernels.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill::bench {

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
    const ClearanceDiagram diagram(region, {});
    return runPairs(radii_mm.size(), start_s, budget_s, [&](std::size_t m, std::size_t n) {
        return area(offset(diagram.restCentres(radii_mm[m], radii_mm[n]), radii_mm[n], {}));
    });
}

}  // namespace stepmill::bench
