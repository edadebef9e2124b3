// Where the time goes: every stage of a plan, part by part, in one run (rows `plan/`), and slicing against
// the number of faces (rows `slice/`); planning against the number of tools (rows `tools/`), and the
// second-order tool DAG beside brute force (rows `dag/`). Each plan row prints the milliseconds of a stage
// and its share of the part's total. `access` and `paths` are measured again on their own; `sequence`
// contains both and the search.

#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "stepmill/access/access.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/feature/feature.h"
#include "stepmill/plan/plan.h"
#include "stepmill/report/inspection.h"
#include "stepmill/sequence/sequence.h"
#include "stepmill/sequence/tool_dag.h"
#include "support/clearing_tasks.h"
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

void timePaths(const FeatureGround& ground, const std::vector<ToolReach>& reaches, const ToolLibrary& library,
               const Machine& machine, const std::string& material, const Tolerances& tol) {
    for (std::size_t i = 0; i < reaches.size(); ++i) {
        const ToolAssembly& tool = library.tools[i];
        if (reaches[i].exclusion() || tool.isDrill()) continue;
        const DecomposedArea all = decomposedArea(ground, nullptr, reaches[i].cutter);
        const ClearingTask task = test::taskOf(ground.feature(), reaches[i].cutter, all, machine);
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
        std::vector<ToolReach> reaches;
        for (const ToolAssembly& tool : library.tools)
            reaches.push_back(toolReach(ground, tool, options.material));
        times.access += millisecondsSince(start);

        start = Clock::now();
        timePaths(ground, reaches, library, machine, options.material, tol);
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

/// The path of one cutter in the common pocket (70 x 50 x 12, corners of 6, an island of 16). Rows
/// `common_pocket/<diameter>`; `times_faster` against what FreeCAD 0.20 takes to make its own,
/// `elsewhere_ms`.
void benchCommonPocket(benchmark::State& state, double diameter_mm, double elsewhere_ms) {
    const Tolerances tol;
    Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 6);
    pocket.loops.push_back(reversed(makeCircle({35, 25}, 8).loops.front()));
    ClearingTask task = test::fullTask(pocket, test::blockAround(pocket, {}, tol), diameter_mm / 2, tol);
    task.floor_z_mm = -12;
    CuttingData cutting = test::cuttingData(diameter_mm / 2, 4);
    cutting.ramp_angle_deg = 5;
    const Machine machine = test::machineWithRapid(5000);
    double made_ms = 0;
    for (auto _ : state) {
        const Clock::time_point start = Clock::now();
        benchmark::DoNotOptimize(clearArea(task, test::flatEndMill(diameter_mm), cutting, machine, tol));
        made_ms += millisecondsSince(start);
    }
    state.counters["times_faster"] = elsewhere_ms * static_cast<double>(state.iterations()) / made_ms;
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

/// A library of that many end mills: the shop's own, thinned out, or with cutters a little smaller added.
ToolLibrary millsOf(std::size_t count) {
    std::vector<ToolAssembly> mills;
    for (const ToolAssembly& tool : defaultToolLibrary().tools)
        if (tool.type == ToolType::Flat) mills.push_back(tool);
    ToolLibrary library = defaultToolLibrary();
    library.tools.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t round = count <= mills.size() ? 0 : i / mills.size();
        ToolAssembly tool = count <= mills.size() ? mills[i * mills.size() / count] : mills[i % mills.size()];
        const double share = 1 - 0.04 * static_cast<double>(round);
        tool.diameter_mm *= share;
        for (CuttingData& data : tool.cutting)
            data.step_over_mm *= share;
        tool.id += fmt::format("#{}", round);
        tool.number = static_cast<int>(i) + 1;
        library.tools.push_back(std::move(tool));
    }
    return library;
}

/// Sequences all features of a part's first setup with that many tools. Rows `tools/<part>/<count>`; the
/// growth is the ratio of their times.
void benchTools(benchmark::State& state, const std::string& file, std::size_t count) {
    const Tolerances tol;
    const ToolLibrary library = millsOf(count);
    const Machine machine = defaultMachine();
    SequenceOptions options;
    options.material = "aluminium";
    options.retract_mm = machine.safe_height_mm;
    const Setup setup = chooseSetups(readStep(file).front(), {}).front();
    const FeatureSet features = recogniseFeatures(slice(setup, tol), tol);
    std::size_t evaluated = 0;
    std::size_t pruned = 0;
    for (auto _ : state) {
        for (const Feature& feature : features.features) {
            const ToolSequence sequence = sequenceTools(feature, library, machine, options, tol);
            for (const DagEdge& edge : sequence.edges)
                evaluated += edge.to.empty() ? 0 : 1;
            pruned += static_cast<std::size_t>(sequence.pruned_edges);
        }
    }
    const auto per_feature = static_cast<double>(features.features.size() * state.iterations());
    state.counters["features"] = static_cast<double>(features.features.size());
    state.counters["edges"] = static_cast<double>(evaluated) / per_feature;
    state.counters["pruned"] = static_cast<double>(pruned) / per_feature;
    state.counters["n(n+1)/2"] = static_cast<double>(count * (count + 1) / 2);
}

/// Random weights with savings that depend on three tools in a row.
struct RandomDag {
    explicit RandomDag(int tools) : n(tools), weights((n + 1) * n), savings((n + 1) * n * (n + 1)) {
        std::mt19937 random(7);
        for (double& weight : weights)
            weight = std::uniform_real_distribution(10.0, 100.0)(random);
        for (double& saving : savings)
            saving = std::bernoulli_distribution(0.3)(random) ? 5.0 : 0.0;
    }
    double edge(int m, int k) const { return weights[static_cast<std::size_t>((m + 1) * n + k)]; }
    double saving(int m, int k, int next) const {
        return savings[static_cast<std::size_t>(((m + 1) * n + k) * (n + 1) + next)];
    }

    int n;
    std::vector<double> weights;
    std::vector<double> savings;
};

/// The cheapest of all 2^(n-1) sequences that end with the last tool.
double bruteForce(const RandomDag& dag, double& edges) {
    double least = kNoEdge;
    for (unsigned subset = 0; subset < (1U << (dag.n - 1)); ++subset) {
        double sum = 0;
        int before = kSource;
        int last = kSource;
        for (int k = 0; k < dag.n; ++k) {
            if (k + 1 < dag.n && (subset >> k & 1U) == 0) continue;
            if (last != kSource) sum -= dag.saving(before, last, k);
            sum += dag.edge(last, k);
            edges += 1;
            before = last;
            last = k;
        }
        least = std::min(least, sum - dag.saving(before, last, dag.n));
    }
    return least;
}

/// Rows `dag/<tools>/path` and `dag/<tools>/brute`: the same optimum, and how often an edge's weight is
/// asked.
void benchDag(benchmark::State& state, int tools, bool brute) {
    const RandomDag dag(tools);
    std::vector<bool> ends(static_cast<std::size_t>(tools), false);
    ends.back() = true;
    double edges = 0;
    double cost = 0;
    for (auto _ : state) {
        edges = 0;
        if (brute) {
            cost = bruteForce(dag, edges);
        } else {
            const auto edge = [&](int m, int k) {
                edges += 1;
                return dag.edge(m, k);
            };
            const auto saving = [&](int m, int k, int next) { return dag.saving(m, k, next); };
            cost = cheapestPath(tools, edge, ends, saving).cost;
        }
    }
    state.counters["edges"] = edges;
    state.counters["cost"] = cost;
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
    for (const auto& [diameter_mm, elsewhere_ms] : {std::pair(20.0, 70.0), {12.0, 70.0}, {6.0, 130.0}})
        benchmark::RegisterBenchmark(fmt::format("common_pocket/{:.0f}", diameter_mm).c_str(),
                                     [d = diameter_mm, ms = elsewhere_ms](benchmark::State& state) {
                                         stepmill::benchCommonPocket(state, d, ms);
                                     })
            ->Unit(benchmark::kMillisecond);
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
    for (const char* name : {"nested_pockets", "bossed_pocket"})
        for (const std::string& part : stepmill::test::sampleParts())
            for (const std::size_t count : {8, 20, 40})
                if (std::filesystem::path(part).stem() == name)
                    benchmark::RegisterBenchmark(
                        fmt::format("tools/{}/{}", name, count).c_str(),
                        [part, count](benchmark::State& state) { stepmill::benchTools(state, part, count); })
                        ->Unit(benchmark::kMillisecond)
                        ->Iterations(1)
                        ->UseRealTime();
    for (const int tools : {6, 12, 18})
        for (const bool brute : {false, true})
            benchmark::RegisterBenchmark(
                fmt::format("dag/{}/{}", tools, brute ? "brute" : "path").c_str(),
                [tools, brute](benchmark::State& state) { stepmill::benchDag(state, tools, brute); })
                ->Unit(benchmark::kMicrosecond);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
