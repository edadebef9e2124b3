#include "report/plan/area_figures.h"

#include <cmath>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "report/page/drawing.h"
#include "report/page/words.h"

namespace stepmill::report {
namespace {

/// How much of the surroundings a picture shows, as a share of its longer side.
constexpr double kSurroundings = 0.12;

/// Tools with an edge that was weighed.
std::set<std::string> nodesOf(const ToolSequence& sequence) {
    std::set<std::string> nodes;
    for (const DagEdge& edge : sequence.edges)
        nodes.insert(edge.to.tool);
    return nodes;
}

bool isKeptOffByHolder(const ToolReach& reach) {
    const Exclusion* excluded = reach.exclusion();
    return excluded != nullptr && excluded->reason == ExclusionReason::HolderCollision;
}

/// Tools that reach the same, the widest first.
using Alike = std::vector<const ToolReach*>;

/// Areas that differ by less are the same to the eye [mm2].
constexpr double kSameAreaMm2 = 0.05;

bool isAlike(const ToolReach& a, const ToolReach& b) {
    return a.use.index() == b.use.index() && a.surrogates() == nullptr && b.surrogates() == nullptr &&
           isKeptOffByHolder(a) == isKeptOffByHolder(b) &&
           std::abs(a.cutter.coverable_area_mm2 - b.cutter.coverable_area_mm2) < kSameAreaMm2 &&
           std::abs(a.collision_free_area_mm2 - b.collision_free_area_mm2) < kSameAreaMm2;
}

/// The tools that take part, or would but for their holders.
std::vector<Alike> groupsOf(const ToolSequence& sequence) {
    const std::set<std::string> nodes = nodesOf(sequence);
    std::vector<Alike> groups;
    for (const ToolReach& reach : sequence.tools) {
        if (!nodes.contains(reach.tool_id) && !isKeptOffByHolder(reach)) continue;
        if (groups.empty() || !isAlike(*groups.back().back(), reach)) groups.emplace_back();
        groups.back().push_back(&reach);
    }
    return groups;
}

/// What the cutter covers of the target, red where shank or holder keep it off.
void drawReach(Drawing& drawing, const ToolReach& reach) {
    const bool hindered = isKeptOffByHolder(reach) || &reach.own() != &reach.cutter;
    drawing.region(reach.cutter.coverable, hindered ? "kept-off" : "covered");
    if (&reach.own() != &reach.cutter) drawing.region(reach.own().coverable, "covered");
    if (const WithSurrogates* with = reach.surrogates())
        for (const BlockedLump& lump : with->lumps)
            drawing.region(lump.region, "lump");
}

std::string wordsOf(const Alike& group, const Measures& in) {
    const ToolReach& reach = *group.front();
    std::vector<std::string> tools;
    for (const ToolReach* one : group)
        tools.push_back(one->tool_id);
    std::string words =
        fmt::format("{}: {} {}", listed(tools), in.area(reach.cutter.coverable_area_mm2, 1), in.areaUnit());
    if (isKeptOffByHolder(reach)) return words + ", turned down for shank or holder";
    if (reach.collision_free_area_mm2 < reach.cutter.coverable_area_mm2 - kSameAreaMm2)
        words += fmt::format(", {} {} of it free of shank and holder",
                             in.area(reach.collision_free_area_mm2, 1), in.areaUnit());
    if (const WithSurrogates* with = reach.surrogates())
        words += fmt::format("; outlined: {} for surrogates", with->lumps.size());
    return words;
}

Element figureOf(const PlannedFeature& planned, const Alike& group, const Measures& in) {
    const Feature& feature = planned.feature;
    const Box2 box = boundingBox(feature.target);
    Drawing drawing(grown(box, kSurroundings * box.sizes().maxCoeff()),
                    fmt::format("{}: what {} reaches", feature.id, group.front()->tool_id));
    drawing.region(feature.obstruction, "obstruction");
    drawing.region(feature.target, "target");
    drawReach(drawing, *group.front());
    return Element("figure", std::move(drawing).element(),
                   Element("figcaption", breakable(wordsOf(group, in))));
}

}  // namespace

std::optional<Element> areaFigures(const PlannedFeature& planned, const Measures& in,
                                   std::size_t& most_bytes) {
    Element figures("div.pairs.small");
    int left_out = 0;
    for (const Alike& group : groupsOf(planned.sequence)) {
        Element figure = figureOf(planned, group, in);
        const std::size_t bytes = figure.markup().size();
        if (bytes > most_bytes) {
            ++left_out;
            continue;
        }
        most_bytes -= bytes;
        figures.add(std::move(figure));
    }
    if (figures.empty() && left_out == 0) return std::nullopt;
    Element details("details", Element("summary", "What each tool reaches"), std::move(figures));
    if (left_out > 0)
        details.add(
            Element("p.soft", fmt::format("{} more pictures would make the page too long.", left_out)));
    return details;
}

}  // namespace stepmill::report
