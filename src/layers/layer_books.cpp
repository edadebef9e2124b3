// Volumes of layers: what they add up to and what leaning walls hide.

#include <cmath>

#include <fmt/format.h>

#include "layers/slab/cut_layer.h"
#include "layers/slab/local_boolean.h"

namespace stepmill::layers {

double CutLayer::inCones_mm3() const {
    double sum = 0;
    for (const auto& [face, volume_mm3] : in_cones_mm3)
        sum += volume_mm3;
    return sum;
}

double hiddenVolume(const CutLayer& cut) {
    if (cut.layer.vertical_walls) return 0;
    return std::max(0.0, area(cut.layer.part) * cut.layer.height_mm() - cut.part_volume_mm3);
}

void closeBooks(std::vector<CutLayer>& cuts, const Setup& setup, const Tolerances& tol,
                std::vector<std::string>& remarks) {
    double total = 0;
    double sloped = 0;
    for (const CutLayer& cut : cuts) {
        total += cut.part_volume_mm3;
        if (!cut.layer.vertical_walls) sloped += cut.part_volume_mm3;
    }
    const double missing = setup.part.volume_mm3 - total;
    // A millionth of the part's volume is no discrepancy, however little there is to remove.
    const double allowed = std::max(tol.volume_share * (setup.stock.volume_mm3 - setup.part.volume_mm3),
                                    1e-6 * setup.part.volume_mm3);
    if (std::abs(missing) > allowed)
        remarks.push_back(fmt::format("sections account for {:.1f} mm3 of the part's {:.1f} mm3", total,
                                      setup.part.volume_mm3));
    if (sloped <= 0 || std::abs(missing) > 0.1 * sloped) return;
    for (CutLayer& cut : cuts)
        if (!cut.layer.vertical_walls) cut.part_volume_mm3 *= 1 + missing / sloped;
}

void shareHiddenVolume(std::vector<CutLayer>& cuts, const std::vector<FaceTrace>& traces) {
    for (CutLayer& cut : cuts) {
        const double hidden = hiddenVolume(cut);
        cut.layer.sloped_volume_mm3 = hidden;
        if (hidden <= 0) continue;
        double space = 0;
        const auto spaceOf = [&](const FaceShare& share) {
            return share.space(cut.layer.top_z_mm, cut.layer.bottom_z_mm);
        };
        for (const auto& [face, share] : cut.leaning)
            space += spaceOf(share);
        const double beside_mm3 = std::max(0.0, hidden - cut.inCones_mm3());
        std::map<SlopeCause, HiddenVolume> by_cause;
        for (const auto& [face, share] : cut.leaning) {
            const auto cone = cut.in_cones_mm3.find(face);
            const double cone_mm3 = cone != cut.in_cones_mm3.end() ? cone->second : 0;
            const double volume = spaceOf(share);
            if (volume <= 0 && cone_mm3 <= 0) continue;
            const SlopeCause cause = traces[face].cause.value_or(SlopeCause::FreeForm);
            HiddenVolume& entry = by_cause[cause];
            entry.cause = cause;
            entry.volume_mm3 += cone_mm3 + (volume > 0 ? beside_mm3 * volume / space : 0);
            entry.faces.push_back(face);
        }
        // No leaning face to blame: a section that was mended with too large a region.
        if (by_cause.empty()) by_cause[SlopeCause::FreeForm] = {SlopeCause::FreeForm, hidden, {}};
        for (auto& [cause, entry] : by_cause)
            cut.layer.hidden.push_back(std::move(entry));
    }
}

void castShadows(std::vector<CutLayer>& cuts, const Tolerances& tol) {
    Region shadow;
    for (CutLayer& cut : cuts) {
        // The wider region below hides the narrower one above: ask that way round first.
        shadow = uniteLocally(cut.layer.part, shadow, tol);
        cut.layer.shadow = shadow;
    }
}

}  // namespace stepmill::layers
