#include "report/plan/dag_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "report/page/drawing.h"
#include "report/page/words.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill::report {
namespace {

// The picture, in its own units, y down.
constexpr double kWidth = 1000;
constexpr double kLine = 190;  ///< where the nodes stand
constexpr double kHeight = 238;
/// Names stand in two rows below the nodes, cut short where they are long.
constexpr double kNameRow = 13;
constexpr std::size_t kMostNameBytes = 9;
constexpr double kMargin = 46;
constexpr double kNode = 6;
/// Height of an arc as a share of its width, and the highest.
constexpr double kArcShare = 0.42;
constexpr double kHighestArc = 165;
/// Arcs that rise less have no words below them.
constexpr double kRoomForWork = 60;

/// Where each node stands: the source first, the sink last.
using Places = std::map<DagNode, double>;
const DagNode kStart;
const DagNode kSink{"\n"};  // no tool's id

const DagNode& target(const DagEdge& edge) {
    return edge.to.empty() ? kSink : edge.to;
}

/// Nodes with an edge, by falling diameter.
std::vector<DagNode> nodesOf(const ToolSequence& sequence) {
    std::set<DagNode> met;
    for (const DagEdge& edge : sequence.edges) {
        met.insert(edge.from);
        met.insert(edge.to);
    }
    std::vector<DagNode> nodes{kStart};
    for (const ToolReach& reach : sequence.tools)
        for (const bool alone : {true, false})
            if (met.contains({reach.tool_id, alone})) nodes.push_back({reach.tool_id, alone});
    nodes.push_back(kSink);
    return nodes;
}

Places placesOf(const std::vector<DagNode>& nodes) {
    Places places;
    const double step = (kWidth - 2 * kMargin) / static_cast<double>(nodes.size() - 1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        places[nodes[i]] = kMargin + step * static_cast<double>(i);
    return places;
}

Element label(const char* css_class, double x, double y, const std::string& words) {
    return Element("text", words).with("class", css_class).with("x", fixed(x, 1)).with("y", fixed(y, 1));
}

/// The beginning of a long name; plain characters alone can be counted.
std::string shortened(const std::string& name) {
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) { return c >= ' ' && c <= '~'; });
    if (name.size() <= kMostNameBytes) return name;
    return plain ? name.substr(0, kMostNameBytes - 1) + "…" : "…";
}

/// What an edge is to the ways through the DAG.
enum class EdgeLook { Weighed, RunnerUp, Chosen };

const char* classOf(EdgeLook look, bool to_sink) {
    if (look == EdgeLook::Chosen) return "chosen";
    if (look == EdgeLook::RunnerUp) return "runner-up";
    return to_sink ? "to-sink" : "weighed";
}

/// "EM16 to EM6: 412.0 mm², 0:33, 1.20 EUR".
std::string edgeWords(const DagEdge& edge, const std::string& currency, const Measures& in) {
    std::string ends = (edge.from.empty() ? "start" : edge.from.name()) + " to " +
                       (edge.to.empty() ? "done" : edge.to.name());
    if (edge.to.empty()) return ends;
    return fmt::format("{}: {} {}, {}, {:.2f} {}", ends, in.area(edge.region_area_mm2, 1), in.areaUnit(),
                       clockTime(edge.time_s), edge.cost, currency);
}

class Picture {
  public:
    Picture(const Plan& plan, const ToolSequence& sequence, const std::vector<DagNode>& nodes,
            const Measures& in)
        : in_(in),
          currency_(plan.machine.currency),
          places_(placesOf(nodes)),
          svg_(emptySvg("svg.dag", fmt::format("0 0 {:g} {:g}", kWidth, kHeight),
                        "Tool DAG of " + sequence.feature_id)) {}

    void edge(const DagEdge& edge, EdgeLook look) {
        const auto from = places_.find(edge.from);
        const auto to = places_.find(target(edge));
        if (from == places_.end() || to == places_.end()) return;
        const double middle = (from->second + to->second) / 2;
        const double rise = std::min(kHighestArc, kArcShare * std::abs(to->second - from->second));
        // A quadratic curve goes half as high as its control point.
        svg_.add(Element("path", Element("title", edgeWords(edge, currency_, in_)))
                     .with("class", classOf(look, edge.to.empty()))
                     .with("d", fmt::format("M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}", from->second, kLine,
                                            middle, kLine - 2 * rise, to->second, kLine)));
        if (look != EdgeLook::Chosen || edge.to.empty()) return;
        svg_.add(label("time", middle, kLine - rise - 5, clockTime(edge.time_s)));
        // Below the arc, where it is high enough to have room for that.
        if (rise > kRoomForWork)
            svg_.add(label("work", middle, kLine - rise + 15,
                           fmt::format("{} {}, {:.2f} {}", in_.area(edge.region_area_mm2, 0), in_.areaUnit(),
                                       edge.cost, currency_)));
    }

    void node(const DagNode& node) {
        const double x = places_.at(node);
        svg_.add(
            Element("circle").with("cx", fixed(x, 1)).with("cy", fixed(kLine, 1)).with("r", fixed(kNode, 1)));
        const std::string words = node == kStart ? "start" : node == kSink ? "done" : node.name();
        const double y = kLine + 22 + (nodes_++ % 2 == 0 ? 0 : kNameRow);
        svg_.add(label("node", x, y, shortened(words)).add(Element("title", words)));
    }

    Element take() && { return std::move(svg_); }

  private:
    const Measures& in_;
    std::string currency_;
    Places places_;
    Element svg_;
    int nodes_ = 0;
};

