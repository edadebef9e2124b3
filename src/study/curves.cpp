#include "stepmill/study/curves.h"

#include <algorithm>

namespace stepmill {

AccessCurve sumOf(const PartCurves& curves) {
    AccessCurve sum;
    std::vector<double> diameters;
    for (const FeatureCurve& feature : curves.features) {
        for (const AccessSample& sample : feature.curve.samples)
            diameters.push_back(sample.diameter_mm);
        sum.max_error_mm2 += feature.curve.max_error_mm2;
    }
    std::sort(diameters.begin(), diameters.end());
    diameters.erase(std::unique(diameters.begin(), diameters.end()), diameters.end());
    for (const double diameter : diameters) {
        AccessSample sample{diameter, 0, 0};
        for (const FeatureCurve& feature : curves.features) {
            sample.area_mm2 += feature.curve.areaAt(diameter);
            sample.volume_mm3 += feature.curve.volumeAt(diameter);
        }
        sum.samples.push_back(sample);
    }
    return sum;
}

double widestReaching(const AccessCurve& curve, double share) {
    double widest_mm = 0;
    for (const AccessSample& sample : curve.samples)
        if (sample.volume_mm3 >= share * curve.samples.front().volume_mm3) widest_mm = sample.diameter_mm;
    return widest_mm;
}

}  // namespace stepmill
