// What a plan makes of features and options before it sequences them.

#include "stepmill/plan/deep_bands.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "stepmill/access/collision.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/plan/stages.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {
namespace {

/// A mill that reaches less than this share of a feature's depth clears it in no number of bands.
constexpr double kMostDeepBands = 100;

/// Of the widest mill, which does most of the work; of several the longest. 0: there is no mill.
double bandMm(const ToolLibrary& library, const std::string& material) {
    double widest_mm = 0;
    double reach_mm = 0;
    for (const ToolAssembly& tool : library.tools) {
        if (tool.isForHoles() || tool.type == ToolType::Face || tool.type == ToolType::Chamfer ||
            tool.cuttingFor(material) == nullptr)
            continue;
        if (tool.diameter_mm < widest_mm) continue;
        reach_mm = tool.diameter_mm > widest_mm ? access::freeReachMm(tool)
                                                : std::max(reach_mm, access::freeReachMm(tool));
        widest_mm = tool.diameter_mm;
    }
    return reach_mm;
}

/// How many bands one feature, or one band of it, is cut in.
int bandsOf(const Feature& feature, double band_mm) {
    if (band_mm <= 0 || isHole(feature.feature_class) || feature.depth_mm() <= band_mm) return 1;
    return static_cast<int>(std::ceil(std::min(feature.depth_mm() / band_mm, kMostDeepBands)));
}

/// Band `i` of `count` equally deep ones.
Feature partedOff(const Feature& feature, int i, int count) {
    Feature band = feature;
    band.top_z_mm = feature.top_z_mm - feature.depth_mm() * i / count;
    if (i + 1 < count) band.floor_z_mm = feature.top_z_mm - feature.depth_mm() * (i + 1) / count;
    band.volume_mm3 = feature.volume_mm3 / count;
    band.through = feature.through && i + 1 == count;
    return band;
}

}  // namespace

std::vector<Feature> inBands(const std::vector<Feature>& features, const ToolLibrary& library,
                             const std::string& material) {
    const double band_mm = bandMm(library, material);
    std::map<std::string, int> bands_of_whole;
    for (const Feature& feature : features)
        bands_of_whole[wholeOf(feature)] += bandsOf(feature, band_mm);
    std::vector<Feature> bands;
    std::map<std::string, int> made;
    std::map<std::string, std::string> last_band;  // of every feature, by its id before
    for (const Feature& feature : features) {
        const std::string& whole = wholeOf(feature);
        const int all = bands_of_whole.at(whole);
        const int count = bandsOf(feature, band_mm);
        for (int i = 0; i < count; ++i) {
            Feature band = count > 1 ? partedOff(feature, i, count) : feature;
            if (all > 1) {
                band.band = Band{whole, ++made[whole], all};
                band.id = bandId(whole, made[whole], all);
            }
            if (i > 0) band.parents = {bands.back().id};
            for (std::string& parent : band.parents)
                if (i == 0) parent = last_band.at(parent);
            bands.push_back(std::move(band));
        }
        last_band[feature.id] = bands.back().id;
    }
    return bands;
}

SequenceOptions asPlanned(SequenceOptions options) {
    options.clear_of_own_material = true;
    return options;
}

}  // namespace stepmill
