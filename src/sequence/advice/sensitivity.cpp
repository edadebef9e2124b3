#include "stepmill/sequence/advice/sensitivity.h"

#include "sequence/dag/candidate.h"
#include "stepmill/core/enum_words.h"
#include "stepmill/core/error.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

constexpr EnumWord<Parameter> kParameters[] = {{Parameter::ToolChange, "tool-change"},
                                               {Parameter::HourlyRate, "hourly-rate"},
                                               {Parameter::ToolPrice, "tool-price"}};

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Lines that differ by less than this share are the same line but for rounding.
constexpr double kSameShare = 1e-9;

/// Splits ranges of the parameter until in each the lines that are best at its two ends are best in all of
/// it.
class Splitter {
  public:
    explicit Splitter(const CheapestAt& cheapest) : cheapest_(cheapest) {}

    std::vector<BestSequence> run() {
        const CostLine first = cheapest_(0);
        split(0, first, kInfinite, cheapest_(kInfinite));
        if (pieces_.empty()) pieces_.push_back({0, kInfinite, first});
        pieces_.back().to = kInfinite;
        return std::move(pieces_);
    }

  private:
    /// Adds the pieces between `from`, where `left` is best, and `to`, where `right` is best.
    void split(double from, const CostLine& left, double to, const CostLine& right) {
        const bool falls = left.per_unit > right.per_unit * (1 + kSameShare);
        if (!falls) {
            // One of the two is best in all of the range: the left one, unless the right one is really lower.
            add(from, left.fixed <= right.fixed * (1 + kSameShare) ? left : right);
            return;
        }
        const double meet = (right.fixed - left.fixed) / (left.per_unit - right.per_unit);
        if (meet <= from * (1 + kSameShare)) return add(from, right);
        if (meet >= to) return add(from, left);
        const CostLine middle = cheapest_(meet);
        if (middle.at(meet) >= left.at(meet) * (1 - kSameShare)) {
            add(from, left);
            add(meet, right);
            return;
        }
        split(from, left, meet, middle);
        split(meet, middle, to, right);
    }

    void add(double from, const CostLine& line) {
        if (!pieces_.empty() && pieces_.back().line.tools == line.tools) return;
        if (!pieces_.empty()) pieces_.back().to = from;
        pieces_.push_back({from, kInfinite, line});
    }

    const CheapestAt& cheapest_;
    std::vector<BestSequence> pieces_;
};

Machine withRate(Machine machine, double hourly_rate) {
    machine.hourly_rate = hourly_rate;
    return machine;
}

ToolAssembly withPrice(ToolAssembly tool, double price) {
    tool.price = price;
    return tool;
}

/// Machine and library at one value of the parameter, and the objective there.
struct Shop {
    ToolLibrary library;
    Machine machine;
    Objective objective;
};

Shop shopAt(double value, Shop shop, Parameter parameter) {
    // A change that takes longer than any path: the sequence with the fewest tools wins.
    constexpr double kEndlessChangeS = 1e9;
    const bool endless = value == kInfinite;
    switch (parameter) {
        case Parameter::ToolChange:
            shop.machine.tool_change_s = endless ? kEndlessChangeS : value;
            break;
        case Parameter::HourlyRate:
            // At an infinite rate only time counts.
            if (endless)
                shop.objective = Objective::Time;
            else
                shop.machine.hourly_rate = value;
            break;
        case Parameter::ToolPrice:
            // At infinite prices only wear counts.
            if (endless) shop.machine.hourly_rate = 0;
            for (ToolAssembly& tool : shop.library.tools)
                tool.price *= endless ? 1 : value;
            break;
    }
    return shop;
}

/// The costs alone: who pays them stays as it is.
void addCosts(const CostLine& more, CostLine& into) {
    into.fixed += more.fixed;
    into.per_unit += more.per_unit;
}

/// The cost of a sequence. Consecutive steps with the same tool share one tool change.
CostLine lineOf(const ToolSequence& sequence, const Shop& shop, Parameter parameter, Objective objective) {
    CostLine sum;
    PathTotals totals;
    for (std::size_t i = 0; i < sequence.steps.size(); ++i) {
        const SequenceStep& step = sequence.steps[i];
        totals += step.path.totals;
        const bool goes_on = i + 1 < sequence.steps.size() && sequence.steps[i + 1].tool_id == step.tool_id;
        if (goes_on) continue;
        addCosts(edgeLine(totals, shop.library.tool(step.tool_id), shop.machine, parameter, objective), sum);
        sum.tools.push_back(step.tool_id);
        totals = {};
    }
    return sum;
}

