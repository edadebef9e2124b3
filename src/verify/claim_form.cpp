// The bands of a form ground, derived anew from the part.

#include "verify/claim_form.h"

#include <fmt/format.h>

#include "stepmill/layers/section_cutter.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::verify {
namespace {

/// Heights in plan.json have six decimals: sections are compared that far inside their bands [mm].
constexpr double kWrittenMm = 1e-6;

/// Walls of free form are fitted anew at every height, each time within the curve tolerance.
double slackMm(const Tolerances& tol) {
    return tol.gouge_mm + 2 * tol.curve_fit_mm;
}

/// The first height of a band at which the part is not covered.
std::optional<double> uncovered(const SectionCutter& part, const Obstacle& band, const Region& window,
                                const Tolerances& tol) {
    double bottom_mm = band.bottom_z_mm + kWrittenMm;
    std::vector<double> tops = part.levelsBetween(bottom_mm, band.top_z_mm - kWrittenMm);
    tops.push_back(band.top_z_mm - kWrittenMm);
    for (const double top_mm : tops) {
        const Region stands = intersect(part.partBetween(bottom_mm, top_mm), window, tol);
        if (!covers(band.section, stands, slackMm(tol), tol)) return bottom_mm;
        bottom_mm = top_mm;
    }
    return std::nullopt;
}

bool coversFixtures(const Obstacle& band, const Setup& setup, const Region& window, const Tolerances& tol) {
    for (const Fixture& fixture : setup.fixtures) {
        if (fixture.bottom_z_mm >= band.top_z_mm - kWrittenMm ||
            fixture.top_z_mm <= band.bottom_z_mm + kWrittenMm)
            continue;
        if (!covers(band.section, intersect(fixture.section, window, tol), tol.gouge_mm, tol)) return false;
    }
    return true;
}

}  // namespace

void compareForm(const FormGround& ground, const Setup& setup, const Tolerances& tol,
                 std::vector<ProofFailure>& failures) {
    const SectionCutter part(setup, tol);
    for (const Obstacle& band : ground.must_stand) {
        if (const auto z_mm = uncovered(part, band, ground.window, tol))
            failures.push_back(
                {"plan.json", 0, ground.id,
                 fmt::format("what must stand over Z{:.4f} is less than the part there", *z_mm)});
        if (!coversFixtures(band, setup, ground.window, tol))
            failures.push_back(
                {"plan.json", 0, ground.id,
                 fmt::format("what must stand over Z{:.4f} leaves out a fixture", band.bottom_z_mm)});
        if (!failures.empty()) return;
    }
}

}  // namespace stepmill::verify
