#pragma once

#include <string>
#include <vector>

#include "stepmill/replan/plan_change.h"

// What the pages and texts of a plan made again say of it.

namespace stepmill::report {

/// "part: b.step instead of a.step"; none where all is as before.
std::vector<std::string> inputWords(const PlanChange& change);

/// "3 kept, 1 changed, 1 new" of features or operations.
template <typename Item>
std::string countWords(const std::vector<Item>& items) {
    std::string words;
    for (const Change change : {Change::Kept, Change::Changed, Change::New, Change::Dropped}) {
        int count = 0;
        for (const Item& item : items)
            count += item.change == change ? 1 : 0;
        if (count > 0) words += (words.empty() ? "" : ", ") + std::to_string(count) + " " + toString(change);
    }
    return words.empty() ? "none" : words;
}

/// What is another of a feature: "12.57 mm2 more and 12.57 mm2 less ground, 12 mm deep instead of 10 mm".
std::string changeWords(const FeatureChange& change);

/// "0:12 through hole by DR5, EM4L"; "-" for nothing.
std::string featureWords(const std::optional<FeatureThen>& feature);

/// "part: 4:30 asked for, takes 4:29: cuts fed up to 1.12 times as fast"; then a line for all that was tried
/// for it. Nothing where no time was asked for.
std::vector<std::string> cycleWords(const CycleTimes& times);

/// "kept, the same bytes".
std::string programWords(const ProgramChange& change);

/// "+12.0 s", "-0.40" or "the same".
std::string differenceWords(double before, double after, int decimals, const std::string& unit);

}  // namespace stepmill::report