/// The tool DAG with a cost line for each evaluated edge. Nodes are numbered by falling diameter, every tool
/// alone before itself with surrogates.
class EdgeLines {
  public:
    EdgeLines(const EdgeLines&) = delete;
    EdgeLines& operator=(const EdgeLines&) = delete;
    EdgeLines(const std::vector<DagEdge>& edges, const ToolLibrary& library, const Machine& machine,
              Parameter parameter, Objective objective)
        : library_(library), order_(byFallingDiameter(library_)), ends_(2 * order_.size(), false) {
        for (const DagEdge& edge : edges) {
            const int from = edge.from.empty() ? kSource : nodeOf(edge.from);
            if (edge.to.empty()) {
                ends_[from] = true;
                continue;
            }
            const int to = nodeOf(edge.to);
            CostLine line = edgeLine(edge.totals, *toolOf(to), machine, parameter, objective);
            for (const SurrogateWork& work : edge.surrogates)
                addCosts(edgeLine(work.totals, library_.tool(work.tool), machine, parameter, objective),
                         line);
            lines_[{from, to}] = std::move(line);
        }
    }

    CostLine cheapestAt(double value) const {
        const CheapestPath path = cheapestPath(
            static_cast<int>(ends_.size()),
            [&](int m, int n) {
                const auto line = lines_.find({m, n});
                if (line == lines_.end()) return kNoEdge;
                return value == kInfinite ? line->second.per_unit : line->second.at(value);
            },
            ends_);
        CostLine sum;
        int before = kSource;
        for (const int node : path.tools) {
            addCosts(lines_.at({before, node}), sum);
            sum.tools.push_back(toolOf(node)->id);
            before = node;
        }
        return sum;
    }

  private:
    int nodeOf(const DagNode& node) const {
        const auto found = std::find_if(order_.begin(), order_.end(),
                                        [&](const ToolAssembly* tool) { return tool->id == node.tool; });
        STEPMILL_CHECK(found != order_.end(), "edges name tools of the library");
        return 2 * static_cast<int>(found - order_.begin()) + (node.alone ? 0 : 1);
    }
    const ToolAssembly* toolOf(int node) const { return order_[node / 2]; }

    ToolLibrary library_;
    std::vector<const ToolAssembly*> order_;  ///< points into library_
    std::vector<bool> ends_;
    std::map<std::pair<int, int>, CostLine> lines_;
};

}  // namespace

std::string toString(Parameter parameter) {
    return wordOf(kParameters, parameter);
}

std::optional<Parameter> parameterFrom(std::string_view word) {
    return valueOf(kParameters, word);
}

std::vector<BestSequence> bestSequences(const CheapestAt& cheapest) {
    return Splitter(cheapest).run();
}

Objective objectiveFor(Parameter parameter, Objective asked) {
    return parameter == Parameter::ToolChange ? asked : Objective::Cost;
}

CostLine edgeLine(const PathTotals& totals, const ToolAssembly& tool, const Machine& machine,
                  Parameter parameter, Objective objective) {
    // Eq. 12 and 13 are linear in each parameter: the line is the cost at 0 and the cost that one unit adds.
    CostLine line;
    Machine at = machine;
    switch (parameter) {
        case Parameter::ToolChange:
            at.tool_change_s = 0;
            line.fixed = weightOf(edgeCost(totals, tool, at), objective);
            at.tool_change_s = 1;
            line.per_unit = weightOf(edgeCost({}, tool, at), objective);
            break;
        case Parameter::HourlyRate:
            line.fixed = weightOf(edgeCost(totals, tool, withRate(machine, 0)), objective);
            line.per_unit =
                weightOf(edgeCost(totals, withPrice(tool, 0), withRate(machine, 1)), Objective::Cost);
            break;
        case Parameter::ToolPrice:
            line.fixed = weightOf(edgeCost(totals, withPrice(tool, 0), machine), objective);
            line.per_unit = weightOf(edgeCost(totals, tool, withRate(machine, 0)), Objective::Cost);
            break;
    }
    line.tools = {tool.id};
    return line;
}

CheapestAt cheapestOverEdges(const std::vector<DagEdge>& edges, const ToolLibrary& library,
                             const Machine& machine, Parameter parameter, Objective objective) {
    const auto lines = std::make_shared<const EdgeLines>(edges, library, machine, parameter,
                                                         objectiveFor(parameter, objective));
    return [lines](double value) { return lines->cheapestAt(value); };
}

CheapestAt cheapestBySequencing(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                                const SequenceOptions& options, const Tolerances& tol, Parameter parameter) {
    const Objective objective = objectiveFor(parameter, options.objective);
    return [&feature, &library, &machine, &tol, options, parameter, objective](double value) {
        const Shop own{library, machine, objective};
        const Shop shop = shopAt(value, own, parameter);
        SequenceOptions asked = options;
        asked.objective = shop.objective;
        const ToolSequence sequence = sequenceTools(feature, shop.library, shop.machine, asked, tol);
        return lineOf(sequence, own, parameter, objective);
    };
}

}  // namespace stepmill
