#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stepmill/batch/magazine.h"
#include "stepmill/plan/plan.h"
#include "stepmill/planar/vector.h"
#include "stepmill/study/offers.h"

namespace stepmill {

/// What one tool does in the plans of a part.
struct ToolUse {
    std::string tool_id;
    double diameter_mm = 0;
    int operations = 0;
    int visits = 0;        ///< times it is changed to
    double cutting_s = 0;  ///< at its feeds
    double life_used = 0;  ///< of one cutter's life; 0 where the library gives none
};

/// What a table of many parts tells of the plan of one: of several solids their sums, and the largest size.
struct PartFigures {
    Vec3 size_mm = Vec3::Zero();
    std::string material;
    int solids = 0;
    int setups = 0;
    int features = 0;
    double time_s = 0;
    double motion_s = 0;  ///< with the machine's acceleration; 0 where that is not given
    double cost = 0;
    std::string currency;
    double lower_bound_s = 0;
    double stock_minus_part_mm3 = 0;
    double stays_mm3 = 0;
    std::string reason;          ///< what stays by reason, and what is in doubt; empty: nothing
    std::vector<ToolUse> tools;  ///< by id
    /// Every feature with the ways to machine it, in seconds or money as the plan makes least of.
    std::vector<ToolTask> tasks;
    bool tasks_in_money = false;
    std::vector<OfferWorth> offers;    ///< tools that could be bought, by id; empty where none were asked for
    std::vector<std::string> reports;  ///< pages below the job's folder
    std::string picture;               ///< path data of the visible edges; may be empty
};

/// \param report  the plan's page below the job's folder
PartFigures figuresOf(const Plan& plan, const std::string& report);

/// Adds those of another solid of the same file.
void addFigures(PartFigures& to, const PartFigures& solid);

/// A line of JSON: same figures, same bytes.
std::string figuresJson(const PartFigures& figures);
/// The reverse.
/// \throws Error(InvalidCatalog) for another text
PartFigures figuresFromJson(std::string_view text);

}  // namespace stepmill
