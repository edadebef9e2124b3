#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/page/words.h"
#include "stepmill/core/units.h"
#include "stepmill/report/rank.h"

namespace stepmill {
namespace {

using report::clockTime;

std::string orDash(const std::optional<double>& value) {
    return value ? fmt::format("{:.3f}", *value) : std::string("-");
}

constexpr const char* kColumns = "{:<8} {:>8} {:>11} {:>11} {:>9} {:>10} {:>8} {:>4} {:>10} {:>10} {:>12}\n";

std::string rowText(const RankedRow& row) {
    const auto digits = [](double value) { return fmt::format("{:.3f}", value); };
    const AccessRow& cutter = row.cutter;
    return fmt::format(fmt::runtime(kColumns), cutter.tool, digits(cutter.diameter_mm),
                       digits(cutter.volume_cm3), orDash(cutter.clear_volume_cm3),
                       digits(cutter.mrr_cm3_per_min), digits(row.time_min), digits(100 * row.share),
                       row.rank ? std::to_string(*row.rank) : "-", orDash(row.dvcd_min), digits(row.rdvc_min),
                       digits(row.rdvc_with_changes_min));
}

std::string setText(const Ranking& ranking, const RankedSet& set) {
    std::vector<std::string> tools;
    for (const int index : set.rows) {
        const AccessRow& cutter = ranking.rows[index].cutter;
        tools.push_back(cutter.tool.empty() ? fmt::format("{:g} mm", cutter.diameter_mm) : cutter.tool);
    }
    if (tools.empty()) return "nothing is reached";
    return fmt::format("{:.3f} min with {}", set.total_min, fmt::join(tools, " > "));
}

std::string headText(const RankReport& report) {
    std::string text = report.file;
    if (report.is_part)
        text += fmt::format(", {}, {}", report.feature.empty() ? "all features" : report.feature,
                            report.material);
    return text + fmt::format(": tool change {:g} s\n\n", report.ranking.tool_change_s);
}

std::string tableText(const Ranking& ranking) {
    std::string text = fmt::format(fmt::runtime(kColumns), "tool", "diameter", "volume", "with holder",
                                   "rate", "time", "share", "rank", "if next", "RDVC", "with changes");
    text += fmt::format(fmt::runtime(kColumns), "", "mm", "cm3", "cm3", "cm3/min", "min", "%", "", "min",
                        "min", "min");
    for (const RankedRow& row : ranking.rows)
        text += rowText(row);
    text += "\nranking        " + setText(ranking, ranking.greedy) + "\n";
    text += "shortest path  " + setText(ranking, ranking.shortest_path) + "\n";
    return text;
}

std::string toolsText(const std::vector<std::string>& tools) {
    return tools.empty() ? std::string("none fits") : fmt::format("{}", fmt::join(tools, " > "));
}

/// "up to 4.2", "4.2 to 17", "from 17", "any".
std::string rangeText(const BestSequence& range) {
    const bool first = range.from <= 0;
    const bool last = std::isinf(range.to);
    if (first && last) return "any";
    if (first) return fmt::format("up to {:.4g}", range.to);
    if (last) return fmt::format("from {:.4g}", range.from);
    return fmt::format("{:.4g} to {:.4g}", range.from, range.to);
}

std::string sensitivityText(const Sensitivity& sensitivity) {
    const bool time = sensitivity.objective == Objective::Time;
    std::string text = fmt::format("\nCheapest sequence against {} [{}], now {:g}; {} counts\n",
                                   toString(sensitivity.parameter), sensitivity.unit, sensitivity.now,
                                   time ? "time" : "cost");
    text += fmt::format("{:<8} {:<22} {:<26} {}\n", "feature", "range",
                        time ? "time [s]" : fmt::format("cost [{}]", sensitivity.currency), "tools");
    for (const FeatureSensitivity& feature : sensitivity.features) {
        if (!feature.failure.empty())
            text += fmt::format("{:<8} planning failed: {}\n", feature.feature_id, feature.failure);
        for (const BestSequence& range : feature.ranges)
            text += fmt::format("{:<8} {:<22} {:<26} {}\n", feature.feature_id, rangeText(range),
                                fmt::format("{:.4g} + {:.4g} x value", range.line.fixed, range.line.per_unit),
                                toolsText(range.line.tools));
    }
    return text;
}

/// What drills do; nothing for a part without holes.
std::string drillsText(const std::vector<DrillRow>& drills) {
    std::string text;
    for (const DrillRow& drill : drills)
        if (drill.makes + drill.makes_room_in > 0)
            text +=
                fmt::format("{:<8} {:>8.3f} {:>11.3f} {:>7} {:>10} {:>9.3f}\n", drill.tool, drill.diameter_mm,
                            drill.volume_cm3, drill.makes, drill.makes_room_in, drill.time_min);
    if (text.empty()) return text;
    return fmt::format("\n{:<8} {:>8} {:>11} {:>7} {:>10} {:>9}\n", "drill", "mm", "volume cm3", "makes",
                       "for mills", "min") +
           text;
}

std::string missingText(const std::vector<MissingTool>& missing) {
    if (missing.empty()) return {};
    std::string text = "What else the part asks for and no tool of the library gives\n";
    for (const MissingTool& tool : missing)
        text += fmt::format("  {}: {}{}{}\n", tool.tool, tool.gives,
                            tool.holes > 0 ? fmt::format(", {} holes", tool.holes) : "",
                            tool.faces > 0 ? fmt::format(", {} faces", tool.faces) : "");
    return text;
}

/// "serves 4 holes" for a hole.
std::string holesText(const Purchase& purchase) {
    return purchase.holes > 0
               ? fmt::format(", serves {} hole{}", purchase.holes, purchase.holes > 1 ? "s" : "")
               : "";
}

std::string gainText(const Purchase& purchase) {
    const double saved_min = purchase.saved_s / kSecondsPerMinute;
    if (purchase.more_mm3 > 0)
        return fmt::format("machines {:.4g} mm3 more, in {:.2f} min {}", purchase.more_mm3,
                           std::abs(saved_min), saved_min < 0 ? "more" : "less");
    return fmt::format("saves {:.2f} min", saved_min);
}

/// The tools that help more than one feature, most minutes first.
std::string sharedPurchases(const std::vector<FeaturePurchase>& purchases) {
    struct Sum {
        std::string tool;
        int features = 0;
        int holes = 0;
        double saved_s = 0;
    };
    std::vector<Sum> sums;
    for (const auto& [advice, failure] : purchases) {
        if (!advice.best) continue;
        const std::string& tool = advice.best->tool.id;
        auto sum = std::find_if(sums.begin(), sums.end(), [&](const Sum& s) { return s.tool == tool; });
        if (sum == sums.end()) sum = sums.insert(sum, {tool});
        ++sum->features;
        sum->holes += advice.best->holes;
        sum->saved_s += advice.best->saved_s;
    }
    std::erase_if(sums, [](const Sum& sum) { return sum.features < 2; });
    std::stable_sort(sums.begin(), sums.end(),
                     [](const Sum& a, const Sum& b) { return a.saved_s > b.saved_s; });
    std::string text;
    for (const Sum& sum : sums)
        text +=
            fmt::format("  {}: {:.2f} min over {} features{}\n", sum.tool, sum.saved_s / kSecondsPerMinute,
                        sum.features, sum.holes > 0 ? fmt::format(", {} holes", sum.holes) : "");
    return text.empty() ? text : "Tools that help several features, each counted by itself:\n" + text;
}

std::string purchasesText(const std::vector<FeaturePurchase>& purchases) {
    std::string text = "\nWhat to buy: for each feature the one tool beyond the library that helps most\n";
    for (const auto& [advice, failure] : purchases) {
        if (!failure.empty()) {
            text += fmt::format("{:<8} planning failed: {}\n", advice.feature_id, failure);
            continue;
        }
        text += fmt::format("{:<8} {:>8}  ", advice.feature_id, clockTime(advice.time_s));
        if (!advice.best) {
            text += fmt::format("nothing helps ({} tried)\n", advice.trials);
            continue;
        }
        const Purchase& best = *advice.best;
        text += fmt::format("{} ({}): {}{}, then {}\n", best.tool.id, best.why, gainText(best),
                            holesText(best), toolsText(best.tools));
    }
    return text + sharedPurchases(purchases);
}

}  // namespace

std::string rankText(const RankReport& report) {
    std::string text = headText(report) + tableText(report.ranking) + drillsText(report.drills);
    if (report.sensitivity) text += sensitivityText(*report.sensitivity);
    if (report.purchases) text += purchasesText(*report.purchases) + missingText(report.missing);
    return text;
}

}  // namespace stepmill
