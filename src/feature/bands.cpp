#include "feature/bands.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "stepmill/feature/whole_feature.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill::feature {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Does an upright wall of the part stand at the point somewhere between the heights?
bool isUpright(const Vec2& p, double top_z_mm, double bottom_z_mm, const LayerStack& layers,
               const Tolerances& tol) {
    return std::any_of(layers.traces.begin(), layers.traces.end(), [&](const FaceTrace& trace) {
        if (trace.stand != FaceStand::Wall || trace.footprint.segments.empty()) return false;
        if (trace.bottom_z_mm >= top_z_mm || trace.top_z_mm <= bottom_z_mm) return false;
        return distanceTo(p, trace.footprint) < tol.sliver_mm;
    });
}

/// Does a drill make it? One with leaning walls is milled like any pocket.
bool isUprightHole(const Feature& feature, const LayerStack& layers, const Tolerances& tol) {
    return isHole(feature.feature_class) &&
           isUpright(feature.target.loops.front().start, feature.top_z_mm, feature.floor_z_mm, layers, tol);
}

/// Is the feature's floor no face of the part anywhere?
bool isSoft(const Feature& feature, const LayerStack& layers, const Tolerances& tol) {
    return std::none_of(layers.traces.begin(), layers.traces.end(), [&](const FaceTrace& trace) {
        if (trace.stand != FaceStand::Floor) return false;
        if (std::abs(trace.top_z_mm - feature.floor_z_mm) > tol.gouge_mm) return false;
        if (!boundingBox(trace.region).intersects(boundingBox(feature.target))) return false;
        return area(intersect(feature.target, trace.region, tol)) > tol.area_mm2;
    });
}

/// The feature that each one goes on in, or kNone.
std::vector<std::size_t> nextBands(const std::vector<Feature>& features, const LayerStack& layers,
                                   const Tolerances& tol) {
    std::map<std::string, std::size_t> number;
    for (std::size_t i = 0; i < features.size(); ++i)
        number.emplace(features[i].id, i);
    std::vector<std::size_t> next(features.size(), kNone);
    for (std::size_t i = 0; i < features.size(); ++i) {
        const Feature& child = features[i];
        if (child.parents.size() != 1 || isUprightHole(child, layers, tol)) continue;
        const std::size_t parent = number.at(child.parents.front());
        if (features[parent].floor_z_mm != child.top_z_mm) continue;
        if (next[parent] == kNone || features[next[parent]].area_mm2 < child.area_mm2) next[parent] = i;
    }
    for (std::size_t i = 0; i < features.size(); ++i)
        if (next[i] != kNone && !isSoft(features[i], layers, tol)) next[i] = kNone;
    return next;
}

}  // namespace

void joinBands(std::vector<Feature>& features, const LayerStack& layers, const Tolerances& tol) {
    const std::vector<std::size_t> next = nextBands(features, layers, tol);
    std::vector<bool> goes_on_above(features.size(), false);
    for (const std::size_t below : next)
        if (below != kNone) goes_on_above[below] = true;
    std::map<std::string, std::string> renamed;
    int whole = 0;
    for (std::size_t first = 0; first < features.size(); ++first) {
        if (goes_on_above[first]) continue;
        const std::string id = fmt::format("{}.F{}", layers.setup_id, ++whole);
        std::vector<std::size_t> chain;
        for (std::size_t i = first; i != kNone; i = next[i])
            chain.push_back(i);
        for (std::size_t k = 0; k < chain.size(); ++k) {
            Feature& feature = features[chain[k]];
            if (chain.size() > 1)
                feature.band = Band{id, static_cast<int>(k) + 1, static_cast<int>(chain.size())};
            renamed[feature.id] = bandId(id, static_cast<int>(k) + 1, static_cast<int>(chain.size()));
        }
    }
    for (Feature& feature : features) {
        feature.id = renamed.at(feature.id);
        for (std::string& parent : feature.parents)
            parent = renamed.at(parent);
    }
}

}  // namespace stepmill::feature
