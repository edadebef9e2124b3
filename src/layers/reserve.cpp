// Stock that stands for a later setup, among the layers of one.

#include "stepmill/layers/reserve.h"

#include <algorithm>

#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Heights closer than this are one: they may come out of a plan.json, which has six decimals [mm].
constexpr double kSameLevelMm = 1e-5;

/// The layer between two heights of it.
Layer between(const Layer& whole, double top_mm, double bottom_mm) {
    Layer part = whole;
    part.top_z_mm = top_mm;
    part.bottom_z_mm = bottom_mm;
    const double share = part.height_mm() / whole.height_mm();
    part.stock_air_mm3 *= share;
    part.sloped_volume_mm3 *= share;
    for (HiddenVolume& hidden : part.hidden)
        hidden.volume_mm3 *= share;
    return part;
}

/// Does the prism stand in the layer or over it?
bool standsOver(const Prism& prism, const Layer& layer) {
    return prism.top_z_mm > layer.bottom_z_mm + kSameLevelMm;
}

std::vector<double> endsOf(const std::vector<Prism>& prisms) {
    std::vector<double> heights;
    for (const Prism& prism : prisms)
        heights.insert(heights.end(), {prism.top_z_mm, prism.bottom_z_mm});
    return heights;
}

}  // namespace

LayerStack partedAt(LayerStack layers, const std::vector<double>& heights_mm) {
    std::vector<double> from_above = heights_mm;
    std::sort(from_above.rbegin(), from_above.rend());
    std::vector<Layer> parted;
    for (Layer& layer : layers.layers) {
        double top_mm = layer.top_z_mm;
        for (const double z_mm : from_above) {
            if (z_mm >= top_mm - kSameLevelMm || z_mm <= layer.bottom_z_mm + kSameLevelMm) continue;
            parted.push_back(between(layer, top_mm, z_mm));
            top_mm = z_mm;
        }
        parted.push_back(top_mm == layer.top_z_mm ? std::move(layer)
                                                  : between(layer, top_mm, layer.bottom_z_mm));
    }
    layers.layers = std::move(parted);
    return layers;
}

LayerStack withReserve(LayerStack layers, const std::vector<Prism>& reserve, const Tolerances& tol) {
    if (reserve.empty()) return layers;
    layers = partedAt(std::move(layers), endsOf(reserve));
    std::vector<bool> counted(reserve.size(), false);
    Region standing;
    for (Layer& layer : layers.layers) {
        for (std::size_t i = 0; i < reserve.size(); ++i) {
            if (counted[i] || !standsOver(reserve[i], layer)) continue;
            standing = standing.empty() ? reserve[i].region : unite(standing, reserve[i].region, tol);
            counted[i] = true;
        }
        if (standing.empty()) continue;
        layer.shadow = unite(layer.shadow, standing, tol);
    }
    return layers;
}

}  // namespace stepmill
