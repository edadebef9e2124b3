// Where the time goes: every stage of a plan, part by part, in one run (rows `plan/`), and slicing against
// the number of faces (rows `slice/`). Each plan row prints the milliseconds of a stage and its share of the
// part's total. `access` and `paths` are measured again on their own; `sequence` contains both and the
// search.

#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "stepmill/access/access.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/feature/feature.h"
#include "stepmill/plan/plan.h"
#include "stepmill/report/inspection.h"
#include "stepmill/sequence/sequence.h"
#include "support/run_program.h"

namespace stepmill {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Milliseconds per stage of one plan, in the order of the pipeline.
struct StageTimes {
    double load = 0, slice = 0, features = 0, access = 0, paths = 0, sequence = 0;

    double total() const { return load + slice + features + sequence; }
};

void timePaths(const FeatureGround& ground, const std::vector<AccessibleArea>& areas,
               const ToolLibrary& library, const Machine& machine, const std::string& material,
               const Tolerances& tol) {
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const ToolAssembly& tool = library.tools[i];
        if (areas[i].excluded || tool.isDrill()) continue;
        const DecomposedArea all = decomposedArea(ground, nullptr, areas[i]);
        const Feature& feature = ground.feature();
        ClearingTask task;
        task.free_centres = areas[i].free_centres;
        task.entries = areas[i].entries;
        task.centres = all.centres;
        task.cleared_centres = all.cleared_centres;
        task.target = feature.target;
        task.obstruction = feature.obstruction;
        task.top_z_mm = feature.top_z_mm;
        task.floor_z_mm = feature.floor_z_mm;
        task.retract_z_mm = machine.safe_height_mm;
        benchmark::DoNotOptimize(clearArea(task, tool, *tool.cuttingFor(material), machine, tol));
    }
}

StageTimes planOnce(const std::string& file, const ToolLibrary& library, const Machine& machine) {
    const Tolerances tol;
    SequenceOptions options;
    options.material = "aluminium";
    options.retract_mm = machine.safe_height_mm;
    StageTimes times;

    Clock::time_point start = Clock::now();
    const Part part = readStep(file).front();
    times.load = millisecondsSince(start);

    start = Clock::now();
    const Setup setup = chooseSetups(part, {}).front();
    const LayerStack layers = slice(setup, tol);
    times.slice = millisecondsSince(start);

    start = Clock::now();
    const FeatureSet features = recogniseFeatures(layers, tol);
    times.features = millisecondsSince(start);

    for (const Feature& feature : features.features) {
        start = Clock::now();
        const FeatureGround ground(feature, tol);
        std::vector<AccessibleArea> areas;
        for (const ToolAssembly& tool : library.tools)
            areas.push_back(accessibleArea(ground, tool, options.material));
        times.access += millisecondsSince(start);

        start = Clock::now();
        timePaths(ground, areas, library, machine, options.material, tol);
        times.paths += millisecondsSince(start);

        start = Clock::now();
        benchmark::DoNotOptimize(sequenceTools(feature, library, machine, options, tol));
        times.sequence += millisecondsSince(start);
    }
    return times;
}

void benchPart(benchmark::State& state, const std::string& file) {
    const ToolLibrary library = defaultToolLibrary();
    const Machine machine = defaultMachine();
    StageTimes times;
    for (auto _ : state)
        times = planOnce(file, library, machine);

    const std::vector<std::pair<const char*, double>> stages{
        {"load", times.load},     {"slice", times.slice}, {"features", times.features},
        {"access", times.access}, {"paths", times.paths}, {"sequence", times.sequence}};
    for (const auto& [name, milliseconds] : stages) {
        state.counters[fmt::format("{}_ms", name)] = milliseconds;
        state.counters[fmt::format("{}_share", name)] = milliseconds / times.total();
    }
}

/// Slices and recognises features of a part that is already read: the work of `stepmill inspect` besides the
/// import. Rows `slice/<part>`; to see the growth, compare `us_per_face` of small and large parts.
void benchSlice(benchmark::State& state, const std::string& file) {
    const Tolerances tol;
    const Part part = readStep(file).front();
    const Setup setup = chooseSetups(part, {}).front();
    LayerStack layers;
    double slice_ms = 0;
    double features_ms = 0;
    for (auto _ : state) {
        Clock::time_point start = Clock::now();
        layers = slice(setup, tol);
        slice_ms += millisecondsSince(start);
        start = Clock::now();
        benchmark::DoNotOptimize(recogniseFeatures(layers, tol));
        features_ms += millisecondsSince(start);
    }
    const double rounds = static_cast<double>(state.iterations());
    const double faces = static_cast<double>(part.faces.size());
    state.counters["faces"] = faces;
    state.counters["layers"] = static_cast<double>(layers.layers.size());
    state.counters["slice_ms"] = slice_ms / rounds;
    state.counters["features_ms"] = features_ms / rounds;
    state.counters["us_per_face"] = 1000 * slice_ms / rounds / faces;
}

/// All that `stepmill inspect` does after the import: every setup, features, faces, measures, books. Rows
/// `features/<part>`.
void benchInspect(benchmark::State& state, const std::string& file) {
    const Part part = readStep(file).front();
    InspectRequest request;
    request.smallest_cutter_mm = 1;
    Inspection inspection;
    for (auto _ : state)
        inspection = inspectPart(part, request, Tolerances{});
    std::size_t features = 0;
    for (const InspectedSetup& setup : inspection.setups)
        features += setup.features.size();
    state.counters["faces"] = static_cast<double>(part.faces.size());
    state.counters["setups"] = static_cast<double>(inspection.setups.size());
    state.counters["features"] = static_cast<double>(features);
}

}  // namespace
}  // namespace stepmill

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    std::vector<std::string> parts = stepmill::test::sampleParts();
    for (const std::string& part : stepmill::test::sharedParts("nist"))
        if (part.find("ctc_01_asme1_rd") != std::string::npos) parts.push_back(part);
    for (const std::string& part : parts)
        benchmark::RegisterBenchmark(("plan/" + std::filesystem::path(part).stem().string()).c_str(),
                                     [part](benchmark::State& state) { stepmill::benchPart(state, part); })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1)
            ->UseRealTime();
    std::vector<std::string> to_slice = stepmill::test::sampleParts();
    for (const char* folder : {"machined", "nist"})
        for (const std::string& part : stepmill::test::sharedParts(folder))
            to_slice.push_back(part);
    for (const std::string& part : to_slice)
        benchmark::RegisterBenchmark(("slice/" + std::filesystem::path(part).stem().string()).c_str(),
                                     [part](benchmark::State& state) { stepmill::benchSlice(state, part); })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(2)
            ->UseRealTime();
    for (const std::string& part : to_slice)
        benchmark::RegisterBenchmark(("features/" + std::filesystem::path(part).stem().string()).c_str(),
                                     [part](benchmark::State& state) { stepmill::benchInspect(state, part); })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1)
            ->UseRealTime();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
