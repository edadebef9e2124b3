#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stepmill/core/error.h"
#include "stepmill/core/parallel.h"
#include "stepmill/plan/deep_bands.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/plan/stages.h"
#include "stepmill/plan/usable_library.h"
#include "stepmill/study/rank.h"

namespace stepmill {
namespace {

/// The features as they are, and as a plan would sequence them.
struct RankedFeatures {
    std::vector<Feature> features;
    std::vector<Feature> grown;  ///< the same on the grown stock
};

RankedFeatures allFeatures(const Part& part, const RankRequest& request, const ToolLibrary& library,
                           const Tolerances& tol, MissingTools& missing) {
    RankedFeatures found;
    SetupWalk walk(chooseSetups(part, request.setup), request.slicing, tol);
    while (const std::optional<Stage> stage = walk.next()) {
        missing.look(*stage);
        const StockGrowth growth = growthOf(stage->setup.stock, stage->setup.part_to_setup);
        for (Feature& feature : inBands(stage->found.features, library, request.sequence.material)) {
            found.grown.push_back(onGrownStock(feature, growth, tol));
            found.features.push_back(std::move(feature));
        }
        walk.cut(*stage, featurePrisms(stage->found));
    }
    return found;
}

std::vector<Feature> onlyFeature(const std::vector<Feature>& features, const std::string& id) {
    std::vector<std::string> known;
    for (const Feature& feature : features) {
        if (feature.id == id) return {feature};
        known.push_back(feature.id);
    }
    throw Error(ErrorCode::Usage, "--feature",
                known.empty() ? fmt::format("the part has no feature to machine, so no '{}'", id)
                              : fmt::format("expected one of {}; found '{}'", fmt::join(known, ", "), id));
}

double valueNow(Parameter parameter, const Machine& machine) {
    switch (parameter) {
        case Parameter::ToolChange:
            return machine.tool_change_s;
        case Parameter::HourlyRate:
            return machine.hourly_rate;
        case Parameter::ToolPrice:
            return 1;
    }
    return 0;
}

std::string unitOf(Parameter parameter, const Machine& machine) {
    switch (parameter) {
        case Parameter::ToolChange:
            return "s";
        case Parameter::HourlyRate:
            return machine.currency + "/h";
        case Parameter::ToolPrice:
            return "x library price";
    }
    return {};
}

/// Does a feature's work; what went wrong, or nothing.
std::string failureOf(const std::function<void()>& work) {
    try {
        work();
        return {};
    } catch (const std::exception& error) {
        return error.what();
    }
}

Sensitivity findSensitivity(const std::vector<Feature>& features, const RankRequest& request,
                            const ToolLibrary& library, const Machine& machine, const Tolerances& tol) {
    const SequenceOptions sequencing = asPlanned(request.sequence);
    Sensitivity result;
    result.parameter = *request.sensitivity;
    result.now = valueNow(result.parameter, machine);
    result.unit = unitOf(result.parameter, machine);
    result.objective = objectiveFor(result.parameter, request.sequence.objective);
    result.currency = machine.currency;
    result.features.resize(features.size());
    parallelFor(features.size(), [&](std::size_t i) {
        FeatureSensitivity& found = result.features[i];
        found.feature_id = features[i].id;
        found.failure = failureOf([&] {
            found.ranges = bestSequences(
                cheapestBySequencing(features[i], library, machine, sequencing, tol, result.parameter));
        });
    });
    return result;
}

}  // namespace

RankReport rankPart(const Part& part, const RankRequest& request, const ToolLibrary& all_tools,
                    const Machine& machine, const Tolerances& tol,
                    const std::function<void(const std::string& stage, double share)>& progress) {
    const auto tell = [&](const std::string& stage, double share) {
        if (progress) progress(stage, share);
    };
    const ToolLibrary library =
        usableLibrary(all_tools, request.sequence, machine, part.bbox_mm.sizes().maxCoeff()).library;
    RankReport report;
    report.is_part = true;
    report.file = part.file;
    report.feature = request.feature;
    report.material = request.sequence.material;
    const SequenceOptions sequencing = asPlanned(request.sequence);
    tell("features", 0.1);
    const HoleWishes wishes(request.holes, part, tol);
    MissingTools missing(wishes, library, request.sequence.material);
    auto [features, grown] = allFeatures(part, request, library, tol, missing);
    if (!request.feature.empty()) {
        features = onlyFeature(features, request.feature);
        grown = onlyFeature(grown, request.feature);
    }
    tell("access volumes", 0.4);
    report.ranking = rankTools(accessTable(features, library, machine, sequencing, tol),
                               request.tool_change_s.value_or(machine.tool_change_s));
    report.drills = drillTable(features, library, machine, sequencing, tol);
    if (request.sensitivity) {
        tell("sensitivity to " + toString(*request.sensitivity), 0.5);
        report.sensitivity = findSensitivity(grown, request, library, machine, tol);
    }
    if (request.purchases) {
        tell("what to buy", 0.7);
        if (request.feature.empty()) report.missing = missing.list();
        report.purchases.emplace(grown.size());
        parallelFor(report.purchases->size(), [&, &grown = grown](std::size_t i) {
            FeaturePurchase& found = (*report.purchases)[i];
            found.advice.feature_id = grown[i].id;
            found.failure =
                failureOf([&] { found.advice = whatToBuy(grown[i], library, machine, sequencing, tol); });
        });
    }
    return report;
}

}  // namespace stepmill
