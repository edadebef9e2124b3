// What a plan makes of features and options before it sequences them.

#include "stepmill/plan/deep_bands.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "stepmill/access/collision.h"
#include "stepmill/plan/stages.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {
namespace {

/// A mill that reaches less than this share of a feature's depth clears it in no number of bands.
constexpr double kMostBands = 100;

/// Of the widest mill, which does most of the work; of several the longest. 0: there is no mill.
double bandMm(const ToolLibrary& library, const std::string& material) {
    double widest_mm = 0;
    double reach_mm = 0;
    for (const ToolAssembly& tool : library.tools) {
        if (tool.isDrill() || tool.type == ToolType::Face || tool.cuttingFor(material) == nullptr) continue;
        if (tool.diameter_mm < widest_mm) continue;
        reach_mm = tool.diameter_mm > widest_mm ? access::freeReachMm(tool)
                                                : std::max(reach_mm, access::freeReachMm(tool));
        widest_mm = tool.diameter_mm;
    }
    return reach_mm;
}

}  // namespace

std::vector<Feature> inBands(const std::vector<Feature>& features, const ToolLibrary& library,
                             const std::string& material) {
    const double band_mm = bandMm(library, material);
    std::vector<Feature> bands;
    std::map<std::string, std::string> last_band;  // of features that were parted
    for (const Feature& feature : features) {
        Feature band = feature;
        for (std::string& parent : band.parents)
            if (const auto parted = last_band.find(parent); parted != last_band.end())
                parent = parted->second;
        const bool whole = band_mm <= 0 || isHole(feature.feature_class) || feature.depth_mm() <= band_mm;
        const int count =
            whole ? 1 : static_cast<int>(std::ceil(std::min(feature.depth_mm() / band_mm, kMostBands)));
        for (int i = 0; i < count && !whole; ++i) {
            band.band = Band{feature.id, i + 1, count};
            band.id = fmt::format("{}.{}", feature.id, i + 1);
            band.top_z_mm = feature.top_z_mm - feature.depth_mm() * i / count;
            band.floor_z_mm =
                i + 1 == count ? feature.floor_z_mm : feature.top_z_mm - feature.depth_mm() * (i + 1) / count;
            band.volume_mm3 = feature.volume_mm3 / count;
            band.through = feature.through && i + 1 == count;
            bands.push_back(band);
            band.parents = {band.id};
            last_band[feature.id] = band.id;
        }
        if (whole) bands.push_back(std::move(band));
    }
    return bands;
}

SequenceOptions asPlanned(SequenceOptions options) {
    options.clear_of_own_material = true;
    return options;
}

}  // namespace stepmill
