#pragma once

#include <string>
#include <vector>

#include "report/page/element.h"
#include "stepmill/planar/vector.h"

namespace stepmill::report {

/// One line of a chart.
struct ChartSeries {
    std::string name;          ///< in the chart's key
    std::vector<Vec2> points;  ///< by rising x
    bool is_dotted = false;    ///< with a dot at each point
};

/// An upright line across a chart with words at its top.
struct ChartRule {
    double x = 0;
    std::string words;
};

/// A chart of lines over one axis; both axes begin at zero.
struct LineChart {
    std::string label;  ///< what it shows, for those who cannot see it
    std::string x_name;
    std::string y_name;
    std::vector<ChartSeries> series;  ///< at most as many as the style sheet has colours: kMostSeries
    std::vector<ChartRule> rules;
};
inline constexpr std::size_t kMostSeries = 6;

/// The chart as an <svg> with its key below the axes' names.
/// \pre some series has a point with x and y above 0
Element lineChart(const LineChart& chart);

}  // namespace stepmill::report
