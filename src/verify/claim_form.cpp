// The bands of a form ground, derived anew from the part.

#include "verify/claim_form.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "stepmill/layers/section_cutter.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::verify {
namespace {

/// Heights in plan.json have six decimals: sections are compared that far inside their bands [mm].
constexpr double kWrittenMm = 1e-6;
/// ... or farther by one of these [mm]. Each section holds all of the part between its heights, but where
/// walls are of free form they are fitted anew, by other facets where one of these ends just there; any that
/// is covered will do.
constexpr std::array kFartherInMm{0.0, 1e-6, 4e-6, 9e-6};

/// Walls of free form are fitted anew at every height, each time within the curve tolerance.
double slackMm(const Tolerances& tol) {
    return tol.gouge_mm + 2 * tol.curve_fit_mm;
}

/// What must stay of the part's section in a band.
Region staying(const Region& section, const Obstacle& band, const EdgeBreaks* breaks, const Tolerances& tol) {
    if (breaks == nullptr) return section;
    const Region may_go = breaks->mayGo(band.bottom_z_mm, band.top_z_mm);
    return may_go.empty() ? section : subtract(section, may_go, tol);
}

/// The first height of a band at which what must stay of the part is not covered.
std::optional<double> uncovered(const SectionCutter& part, const Obstacle& band, const EdgeBreaks* breaks,
                                const Region& window, const Tolerances& tol) {
    double bottom_mm = band.bottom_z_mm + kWrittenMm;
    std::vector<double> tops = part.levelsBetween(bottom_mm, band.top_z_mm - kWrittenMm);
    tops.push_back(band.top_z_mm - kWrittenMm);
    const auto is_covered = [&](double low_mm, double high_mm) {
        const Region stands =
            intersect(staying(part.partBetween(low_mm, high_mm), band, breaks, tol), window, tol);
        return covers(band.section, stands, slackMm(tol), tol);
    };
    for (const double top_mm : tops) {
        const bool covered = std::any_of(kFartherInMm.begin(), kFartherInMm.end(), [&](double more_mm) {
            return bottom_mm + more_mm < top_mm - more_mm &&
                   is_covered(bottom_mm + more_mm, top_mm - more_mm);
        });
        if (!covered) return bottom_mm;
        bottom_mm = top_mm;
    }
    return std::nullopt;
}

/// Does the band cover the part as the slicer has it in all layers that it reaches into? Layers hold the part
/// at every height of theirs.
bool coversLayers(const Obstacle& band, const LayerStack& layers, const EdgeBreaks* breaks,
                  const Region& window, const Tolerances& tol) {
    return std::all_of(layers.layers.begin(), layers.layers.end(), [&](const Layer& layer) {
        const bool apart = layer.bottom_z_mm >= band.top_z_mm - kWrittenMm ||
                           layer.top_z_mm <= band.bottom_z_mm + kWrittenMm;
        if (apart) return true;
        const Region stands = intersect(staying(layer.part, band, breaks, tol), window, tol);
        return covers(band.section, stands, tol.gouge_mm, tol);
    });
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

void compareForm(const FormGround& ground, const EdgeBreaks* breaks, const Setup& setup,
                 const LayerStack& layers, const Tolerances& tol, std::vector<ProofFailure>& failures) {
    const SectionCutter part(setup, tol);
    for (const Obstacle& band : ground.must_stand) {
        // Slabs thinner than a layer may come out wider than it: hulls of free-form facets are made for each.
        const bool as_layers = coversLayers(band, layers, breaks, ground.window, tol);
        if (const auto z_mm = as_layers ? std::nullopt : uncovered(part, band, breaks, ground.window, tol))
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
