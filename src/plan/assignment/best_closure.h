#pragma once

#include <cstddef>
#include <vector>

namespace stepmill {

/// Something to take or leave, that can only be taken together with others.
struct Takeable {
    double gain = 0;                 ///< of taking it; negative: it costs
    std::vector<std::size_t> needs;  ///< places of those that must be taken with it
};

/// Which of them to take so that the gains add up to the most; of several such sets the smallest. Gains count
/// to a millionth of the largest.
///
/// Such a set is the source's side of a minimum cut: gains are arcs from the source, costs arcs to the sink,
/// and an arc to what is needed can never be cut. Paths that still have room are found breadth first: O(n
/// m^2) at worst, few rounds for the hundreds a part has.
std::vector<bool> bestClosure(const std::vector<Takeable>& all);

}  // namespace stepmill
