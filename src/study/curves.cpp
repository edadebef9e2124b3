#include "stepmill/study/curves.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/parallel.h"
#include "stepmill/plan/stages.h"

namespace stepmill {
namespace {

/// Beyond this cutters are not end mills any more; open features would draw the axis out for ever [mm].
constexpr double kLargestCutterMm = 80;

std::vector<Feature> allFeatures(const Part& part, const CurvesRequest& request, const Tolerances& tol,
                                 const std::function<void(const std::string& stage, double share)>& tell) {
    std::vector<Feature> features;
    SetupWalk walk(chooseSetups(part, request.setup), request.slicing, tol);
    while (std::optional<Stage> stage = walk.next()) {
        tell("features of " + stage->setup.id, 0.1);
        walk.cut(*stage, featurePrisms(stage->found));
        for (Feature& feature : stage->found.features)
            features.push_back(std::move(feature));
    }
    return features;
}

double rangeEnd(const std::vector<FeatureGround>& grounds) {
    constexpr double kBeyond = 1.15;
    double widest_mm = 0;
    for (const FeatureGround& ground : grounds) {
        const double fits_mm = ground.widestCutterMm();
        if (std::isfinite(fits_mm)) widest_mm = std::max(widest_mm, kBeyond * fits_mm);
    }
    return widest_mm > 0 ? std::min(widest_mm, kLargestCutterMm) : kLargestCutterMm;
}

}  // namespace

PartCurves findCurves(const Part& part, const CurvesRequest& request, const Tolerances& tol,
                      const std::function<void(const std::string& stage, double share)>& progress) {
    const auto tell = [&](const std::string& stage, double share) {
        if (progress) progress(stage, share);
    };
    const std::vector<Feature> features = allFeatures(part, request, tol, tell);
    std::vector<FeatureGround> grounds;
    for (const Feature& feature : features)
        grounds.emplace_back(feature, tol);
    PartCurves curves{part.name, part.file, request.to_mm > 0 ? request.to_mm : rangeEnd(grounds), {}};
    curves.features.resize(features.size());
    tell("access curves", 0.4);
    parallelFor(features.size(), [&](std::size_t i) {
        curves.features[i] = {features[i], accessCurve(grounds[i], 0, curves.to_mm)};
    });
    return curves;
}

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
