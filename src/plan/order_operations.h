#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// What must be machined before a feature.
struct Precedence {
    std::string feature_id;
    std::vector<std::string> parents;
    int setup = 0;  ///< number of its setup; it waits for the setups before through its parents alone
    std::vector<std::string> bands_above;  ///< ids of the bands over it of the same feature, from above
};

/// The features of all setups, those of a setup after all of the setup before.
std::vector<Precedence> inSetupOrder(const std::vector<PlannedSetup>& setups);

/// How many partial orders the look-ahead keeps after each tool change.
inline constexpr std::size_t kBeamWidth = 16;

/// The tools in the order of their visits, as few as a beam search finds: each feature's operations keep
/// their order, and parents come before their children but for Operation::waits. One entry a visit, an index
/// into tools named in the order of their first appearance.
std::vector<int> toolVisits(const std::vector<Operation>& operations, const std::vector<Precedence>& features,
                            std::size_t beam_width);

/// Puts operations in an order that keeps parents before children, but for Operation::waits, and each
/// feature's own tool order, and that changes tools as rarely as a greedy look-ahead finds. Returns indices
/// into `operations`.
/// \param features  parents before children
/// \param rule  what comes next of one tool's
std::vector<int> orderOperations(const std::vector<Operation>& operations,
                                 const std::vector<Precedence>& features,
                                 OrderRule rule = OrderRule::Nearest);

/// An order of operations, and what was weighed for it in each setup.
struct ShortestOrder {
    std::vector<int> order;
    std::vector<std::vector<WeighedOrder>> weighed;  ///< by setup; the one taken first
};

/// Of each operation its place in an earlier plan's order of its setup; nothing for new ones.
using EarlierPlaces = std::vector<std::optional<std::size_t>>;

/// The same by every rule, each setup by the one with the least travel; of equals the first in OrderRule.
/// Setups with operations of an earlier plan keep its order instead: what is new comes where its tool is
/// called anyway, else where others wait for it, else last.
/// \param places  of all operations; empty: there is no earlier plan
ShortestOrder shortestOrder(const std::vector<Operation>& operations, const std::vector<Precedence>& features,
                            const EarlierPlaces& places = {});

}  // namespace stepmill
