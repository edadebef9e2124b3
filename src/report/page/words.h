#pragma once

#include <string>
#include <vector>

#include "report/page/element.h"
#include "report/page/measures.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/part/part.h"
#include "stepmill/plan/plan.h"

// Numbers, times and tools as all pages and summaries print them.

namespace stepmill::report {

/// "12.50" for (12.5, 2).
std::string fixed(double value, int decimals);

/// "100.00 × 50.00 × 20.00 mm".
std::string sizeWords(const Vec3& size_mm);

/// "4:07" for minutes and seconds, "1:02:09" with hours; rounded to the second, "7.3 s" below a minute.
std::string clockTime(double seconds);

/// How often the bound goes into a time: "2.31"; "-" without a bound.
std::string timesBound(double value_s, double bound_s);

/// What books do not account for, as a share: "8.4e-05"; "0" where that is what sums of doubles round.
std::string gapWords(double share);

/// "+z, -y".
std::string axesWords(const SetupChoice& choice);

/// A name from a file, which may break anywhere where it is long: it makes no column wide.
Element breakable(const std::string& name);

/// "a, b, c".
std::string listed(const std::vector<std::string>& words);

/// "1 tool", "3 tools".
std::string counted(int count, const std::string& what);

/// "S1.F2 and 3 more".
std::string subjectWords(const Warning& warning);

/// "3" of "S1.O3", "F2" of "S1.F2": where the setup is told beside it.
std::string shortId(const std::string& id);

/// "through hole"; of a group of equal ones "6 x through hole, 5.00 mm".
std::string classWords(const WholeFeature<PlannedFeature>& feature, const Measures& in);

/// Of ground that is cut by itself whose it is: "part of F4", "F1 to F3 together"; empty of any
/// other feature.
std::string groundWords(const Feature& feature);
/// Where the holes of a group are: "X 10, Y 20; X 30, Y 20"; empty for any other feature.
std::string placesOfHoles(const WholeFeature<PlannedFeature>& feature, const Measures& in);

/// The tools of a band in order: "EM25 (+ EM10) > EM4", surrogates in brackets after the tool they help;
/// without any "left to S3" where that setup cuts the ground, else "none fits".
std::string toolWords(const ToolSequence& sequence);
/// Those of a feature: the same where it has one band, else every tool once: "EM25, EM10, EM4 in 5 bands".
std::string toolWords(const WholeFeature<PlannedFeature>& feature);

}  // namespace stepmill::report
