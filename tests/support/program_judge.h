#pragma once

#include <map>
#include <string>
#include <vector>

#include "support/canon_run.h"
#include "support/height_map.h"

namespace stepmill::test {

/// Where a motion ends, and the motion as moves from where the tool was.
Vec3 placeOf(const CanonEvent& event);
Toolpath pathOf(const Vec3& from, const CanonEvent& event);

/// What a tool of the plan may do in one operation.
struct AllowedOperation {
    int tool = 0;
    CutterProfile cutter;  ///< as the tool is: a ball cuts no flat floor
    double speed_rpm = 0;
    double feed_mm_per_min = 0;  ///< the highest, in the thinnest cut
    bool mist = false;
    bool flood = false;
};

/// What a plan says of a setup, for a judge that knows nothing of our reader and our proofs.
struct JudgedSetup {
    std::map<std::string, AllowedOperation> operations;  ///< by id
    std::array<double, 3> stock_mm{};                    ///< top at z = 0, a corner at x = y = 0
    double length_mm_per_tool = 0;  ///< the tool table has number times this as a tool's length
    double safe_z_mm = 0;           ///< nothing stands higher
    std::array<double, 3> travel_mm{};
    double glide_feed_mm_per_min = 0;  ///< straight down, faster than it cuts, a tool goes no faster
};

/// What a program leaves of the stock, over square cells.
struct StockLeft {
    std::vector<double> lowest;  ///< around each cell within what cells are uncertain by
    std::vector<double> highest;
    std::vector<double> heights;
    int rapid_hits = 0;
};

/// Cuts the stock as LinuxCNC's interpreter understands a program.
StockLeft leftBy(const std::vector<CanonEvent>& events, const JudgedSetup& setup);

/// Why a program's result is worse than that of the one it was made from, as far as this judge sees it; empty
/// when it sees nothing.
/// \param before  what the original leaves
std::string worseThan(const StockLeft& before, const std::vector<CanonEvent>& events,
                      const JudgedSetup& setup);

/// Is it the same motions with the same settings?
bool sameRun(const std::vector<CanonEvent>& one, const std::vector<CanonEvent>& other);

}  // namespace stepmill::test
