#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// What must be machined before a feature.
struct Precedence {
    std::string feature_id;
    std::vector<std::string> parents;  ///< in its setup
    int setup = 0;                     ///< number of its setup; it waits for all of the setups before
    std::vector<std::string> above;    ///< ids of all it waits for in its setup, but for early starts
    bool is_profile = false;           ///< an open profile
};

/// The features of all setups, those of a setup after all of the setup before.
std::vector<Precedence> inSetupOrder(const std::vector<PlannedSetup>& setups);

/// Puts operations in an order that keeps parents before children, but for Operation::waits, and each
/// feature's own tool order, and that changes tools as rarely as fewestVisits() finds. Returns indices
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
