#include "report/plan/tool_charts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/page/line_chart.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "stepmill/core/units.h"
#include "stepmill/sequence/advice/ranking.h"
#include "stepmill/sequence/advice/sensitivity.h"

namespace stepmill::report {
namespace {

Ranking rankingOf(const Plan& plan, const PlannedSetup& setup) {
    std::vector<ReachedFeature> features;
    for (const PlannedFeature& planned : setup.features)
        features.push_back({planned.feature.depth_mm(), &planned.sequence.tools});
    return rankTools(accessTable(features, plan.library, plan.machine, plan.material),
                     plan.machine.tool_change_s);
}

/// The tools of rank 0, 1, ... as places in the table.
std::vector<std::size_t> ranksOf(const Ranking& ranking) {
    std::vector<std::size_t> ranks;
    for (std::size_t i = 0; i < ranking.rows.size(); ++i)
        if (ranking.rows[i].rank) ranks.push_back(i);
    std::sort(ranks.begin(), ranks.end(),
              [&](std::size_t a, std::size_t b) { return *ranking.rows[a].rank < *ranking.rows[b].rank; });
    // Several rows may stand for one rank: the first is the tool.
    ranks.erase(std::unique(ranks.begin(), ranks.end(),
                            [&](std::size_t a, std::size_t b) {
                                return *ranking.rows[a].rank == *ranking.rows[b].rank;
                            }),
                ranks.end());
    return ranks;
}

double ownMin(const AccessRow& cutter) {
    return cutter.volume_cm3 / cutter.mrr_cm3_per_min;
}

/// Minutes with each wider cutter in front of a rank and those narrower than it [Lim2000, eq. 1].
ChartSeries clearanceCurve(const Ranking& ranking, std::size_t rank, const Measures& in, std::string name) {
    const double rank_min = ranking.rows[rank].rdvc_min;
    const AccessRow& before = ranking.rows[rank].cutter;
    ChartSeries series{std::move(name), {{in.lengthOf(before.diameter_mm), rank_min}}, true};
    for (const RankedRow& row : ranking.rows) {
        const AccessRow& wider = row.cutter;
        if (wider.diameter_mm <= before.diameter_mm || wider.volume_cm3 <= 0 ||
            wider.volume_cm3 > before.volume_cm3)
            continue;
        const double left_min = (before.volume_cm3 - wider.volume_cm3) / before.mrr_cm3_per_min;
        series.points.emplace_back(in.lengthOf(wider.diameter_mm),
                                   rank_min - ownMin(before) + left_min + ownMin(wider));
    }
    return series;
}

LineChart accessChart(const Ranking& ranking, const std::string& setup_id, const Measures& in) {
    LineChart chart{"Tool access of " + setup_id,
                    fmt::format("diameter of the cutter [{}]", in.unit()),
                    fmt::format("reached [{}]", in.volumeUnit()),
                    {},
                    {}};
    ChartSeries alone{"by the cutter alone (TAD)", {}, true};
    ChartSeries clear{"free of shank and holder", {}, true};
    for (const RankedRow& row : ranking.rows) {
        alone.points.emplace_back(in.lengthOf(row.cutter.diameter_mm),
                                  in.volumeOf(kMm3PerCm3 * row.cutter.volume_cm3));
        clear.points.emplace_back(in.lengthOf(row.cutter.diameter_mm),
                                  in.volumeOf(kMm3PerCm3 * row.cutter.clear_volume_cm3.value_or(0)));
    }
    chart.series = {std::move(alone), std::move(clear)};
    return chart;
}

LineChart clearanceChart(const Ranking& ranking, const std::string& setup_id, const Measures& in) {
    LineChart chart{"Clearance times of " + setup_id,
                    fmt::format("diameter of the wider cutter [{}]", in.unit()),
                    "minutes for all, without tool changes",
                    {},
                    {}};
    for (const std::size_t rank : ranksOf(ranking)) {
        const RankedRow& row = ranking.rows[rank];
        if (chart.series.size() == kMostSeries) break;
        const std::string name =
            fmt::format("{} rank {} ({})", *row.rank == 0 ? "DVCD: in front of" : "RDVC: in front of",
                        *row.rank, row.cutter.tool);
        ChartSeries series = clearanceCurve(ranking, rank, in, name);
        chart.rules.push_back({in.lengthOf(row.cutter.diameter_mm), fmt::format("{}", *row.rank)});
        // The last rank has no wider cutter that would help, or none at all.
        if (series.points.size() > 1) chart.series.push_back(std::move(series));
    }
    return chart;
}

Element figureOf(const LineChart& chart, const std::string& words) {
    return Element("figure", lineChart(chart), Element("figcaption", words));
}

std::string setWords(const Ranking& ranking, const RankedSet& set) {
    std::vector<std::string> tools;
    for (const int row : set.rows)
        tools.push_back(ranking.rows[row].cutter.tool);
    return fmt::format("{} ({:.2f} min)", fmt::join(tools, " > "), set.total_min);
}

std::string sequenceWords(const std::vector<std::string>& tools) {
    return tools.empty() ? "none" : fmt::format("{}", fmt::join(tools, " > "));
}

/// How far the chart of tool change times goes beyond the machine's own, and beyond the last break-even.
constexpr double kBeyondNow = 3;
constexpr double kBeyondLast = 1.3;

double chartEnd(const std::vector<BestSequence>& ranges, double now) {
    double end = std::max(1.0, kBeyondNow * now);
    for (const BestSequence& range : ranges)
        end = std::max(end, kBeyondLast * range.from);
    return end;
}

Element rangesTable(const std::vector<BestSequence>& ranges, double now) {
    Table table({numbers("from s"), numbers("to s"), "cheapest sequence"});
    for (const BestSequence& range : ranges) {
        Element& row = table.row(fixed(range.from, 1), std::isinf(range.to) ? "any" : fixed(range.to, 1),
                                 sequenceWords(range.line.tools));
        if (range.from <= now && now <= range.to) row.set("class", "chosen");
    }
    return std::move(table).element();
}

}  // namespace

std::optional<Element> toolCharts(const Plan& plan, const PlannedSetup& setup, const Measures& in) {
    const Ranking ranking = rankingOf(plan, setup);
    if (ranking.shortest_path.rows.empty()) return std::nullopt;
    Element pairs("div.pairs",
                  figureOf(accessChart(ranking, setup.setup.id, in),
                           "What each cutter reaches of all features of this setup, area times depth."));
    const LineChart clearance = clearanceChart(ranking, setup.setup.id, in);
    if (!clearance.series.empty())
        pairs.add(figureOf(
            clearance, fmt::format("By areas and removal rates alone. Ranking: {}; cheapest of all: {}, tool "
                                   "changes of {:g} s counted.",
                                   setWords(ranking, ranking.greedy),
                                   setWords(ranking, ranking.shortest_path), ranking.tool_change_s)));
    return Element("details.band",
                   Element("summary", "What each cutter reaches, and how a wider one in front pays"),
                   std::move(pairs));
}

std::optional<Element> changeTimeChart(const Plan& plan, const ToolSequence& sequence) {
    if (sequence.edges.size() < 3 || sequence.steps.empty()) return std::nullopt;
    const std::vector<BestSequence> ranges = bestSequences(
        cheapestOverEdges(sequence.edges, plan.library, plan.machine, Parameter::ToolChange, plan.objective));
    if (ranges.empty() || ranges.front().line.tools.empty()) return std::nullopt;
    const double now = plan.machine.tool_change_s;
    const double end = chartEnd(ranges, now);
    const bool time = plan.objective == Objective::Time;
    LineChart chart{"Cheapest sequence of " + sequence.feature_id + " over the tool change time",
                    "tool change [s]",
                    time ? "time [s]" : "cost [" + plan.machine.currency + "]",
                    {},
                    {}};
    ChartSeries series{"the cheapest sequence", {}, true};
    for (const BestSequence& range : ranges)
        series.points.emplace_back(range.from, range.line.at(range.from));
    series.points.emplace_back(end, ranges.back().line.at(end));
    chart.series = {std::move(series)};
    chart.rules = {{now, fmt::format("now {:g}", now)}};
    const std::string missing = sequence.pruned_edges == 0
                                    ? ""
                                    : fmt::format(
                                          " {} edges that could not pay at the machine's own time were never "
                                          "weighed and are not among them: "
                                          "stepmill rank --sensitivity tool-change weighs those too.",
                                          sequence.pruned_edges);
    return Element(
        "details", Element("summary", "From which tool change time on another sequence is cheaper"),
        Element("div.pairs", figureOf(chart, "Dots: where the cheapest sequence changes." + missing),
                rangesTable(ranges, now)));
}

}  // namespace stepmill::report
