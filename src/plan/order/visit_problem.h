#pragma once

#include <vector>

#include "plan/order/order_operations.h"

namespace stepmill {

/// So many operations of a feature must be done.
struct Need {
    int feature = 0;
    int operations = 0;
};

/// An operation as one visit of its tool sees it.
struct VisitOperation {
    int tool = 0;     ///< numbered from 0 on
    int feature = 0;  ///< numbered, parents before children
    int stage = 0;    ///< earlier stages come first where that takes no more visits
    std::vector<Need> needs;
};

/// A feature as its operations wait for others.
struct VisitFeature {
    int setup = 0;             ///< its operations wait for all of the setups before
    std::vector<int> parents;  ///< that its operations wait for wholly, as far as they name no need of them
};

/// The operations as a precedence problem: per feature a queue, whose operations may run when their needs are
/// met and all setups before are done.
struct VisitProblem {
    std::vector<VisitOperation> operations;  ///< with those needs alone that follow from no other
    std::vector<int> setup;                  ///< of each feature
    std::vector<std::vector<int>> in_setup;  ///< of each setup its features that have operations, ascending
    std::vector<std::vector<int>> queue;     ///< operations of each feature in their own order
    int tools = 0;

    int setupOf(int operation) const { return setup[operations[operation].feature]; }
};

/// A parent without operations does not hold its children back, but its own parents do.
/// \note  O(operations x needs x (needs + features))
VisitProblem visitProblem(std::vector<VisitOperation> operations, const std::vector<VisitFeature>& features);

/// The same for planned operations.
/// \pre every parent is one of the features, and comes before its children
VisitProblem visitProblem(const std::vector<Operation>& operations, const std::vector<Precedence>& features);

/// The operations that may run now, one of a feature at most: all are of the first setup that is not done.
/// \param done  so many operations of each feature
std::vector<int> readyOperations(const VisitProblem& problem, const std::vector<int>& done);

/// One visit: runs all the tool can do now and thereby becomes able to do. Returns what it ran.
/// \param done  becomes so many operations of each feature
std::vector<int> takeAll(const VisitProblem& problem, int tool, std::vector<int>& done);

}  // namespace stepmill
