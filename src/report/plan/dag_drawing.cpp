#include "report/plan/dag_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "report/page/drawing.h"
#include "report/page/words.h"

namespace stepmill::report {
namespace {

// The picture, in its own units, y down.
constexpr double kWidth = 1000;
constexpr double kLine = 190;  ///< where the nodes stand
constexpr double kHeight = 226;
constexpr double kMargin = 46;
constexpr double kNode = 6;
/// Height of an arc as a share of its width, and the highest.
constexpr double kArcShare = 0.42;
constexpr double kHighestArc = 165;

/// Where each node stands: the source first, the sink last.
using Places = std::map<std::string, double>;
const std::string kSource;
const std::string kSink = "\n";  // no tool's id

const std::string& target(const DagEdge& edge) {
    return edge.to.empty() ? kSink : edge.to;
}

/// Tools with an edge, by falling diameter.
std::vector<std::string> nodesOf(const ToolSequence& sequence) {
    std::set<std::string> met;
    for (const DagEdge& edge : sequence.edges) {
        met.insert(edge.from);
        met.insert(edge.to);
    }
    std::vector<std::string> nodes{kSource};
    for (const ToolReach& reach : sequence.tools)
        if (met.contains(reach.tool_id)) nodes.push_back(reach.tool_id);
    nodes.push_back(kSink);
    return nodes;
}

Places placesOf(const std::vector<std::string>& nodes) {
    Places places;
    const double step = (kWidth - 2 * kMargin) / static_cast<double>(nodes.size() - 1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        places[nodes[i]] = kMargin + step * static_cast<double>(i);
    return places;
}

Element label(const char* css_class, double x, double y, const std::string& words) {
    return Element("text", words).with("class", css_class).with("x", fixed(x, 1)).with("y", fixed(y, 1));
}

void drawEdge(Element& svg, const DagEdge& edge, const Places& places, bool chosen) {
    const auto from = places.find(edge.from);
    const auto to = places.find(target(edge));
    if (from == places.end() || to == places.end()) return;
    const double middle = (from->second + to->second) / 2;
    const double rise = std::min(kHighestArc, kArcShare * std::abs(to->second - from->second));
    // A quadratic curve goes half as high as its control point.
    svg.add(Element("path")
                .with("class", chosen            ? "chosen"
                               : edge.to.empty() ? "to-sink"
                                                 : "weighed")
                .with("d", fmt::format("M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}", from->second, kLine,
                                       middle, kLine - 2 * rise, to->second, kLine)));
    if (chosen && !edge.to.empty()) svg.add(label("time", middle, kLine - rise - 5, clockTime(edge.time_s)));
}

}  // namespace

DagWay chosenWay(const ToolSequence& sequence) {
    DagWay chosen;
    std::string previous;
    for (const SequenceStep& step : sequence.steps) {
        if (step.role == Role::Surrogate || step.tool_id == previous) continue;
        chosen.insert({previous, step.tool_id});
        previous = step.tool_id;
    }
    if (!previous.empty()) chosen.insert({previous, ""});
    return chosen;
}

std::optional<Element> dagDrawing(const ToolSequence& sequence) {
    const std::vector<std::string> nodes = nodesOf(sequence);
    constexpr std::size_t kNoChoice = 3;  // source, one tool, sink
    if (nodes.size() <= kNoChoice) return std::nullopt;
    const Places places = placesOf(nodes);
    const DagWay chosen = chosenWay(sequence);
    Element svg = emptySvg("svg.dag", fmt::format("0 0 {:g} {:g}", kWidth, kHeight),
                           "Tool DAG of " + sequence.feature_id);
    for (const bool thick : {false, true})
        for (const DagEdge& edge : sequence.edges)
            if (chosen.contains({edge.from, edge.to}) == thick) drawEdge(svg, edge, places, thick);
    for (const std::string& node : nodes) {
        const double x = places.at(node);
        svg.add(
            Element("circle").with("cx", fixed(x, 1)).with("cy", fixed(kLine, 1)).with("r", fixed(kNode, 1)));
        svg.add(label("node", x, kLine + 24, node == kSource ? "start" : node == kSink ? "done" : node));
    }
    const std::string words = fmt::format(
        "{} edges weighed, {} ruled out by their lower bounds. Thick: the way taken, with times; dashed: "
        "tools "
        "that may be the last.",
        sequence.edges.size(), sequence.pruned_edges);
    return Element("figure", std::move(svg), Element("figcaption", words));
}

}  // namespace stepmill::report