/// What an edge weighs in the plan's choice; money at the programmed feeds, without acceleration.
double weightOf(const Plan& plan, const DagEdge& edge) {
    if (plan.objective == Objective::Cost) return edge.cost;
    return edge.motion_s > 0 ? edge.motion_s : edge.time_s;
}

/// A way through the DAG with what its edges weigh together; no nodes: there is none.
struct WeighedWay {
    std::vector<DagNode> nodes;
    double weight = 0;
};

/// The cheapest way over the edges but one. A change that a surrogate shares with the next tool counts twice.
/// \param without  from, to; nothing is left out where it names no edge
WeighedWay cheapestWithout(const Plan& plan, const ToolSequence& sequence,
                           const std::pair<DagNode, DagNode>& without) {
    std::map<DagNode, int> numbers{{kStart, kSource}};
    std::vector<DagNode> nodes;
    for (const ToolReach& reach : sequence.tools)
        for (const bool alone : {true, false}) {
            nodes.push_back({reach.tool_id, alone});
            numbers[nodes.back()] = static_cast<int>(nodes.size()) - 1;
        }
    std::map<std::pair<int, int>, double> weights;
    std::vector<bool> ends(nodes.size(), false);
    for (const DagEdge& edge : sequence.edges) {
        if (edge.from == without.first && edge.to == without.second) continue;
        if (edge.to.empty())
            ends[numbers.at(edge.from)] = true;
        else
            weights[{numbers.at(edge.from), numbers.at(edge.to)}] = weightOf(plan, edge);
    }
    const CheapestPath path = cheapestPath(
        static_cast<int>(nodes.size()),
        [&](int m, int n) {
            const auto found = weights.find({m, n});
            return found == weights.end() ? kNoEdge : found->second;
        },
        ends);
    WeighedWay way{{}, path.cost};
    for (const int node : path.tools)
        way.nodes.push_back(nodes[node]);
    return way;
}

/// The second best way lacks at least one edge of the best.
std::optional<RunnerUp> runnerUp(const Plan& plan, const ToolSequence& sequence, const WeighedWay& best) {
    std::optional<RunnerUp> found;
    for (const auto& edge : wayAlong(best.nodes)) {
        const WeighedWay other = cheapestWithout(plan, sequence, edge);
        if (other.nodes.empty()) continue;
        const double more = other.weight - best.weight;
        if (!found || more < found->more) found = RunnerUp{other.nodes, more};
    }
    return found;
}

std::string amountWords(double amount, const Plan& plan) {
    return plan.objective == Objective::Time ? clockTime(amount)
                                             : fmt::format("{:.2f} {}", amount, plan.machine.currency);
}

std::vector<std::string> namesOf(const std::vector<DagNode>& nodes) {
    std::vector<std::string> names(nodes.size());
    std::transform(nodes.begin(), nodes.end(), names.begin(),
                   [](const DagNode& node) { return node.name(); });
    return names;
}

std::string captionOf(const Plan& plan, const ToolSequence& sequence, const DagWays& ways) {
    std::string words = fmt::format(
        "{} edges weighed, {} ruled out by their lower bounds. Thick: the way taken, with time, area and "
        "money; "
        "dotted: tools that may be the last.",
        sequence.edges.size(), sequence.pruned_edges);
    if (ways.runner_up)
        words += fmt::format(" Dashed: the runner-up, {}, {} more.", listed(namesOf(ways.runner_up->nodes)),
                             amountWords(std::max(0.0, ways.runner_up->more), plan));
    if (!ways.own_cheapest.empty())
        words += fmt::format(
            " By itself the feature would take {}: the part as a whole calls the tools taken anyway.",
            listed(namesOf(ways.own_cheapest)));
    return words;
}

}  // namespace

DagWay wayAlong(const std::vector<DagNode>& nodes) {
    DagWay way;
    DagNode previous;
    for (const DagNode& node : nodes) {
        way.insert({previous, node});
        previous = node;
    }
    if (!previous.empty()) way.insert({previous, {}});
    return way;
}

DagWays waysOf(const Plan& plan, const ToolSequence& sequence) {
    DagWays ways;
    ways.chosen = wayAlong(sequence.way);
    if (sequence.edges.empty() || plan.cost_model != CostModel::Path) return ways;
    const WeighedWay best = cheapestWithout(plan, sequence, {kSink, kSink});
    if (best.nodes.empty()) return ways;
    ways.runner_up = runnerUp(plan, sequence, best);
    if (wayAlong(best.nodes) != ways.chosen) ways.own_cheapest = best.nodes;
    return ways;
}

std::optional<Element> dagDrawing(const Plan& plan, const ToolSequence& sequence, const Measures& in) {
    const std::vector<DagNode> nodes = nodesOf(sequence);
    constexpr std::size_t kNoChoice = 3;  // source, one tool, sink
    if (nodes.size() <= kNoChoice) return std::nullopt;
    const DagWays ways = waysOf(plan, sequence);
    const DagWay second = ways.runner_up ? wayAlong(ways.runner_up->nodes) : DagWay{};
    Picture picture(plan, sequence, nodes, in);
    for (const EdgeLook look : {EdgeLook::Weighed, EdgeLook::RunnerUp, EdgeLook::Chosen})
        for (const DagEdge& edge : sequence.edges) {
            const EdgeLook is = ways.chosen.contains({edge.from, edge.to}) ? EdgeLook::Chosen
                                : second.contains({edge.from, edge.to})    ? EdgeLook::RunnerUp
                                                                           : EdgeLook::Weighed;
            if (is == look) picture.edge(edge, look);
        }
    for (const DagNode& node : nodes)
        picture.node(node);
    return Element("figure", std::move(picture).take(),
                   Element("figcaption", captionOf(plan, sequence, ways)));
}

}  // namespace stepmill::report
