#pragma once

#include <string>
#include <vector>

namespace stepmill {

/// In which order parts are best made, so that few tools are put into the magazine.
struct PartOrder {
    std::vector<std::size_t> parts;  ///< places in the list, in the order they are made
    /// Those that need more tools than there are places: not in the order.
    std::vector<std::size_t> too_many;
    int loads = 0;  ///< tools put in, those of the first part included
    int bound = 0;  ///< no order puts in fewer
};

/// Orders parts by the tools they need. Parts whose tools another part needs too are made with that one; of
/// such groups all orders are tried where there are eight or fewer, else each next group is the one that
/// needs the fewest new tools, and then pairs change places while that helps. For a given order the tool
/// that is taken out is the one that is needed again last, which no other rule beats (keep the tool needed
/// soonest).
/// \param needs   of every part, ids of its tools
/// \param places  of the magazine, at least 1
PartOrder orderParts(const std::vector<std::vector<std::string>>& needs, int places);

}  // namespace stepmill
