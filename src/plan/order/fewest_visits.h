#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "plan/order/visit_problem.h"

namespace stepmill {

/// How many partial orders a search for few visits keeps after each visit.
struct VisitSearch {
    std::size_t width = 0;          ///< of the search for any order
    std::size_t proving_width = 0;  ///< of those that ask whether fewer visits do; 0: there are none
};

/// What the plan itself takes.
inline constexpr VisitSearch kPlanSearch{16, 256};

/// Tools in the order of their visits.
struct FewestVisits {
    std::vector<int> tools;
    int at_least = 0;  ///< no order has fewer; as many as the tools where these are proven the fewest
};

/// More visits than any plan has.
inline constexpr int kAnyNumberOfVisits = std::numeric_limits<int>::max();

/// No order of the operations has fewer visits. O(operations x needs x tools)
int leastVisits(const VisitProblem& problem);

/// How many visits an order takes that a search of that width finds, at most so many; nothing where it finds
/// none, or where not even the least number of visits would leave the spare ones.
std::optional<int> visitsWithin(const VisitProblem& problem, int most_visits, int spare_visits,
                                std::size_t width);

/// An order of the tools with as few visits as a search finds, each feature's operations in their order and
/// none before what it waits for.
///
/// A visit does all its tool can do: doing less never saves a visit. After every visit the search keeps those
/// partial orders that need the fewest more at the least, by chains of operations that wait for each other: a
/// tool that comes n times in one, with others between, is called n times. Of equals it prefers those that
/// keep to the stages (VisitOperation::stage). Then it is asked, from the least number on, whether fewer
/// visits do; where no partial order had to be dropped, the answer is a proof.
/// \note  O(visits x width x tools x operations)
FewestVisits fewestVisits(const VisitProblem& problem, const VisitSearch& search);

}  // namespace stepmill
