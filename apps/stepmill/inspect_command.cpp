#include <filesystem>

#include <fmt/core.h>
#include <oneapi/tbb/parallel_for.h>

#include "commands.h"
#include "options.h"
#include "run.h"
#include "stepmill/access/access_curve.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/report/curves.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

struct InspectOptions {
    PlanOptions part;
    bool curves = false;
    double to_mm = 0;  ///< 0: a little beyond the widest cutter that any feature holds
};

/// Beyond this cutters are not end mills any more; open features would draw the axis out for ever [mm].
constexpr double kLargestCutterMm = 80;

std::vector<Feature> allFeatures(const Part& part, const PlanOptions& options, const Tolerances& tol,
                                 ProgressLine& progress) {
    std::vector<Feature> features;
    for (const Setup& setup : chooseSetups(part, setupRequest(options))) {
        progress.show("slicing " + setup.id, 0.1);
        for (Feature& feature : recogniseFeatures(slice(setup, tol), tol).features)
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

PartCurves findCurves(const Part& part, const InspectOptions& options, const Tolerances& tol,
                      ProgressLine& progress) {
    const std::vector<Feature> features = allFeatures(part, options.part, tol, progress);
    std::vector<FeatureGround> grounds;
    for (const Feature& feature : features)
        grounds.emplace_back(feature, tol);
    PartCurves curves{part.name, part.file, options.to_mm > 0 ? options.to_mm : rangeEnd(grounds), {}};
    curves.features.resize(features.size());
    progress.show("access curves", 0.4);
    tbb::parallel_for(std::size_t{0}, features.size(), [&](std::size_t i) {
        curves.features[i] = {features[i], accessCurve(grounds[i], 0, curves.to_mm)};
    });
    return curves;
}

void makeFolder(const fs::path& folder) {
    std::error_code why;
    fs::create_directories(folder, why);
    if (why) throw Error(ErrorCode::OutputUnwritable, folder.string(), "cannot be made: " + why.message());
}

int inspectAll(const InspectOptions& options, const fs::path& out_folder, ProgressLine& progress) {
    const Tolerances tol;
    progress.show("importing " + fs::path(options.part.part_file).filename().string(), 0);
    const std::vector<Part> parts = chooseParts(options.part);
    for (const Part& part : parts) {
        const PartCurves curves = findCurves(part, options, tol, progress);
        fs::path folder = out_folder;
        if (parts.size() > 1) folder /= fmt::format("solid-{}", part.solid_index);
        progress.show("writing the curves", 1);
        makeFolder(folder);
        writeFile(folder / "curves.csv", curvesCsv(curves));
        writeFile(folder / "curves.html", curvesHtml(curves));
        fmt::print("{}: {} features, curves in {}\n", part.name, curves.features.size(),
                   (folder / "curves.html").string());
    }
    return kComplete;
}

int runInspect(const InspectOptions& options) {
    if (!options.curves)
        throw Error(ErrorCode::Usage, "stepmill inspect", "nothing asked for; --curves is what it can show");
    const fs::path folder = outputFolder(options.part, "-curves");
    return runInChild(options.part, folder,
                      [&](ProgressLine& progress) { return inspectAll(options, folder, progress); });
}

}  // namespace

void addInspectCommand(CLI::App& app, int& exit_code) {
    CLI::App* inspect = app.add_subcommand("inspect", "Show what cutters of every diameter reach of a part");
    auto options = std::make_shared<InspectOptions>();
    addPartOptions(*inspect, options->part, "-curves");
    inspect->add_flag("--curves", options->curves,
                      "write curves.csv and curves.html: accessible volume against diameter");
    inspect->add_option("--to", options->to_mm, "largest diameter [mm]; default: what still fits somewhere")
        ->check(CLI::PositiveNumber);
    inspect->footer(
        "Examples:\n"
        "  stepmill inspect bracket.step --curves\n"
        "  stepmill inspect bracket.step --curves -o curves --setup +z --to 25");
    inspect->callback([options, &exit_code] { exit_code = runInspect(*options); });
}

}  // namespace stepmill
