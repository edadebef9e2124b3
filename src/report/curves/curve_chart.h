#pragma once

#include <string>
#include <vector>

#include "report/page/element.h"
#include "stepmill/access/access_curve.h"

namespace stepmill::report {

/// A numbered event on a chart.
struct ChartMark {
    double diameter_mm = 0;
    double volume_mm3 = 0;  ///< at the upper end of the jump, or on the curve
    double drop_mm3 = 0;
    bool is_jump = false;
    std::string label;
};

struct CurveChart {
    std::string title;   ///< what it shows, for those who cannot see it
    double width = 640;  ///< of the picture, in its own units
    double height = 300;
    double to_mm = 0;
    std::vector<AccessSample> samples;
    std::vector<ChartMark> marks;
};

/// Access volume against diameter with axes in mm and cm3 (mm3 below 1 cm3) and shares on the right,
/// as an <svg>.
Element curveChart(const CurveChart& chart);

}  // namespace stepmill::report
