#pragma once

#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "stepmill/planar/region.h"

namespace stepmill {

/// A loop as plan.json has it: its start, then its segments, each told from where the one before it ended.
///
///     [[0,0], [10000000,0], [-10000000,0,-5000000,0,1]]        the upper half of a disc of 10 mm
///      x y     line dx dy    arc dx dy, its centre, 1 ccw or -1 cw
///
/// All are whole nanometres, the grid's own. An arc has a sixth number, its radius, only where rounding makes
/// it another than what its end has from the centre.
nlohmann::ordered_json loopToJson(const Loop& loop);

/// Reads it back, equal to the last digit.
/// \throws Error(InvalidRegion) naming `subject` and what was expected.
Loop loopFromJson(const nlohmann::ordered_json& json, const std::string& subject);

/// Regions as two tables: every loop once, and every region once as a list of loops' numbers. Numbers run
/// from 0 in the order of first use.
class RegionTables {
  public:
    /// The region's number, the same for equal ones: with the same loops in the same order.
    std::size_t add(const Region& region);

    const nlohmann::ordered_json& loops() const { return loops_.rows; }
    const nlohmann::ordered_json& regions() const { return regions_.rows; }

  private:
    struct Table {
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        std::map<std::string, std::size_t> numbers;  // by the row's text

        std::size_t add(nlohmann::ordered_json row);
    };

    Table loops_;
    Table regions_;
};

}  // namespace stepmill
