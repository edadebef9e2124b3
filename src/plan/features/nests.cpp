#include "plan/features/nests.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "stepmill/feature/heights.h"

namespace stepmill {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::map<std::string, std::size_t> numbersOf(const std::vector<Feature>& features) {
    std::map<std::string, std::size_t> numbers;
    for (std::size_t i = 0; i < features.size(); ++i)
        numbers.emplace(features[i].id, i);
    return numbers;
}

/// The child that each feature goes on in, or kNone.
std::vector<std::size_t> nextBelow(const std::vector<Feature>& features) {
    const std::map<std::string, std::size_t> number = numbersOf(features);
    std::vector<std::size_t> next(features.size(), kNone);
    for (std::size_t i = 0; i < features.size(); ++i) {
        const Feature& child = features[i];
        if (child.parents.size() != 1 || isHole(child.feature_class)) continue;
        const std::size_t above = number.at(child.parents.front());
        const Feature& parent = features[above];
        if (isHole(parent.feature_class)) continue;
        if (std::abs(parent.floor_z_mm - child.top_z_mm) > kSameHeightMm) continue;
        if (next[above] == kNone || features[next[above]].area_mm2 < child.area_mm2) next[above] = i;
    }
    return next;
}

}  // namespace

std::vector<Nest> nestsOf(const std::vector<Feature>& features) {
    const std::vector<std::size_t> next = nextBelow(features);
    std::vector<bool> goes_on_above(features.size(), false);
    for (const std::size_t below : next)
        if (below != kNone) goes_on_above[below] = true;
    std::vector<Nest> nests;
    for (std::size_t first = 0; first < features.size(); ++first) {
        if (goes_on_above[first]) continue;
        Nest& nest = nests.emplace_back();
        for (std::size_t i = first; i != kNone; i = next[i])
            nest.push_back(i);
    }
    return nests;
}

std::vector<std::vector<std::size_t>> generationsOf(const std::vector<Nest>& nests,
                                                    const std::vector<Feature>& features) {
    const std::map<std::string, std::size_t> number = numbersOf(features);
    std::vector<std::size_t> nest_of(features.size());
    for (std::size_t n = 0; n < nests.size(); ++n)
        for (const std::size_t i : nests[n])
            nest_of[i] = n;
    // Only the first of a nest waits for another nest, which begins before it.
    std::vector<std::size_t> depth(nests.size(), 0);
    std::vector<std::vector<std::size_t>> generations;
    for (std::size_t n = 0; n < nests.size(); ++n) {
        for (const std::string& parent : features[nests[n].front()].parents)
            depth[n] = std::max(depth[n], depth[nest_of[number.at(parent)]] + 1);
        if (depth[n] >= generations.size()) generations.resize(depth[n] + 1);
        generations[depth[n]].push_back(n);
    }
    return generations;
}

}  // namespace stepmill
