// The planar kernel against GEOS and Clipper: <kernel>/<case>/<shape>, and its own growth with the number of
// edges: growth/<edges>. The other kernels know no arcs and get chords of 0.25 um. Radii are even shares of
// the widest disc's radius. `ratio_geos` and `ratio_clipper` say how many times faster Stepmill is in this
// run; a summary goes to standard error.

#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "bench/kernels.h"
#include "bench/planar_shapes.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill::bench {
namespace {

/// One row: processor seconds and area. Times are processor time of all threads, so that neither a busy
/// machine nor several threads spoil the ratios.
struct Row {
    double seconds = 0;
    double area_mm2 = 0;
    bool scaled = false;  ///< not all pairs done; the time stands for all, the area does not
};
using Rows = std::map<std::string, Row>;
using Case = std::function<Row(const Kernel&, const Region&)>;

/// Most processor time the pairs of one kernel and shape may take; beyond it the rest is extrapolated [s].
constexpr double kPairsBudgetS = 10;

Row timed(const std::function<double()>& work) {
    const double start_s = processorSeconds();
    Row row;
    row.area_mm2 = work();
    row.seconds = processorSeconds() - start_s;
    return row;
}

Row timedPairs(const Kernel& kernel, const Region& region, const std::vector<double>& radii_mm) {
    const Pairs pairs = kernel.decomposed(region, radii_mm, kPairsBudgetS);
    return {pairs.seconds, pairs.area_mm2, pairs.done < pairs.all};
}

/// `count` radii or distances up to the share of the widest disc.
std::vector<double> evenShares(const Region& region, int count, double largest_share) {
    const double widest_mm = ClearanceDiagram(region, {}).largestInscribedDisc()->radius_mm;
    std::vector<double> values;
    for (int i = 1; i <= count; ++i)
        values.push_back(widest_mm * largest_share * i / count);
    return values;
}

constexpr const char* kKernels[] = {"geos", "clipper", "stepmill"};  // what ratios divide comes first
constexpr const char* kCases[] = {"openings20", "offsets50", "rings", "decomposed190"};

std::string rowName(const std::string& kernel, const std::string& what, const std::string& shape) {
    return kernel + "/" + what + "/" + shape;
}

void measure(benchmark::State& state, const std::string& name, const std::function<Row()>& work, Rows& rows) {
    Row sum;
    try {
        for (auto _ : state) {
            const Row row = work();
            state.SetIterationTime(row.seconds);
            sum.seconds += row.seconds;
            sum.area_mm2 = row.area_mm2;
            sum.scaled = row.scaled;
        }
    } catch (const Error& error) {
        state.SkipWithError(error.what());
        return;
    }
    sum.seconds /= static_cast<double>(state.iterations());
    state.counters["area_mm2"] = sum.area_mm2;
    if (sum.scaled) state.SetLabel("time scaled up from part of the pairs");
    rows[name] = sum;
}

void addRatios(benchmark::State& state, const std::string& what, const std::string& shape, const Rows& rows) {
    const auto own = rows.find(rowName("stepmill", what, shape));
    if (own == rows.end()) return;
    for (const std::string kernel : {"geos", "clipper"}) {
        const auto other = rows.find(rowName(kernel, what, shape));
        if (other != rows.end())
            state.counters["ratio_" + kernel] = other->second.seconds / own->second.seconds;
    }
}

void registerShape(const Shape& shape, Rows& rows) {
    const std::vector<double> radii = evenShares(shape.region, 20, 0.95);
    const std::vector<double> distances = evenShares(shape.region, 50, 0.98);
    const double step_mm = radii.back() / 25;
    const std::map<std::string, Case> cases{
        {"openings20",
         [radii](const Kernel& k, const Region& r) { return timed([&] { return k.openings(r, radii); }); }},
        {"offsets50", [distances](const Kernel& k,
                                  const Region& r) { return timed([&] { return k.insets(r, distances); }); }},
        {"rings",
         [step_mm](const Kernel& k, const Region& r) { return timed([&] { return k.rings(r, step_mm); }); }},
        {"decomposed190", [radii](const Kernel& k, const Region& r) { return timedPairs(k, r, radii); }}};
    const std::map<std::string, std::shared_ptr<const Kernel>> kernels{
        {"stepmill", std::make_shared<StepmillKernel>()},
        {"geos", std::make_shared<GeosKernel>()},
        {"clipper", std::make_shared<ClipperKernel>()}};
    for (const std::string what : kCases) {
        for (const std::string kernel : kKernels) {
            const std::string name = rowName(kernel, what, shape.name);
            const auto run = [&rows, name, kernel, what, shape, work = cases.at(what),
                              used = kernels.at(kernel)](benchmark::State& state) {
                measure(
                    state, name, [&] { return work(*used, shape.region); }, rows);
                if (kernel == "stepmill") addRatios(state, what, shape.name, rows);
            };
            auto* row = benchmark::RegisterBenchmark(name.c_str(), run);
            row->Unit(benchmark::kMillisecond)->UseManualTime();
            if (kernel != "stepmill") row->Iterations(1);
        }
    }
}

/// Time per n log2 n edges shall stay level; the counter `per_nlogn` is that time.
void registerGrowth() {
    for (const int edges : {100, 316, 1000, 3162, 10000}) {
        benchmark::RegisterBenchmark(
            fmt::format("growth/{}", edges).c_str(),
            [edges](benchmark::State& state) {
                const Region region = freeForm(edges);
                for (auto _ : state)
                    benchmark::DoNotOptimize(ClearanceDiagram(region, {}).offset(-1));
                const double steps = edges * std::log2(edges);
                state.counters["per_nlogn"] = benchmark::Counter(
                    steps, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
            })
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime();
    }
}

void printSummary(const Rows& rows) {
    fmt::print(stderr, "\n{:<18}{:>10}{:>10}{:>12}{:>15}\n", "case/shape", "own ms", "x GEOS", "x Clipper",
               "area off GEOS");
    for (const std::string what : kCases) {
        for (const std::string shape : {"a", "b", "c", "d"}) {
            const auto own = rows.find(rowName("stepmill", what, shape));
            const auto geos = rows.find(rowName("geos", what, shape));
            const auto clipper = rows.find(rowName("clipper", what, shape));
            if (own == rows.end() || geos == rows.end()) continue;
            const double off_mm2 = own->second.area_mm2 - geos->second.area_mm2;
            const bool scaled = own->second.scaled || geos->second.scaled;
            fmt::print(stderr, "{:<18}{:>10.2f}{:>10.1f}{:>12}{:>15}\n", what + "/" + shape,
                       1e3 * own->second.seconds, geos->second.seconds / own->second.seconds,
                       clipper == rows.end()
                           ? "-"
                           : fmt::format("{:.0f}", clipper->second.seconds / own->second.seconds),
                       scaled ? "-" : fmt::format("{:.1e}", off_mm2 / geos->second.area_mm2));
        }
    }
}

}  // namespace
}  // namespace stepmill::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    stepmill::bench::Rows rows;
    for (const stepmill::bench::Shape& shape : stepmill::bench::planarShapes()) {
        stepmill::validate(shape.region, "shape " + shape.name);
        stepmill::bench::registerShape(shape, rows);
    }
    stepmill::bench::registerGrowth();
    benchmark::RunSpecifiedBenchmarks();
    stepmill::bench::printSummary(rows);
    return 0;
}
