#include "sequence/dag/lower_bound.h"

#include <algorithm>

#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

/// The least any sequence ends with.
double clearedAtTheEnd(const std::vector<Candidate>& tools, const std::vector<bool>& ends) {
    double least = kNoEdge;
    for (std::size_t k = 0; k < tools.size(); ++k) {
        if (ends[k]) least = std::min(least, tools[k].coverable_mm2);
    }
    return least;
}

/// Area that the tools 0..k can clear together, as far as it counts: no more than `end_mm2`. Mostly it is
/// the last tool's own; only a smaller cutter that cannot get down where a larger one can makes it larger.
std::vector<double> reachedAreas(const Feature& feature, const std::vector<Candidate>& tools, double end_mm2,
                                 const Tolerances& tol) {
    std::vector<double> areas;
    Region reached;
    double reached_mm2 = 0;
    for (const Candidate& tool : tools) {
        if (tool.drill() && !tool.predrills) {
            reached_mm2 = feature.area_mm2;
        } else if (reached_mm2 < feature.area_mm2 - sameArea(feature, tol)) {
            reached =
                reached.empty() ? tool.cleared->coverable : unite(reached, tool.cleared->coverable, tol);
            reached_mm2 = std::max({reached_mm2, area(reached), tool.coverable_mm2});
        }
        areas.push_back(std::min(reached_mm2, end_mm2));
    }
    return areas;
}

/// The feeds that bounds are for.
enum class BoundFeeds {
    CuttingData,  ///< the library's, whatever is cut
    AsCut         ///< those that plans run with
};

/// The fastest of the tools k, k+1, ..., and of the surrogates that are no candidates.
std::vector<double> fastestFrom(const std::vector<Candidate>& tools, BoundFeeds feeds) {
    const bool as_cut = feeds == BoundFeeds::AsCut;
    double fastest = 0;
    for (const Candidate& tool : tools)
        fastest =
            std::max(fastest, as_cut ? tool.outsider_rate_as_cut_mm3_per_s : tool.outsider_rate_mm3_per_s);
    std::vector<double> rates(tools.size());
    for (std::size_t k = tools.size(); k-- > 0;) {
        fastest = std::max(fastest, as_cut ? tools[k].rate_as_cut_mm3_per_s : tools[k].volume_rate_mm3_per_s);
        rates[k] = fastest;
    }
    return rates;
}

/// The smallest tool in use ends the feature, or is a surrogate of a tool that does and smaller than it.
std::vector<bool> smallestUsed(const std::vector<Candidate>& tools, std::vector<bool> ends) {
    const bool any_with_surrogates =
        std::any_of(tools.begin(), tools.end(), [](const Candidate& tool) { return tool.hasSurrogates(); });
    for (std::size_t k = 1; any_with_surrogates && k < ends.size(); ++k)
        ends[k] = ends[k] || ends[k - 1];
    return ends;
}

/// \param reached  as from reachedAreas()
LeastTimes leastTimes(const Feature& feature, const std::vector<Candidate>& tools,
                      const std::vector<bool>& ends, const std::vector<double>& reached, BoundFeeds feeds) {
    const std::vector<double> fastest = fastestFrom(tools, feeds);
    const bool plain =
        std::none_of(tools.begin(), tools.end(), [](const Candidate& tool) { return tool.hasSurrogates(); });
    const int n = static_cast<int>(tools.size());
    // Surrogates touch walls that no candidate does.
    const auto along_walls = [&](int m, int k) {
        return plain ? leastWallS(m == kSource ? nullptr : &tools[m], tools[k]) : 0;
    };
    // What tool k is the first in the sequence to reach, it, a later one or a surrogate must clear, at best
    // as fast as the fastest of these.
    const auto cutting = [&](int m, int k) {
        const double before = m == kSource ? 0 : reached[m];
        const double volume_s = std::max(0.0, reached[k] - before) * feature.depth_mm() / fastest[k];
        return std::max(volume_s, along_walls(m, k));
    };
    LeastTimes least;
    least.ends = smallestUsed(tools, ends);
    for (const Candidate& tool : tools)
        least.tools.push_back(tool.tool->id);
    for (int m = kSource; m < n; ++m) {
        std::vector<double>& row = least.cutting_s.emplace_back(n, kNoEdge);
        for (int k = m + 1; k < n; ++k)
            row[k] = cutting(m, k);
    }
    return least;
}

}  // namespace

TimeBounds timeBounds(const Feature& feature, const std::vector<Candidate>& tools,
                      const std::vector<bool>& ends, const Machine& machine, const Tolerances& tol) {
    const std::vector<double> reached = reachedAreas(feature, tools, clearedAtTheEnd(tools, ends), tol);
    const LeastTimes least = leastTimes(feature, tools, ends, reached, BoundFeeds::CuttingData);
    const int n = static_cast<int>(tools.size());
    TimeBounds bounds;
    const CheapestPath with = cheapestPath(
        n, [&](int m, int k) { return least.cuttingS(m, k) + machine.tool_change_s; }, least.ends);
    if (!with.tools.empty()) bounds.with_changes_s = with.cost;
    bounds.as_cut = leastTimes(feature, tools, ends, reached, BoundFeeds::AsCut);
    return bounds;
}

}  // namespace stepmill
