#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/text.h"
#include "stepmill/report/rank.h"

namespace stepmill {
namespace {

constexpr double kPercent = 100;

std::string orDash(const std::optional<double>& value) {
    return value ? fmt::format("{:.3f}", *value) : std::string("-");
}

std::string rowText(const RankedRow& row) {
    return fmt::format(
        "{:<10} {:>8.3f} {:>12.3f} {:>12.3f} {:>10.3f} {:>8.3f} {:>5} {:>10} {:>10.3f} {:>12.3f}\n",
        row.cutter.tool, row.cutter.diameter_mm, row.cutter.volume_cm3, row.cutter.mrr_cm3_per_min,
        row.time_min, kPercent * row.share, row.rank ? std::to_string(*row.rank) : "-", orDash(row.dvcd_min),
        row.rdvc_min, row.rdvc_with_changes_min);
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
    std::string text =
        fmt::format("{:<10} {:>8} {:>12} {:>12} {:>10} {:>8} {:>5} {:>10} {:>10} {:>12}\n", "tool",
                    "diameter", "volume", "rate", "time", "share", "rank", "if next", "RDVC", "with changes");
    text += fmt::format("{:<10} {:>8} {:>12} {:>12} {:>10} {:>8} {:>5} {:>10} {:>10} {:>12}\n", "", "mm",
                        "cm3", "cm3/min", "min", "%", "", "min", "min", "min");
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
    for (const FeatureSensitivity& feature : sensitivity.features)
        for (const BestSequence& range : feature.ranges)
            text += fmt::format("{:<8} {:<22} {:<26} {}\n", feature.feature_id, rangeText(range),
                                fmt::format("{:.4g} + {:.4g} x value", range.line.fixed, range.line.per_unit),
                                toolsText(range.line.tools));
    return text;
}

std::string gainText(const Purchase& purchase) {
    const double saved_min = purchase.saved_s / 60;
    if (purchase.more_mm3 > 0)
        return fmt::format("machines {:.4g} mm3 more, in {:.2f} min {}", purchase.more_mm3,
                           std::abs(saved_min), saved_min < 0 ? "more" : "less");
    return fmt::format("saves {:.2f} min", saved_min);
}

std::string purchasesText(const std::vector<PurchaseAdvice>& purchases) {
    std::string text = "\nWhat to buy: for each feature the one tool beyond the library that helps most\n";
    for (const PurchaseAdvice& advice : purchases) {
        text += fmt::format("{:<8} {:>8}  ", advice.feature_id, clockTime(advice.time_s));
        if (!advice.best) {
            text += fmt::format("nothing helps ({} tried)\n", advice.trials);
            continue;
        }
        const Purchase& best = *advice.best;
        text += fmt::format("{} ({}): {}, then {}\n", best.tool.id, best.why, gainText(best),
                            toolsText(best.tools));
    }
    return text;
}

}  // namespace

std::string rankText(const RankReport& report) {
    std::string text = headText(report) + tableText(report.ranking);
    if (report.sensitivity) text += sensitivityText(*report.sensitivity);
    if (report.purchases) text += purchasesText(*report.purchases);
    return text;
}

}  // namespace stepmill
