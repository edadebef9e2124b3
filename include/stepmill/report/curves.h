#pragma once

#include <string>

#include "stepmill/study/curves.h"

namespace stepmill {

/// One line a sample and one an event, by feature, then diameter; the part's sum comes last as "part":
/// diameter_mm,feature,coverable_area_mm2,access_volume_mm3,event
/// An event names its kind and places ("neck at (40 15)"); its row holds the area just above it.
std::string curvesCsv(const PartCurves& curves);

/// Access volume against diameter, for the part and for each feature beside its drawing, events numbered and
/// marked in both: one self-contained HTML page, pictures as SVG.
std::string curvesHtml(const PartCurves& curves);

}  // namespace stepmill
