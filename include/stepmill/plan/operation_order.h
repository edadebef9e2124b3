#pragma once

#include <string>

namespace stepmill {

/// What comes next of the operations whose turn it is, where one tool has several.
enum class OrderRule {
    Nearest,   ///< the one that begins nearest to where the tool is
    Branches,  ///< what lies below the last one, down to the bottom; then the nearest [Li2001, section 3]
    Levels,    ///< the one with the highest floor; of several the nearest
    Earlier    ///< as in the plan that this one is made after
};
std::string toString(OrderRule rule);

/// A setup's operations in the order of one rule.
struct WeighedOrder {
    OrderRule rule = OrderRule::Nearest;
    double travel_mm = 0;  ///< rapids between the operations, up and down included
};

}  // namespace stepmill
