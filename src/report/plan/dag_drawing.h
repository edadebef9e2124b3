#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "report/page/element.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill::report {

/// Edges of a tool DAG as (from, to); empty for source and sink.
using DagWay = std::set<std::pair<std::string, std::string>>;

/// The way that the sequence's steps take, its edge to the sink with it; empty without steps.
DagWay chosenWay(const ToolSequence& sequence);

/// The tool DAG of a feature: source, tools by falling diameter and sink in a row, an arc for every edge that
/// was evaluated, the way that was chosen thick and with its times. Nothing where there is no choice.
std::optional<Element> dagDrawing(const ToolSequence& sequence);

}  // namespace stepmill::report
