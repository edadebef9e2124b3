#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// What a shop may want to vary [Yao2000, Fig. 8].
enum class Parameter {
    ToolChange,  ///< seconds a tool change takes
    HourlyRate,  ///< the machine's hourly rate
    ToolPrice    ///< factor on all tools' prices; 1 is the library's
};
std::string toString(Parameter parameter);  ///< "tool-change", "hourly-rate", "tool-price"
std::optional<Parameter> parameterFrom(std::string_view word);

/// What a sequence costs as a straight line over the parameter: seconds or money, as the objective asks.
struct CostLine {
    double fixed = 0;
    double per_unit = 0;
    std::vector<std::string> tools;  ///< ids in the order of use; empty when nothing can be machined

    double at(double value) const { return fixed + per_unit * value; }
};

/// The sequence that is cheapest at this value of the parameter; at infinity one with the least `per_unit`.
using CheapestAt = std::function<CostLine(double value)>;

/// The sequence that is cheapest from one break-even value to the next.
struct BestSequence {
    double from = 0;
    double to = 0;  ///< infinite for the last
    CostLine line;
};

/// The cheapest sequence for every value of the parameter from 0 to infinity, with the values at which it
/// changes. The least of straight lines is concave and piecewise linear: where the lines that are best at the
/// two ends of a range meet, either they are still the best, and that is the break-even, or some other line
/// is lower, and splits the range. So every break-even is exact, none is missed, and `cheapest` is asked
/// about twice as often as there are pieces.
///
/// \pre `cheapest` finds the optimum over one fixed set of lines with per_unit >= 0
/// \throws what `cheapest` throws
std::vector<BestSequence> bestSequences(const CheapestAt& cheapest);

/// Money counts where the parameter is an hourly rate or a price.
Objective objectiveFor(Parameter parameter, Objective asked);

/// What one path by one tool costs as a line over the parameter, its tool change included.
CostLine edgeLine(const PathTotals& totals, const ToolAssembly& tool, const Machine& machine,
                  Parameter parameter, Objective objective);

/// The cheapest sequence over evaluated edges of a tool DAG. The edges must hold every one that may be
/// cheapest at some value: sequenceTools() leaves out those that cannot be at the machine's own
/// (ToolSequence::pruned_edges). Surrogates count with their paths and a change each. Each value costs a
/// shortest path over n tools: O(n^2).
/// \pre the edges name tools of the library
CheapestAt cheapestOverEdges(const std::vector<DagEdge>& edges, const ToolLibrary& library,
                             const Machine& machine, Parameter parameter, Objective objective);

/// The same with a feature sequenced anew at each value, so that no edge is missing: each value costs what
/// sequenceTools() does, and throws what it throws.
/// \pre all outlive the result
CheapestAt cheapestBySequencing(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                                const SequenceOptions& options, const Tolerances& tol, Parameter parameter);

}  // namespace stepmill
