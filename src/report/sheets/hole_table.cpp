// Equal holes of a setup.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/page/table.h"
#include "report/page/words.h"
#include "report/sheets/sheet_sections.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/feature/whole_feature.h"

namespace stepmill::report {
namespace {

/// Holes that differ less in diameter or height are equal [mm].
constexpr double kEqualMm = 1e-3;
/// A hole that ends higher than this over its floor is made in part: what a drill leaves that makes room for
/// others is less [mm].
constexpr double kMadeWholeMm = 0.2;

struct HoleWork {
    std::string way;
    int last = -1;                                           ///< place of its last operation
    double to_mm = std::numeric_limits<double>::infinity();  ///< the lowest that any ends at
    double time_s = 0;                                       ///< of all its operations, without tool changes
};

/// "drilled", "tapped M8x1.25 17.50 mm deep".
std::string workWords(const Operation& operation, const Measures& in) {
    if (operation.fit)
        return fmt::format("{} {}", operation.role == Role::Bore ? "bored" : "reamed", operation.fit->name);
    if (operation.role == Role::Spot) return "spotted";
    if (!operation.thread) return operation.role == Role::Drill ? "drilled" : "milled";
    const double depth_mm = operation.z_top_mm - operation.thread->full_to_z_mm;
    return fmt::format("tapped {} {} deep", operation.thread->thread.name, in.length(depth_mm));
}

/// Tools of the feature's operations in their order, each once, with what they do.
HoleWork workOn(const SheetSubject& subject, const PlannedSetup& setup,
                const WholeFeature<PlannedFeature>& hole) {
    const Plan& plan = subject.plan();
    std::vector<std::string> ways;
    HoleWork work;
    for (std::size_t i = 0; i < setup.operations.size(); ++i)
        for (const PlannedFeature* band : hole.bands) {
            const Operation& operation = setup.operations[i];
            if (operation.feature_id != band->feature.id) continue;
            std::string way = fmt::format("{} T{} {}", workWords(operation, subject.measures),
                                          plan.library.tool(operation.tool_id).number, operation.tool_id);
            work.time_s += operation.motionS();
            if (std::find(ways.begin(), ways.end(), way) == ways.end()) ways.push_back(std::move(way));
            work.last = static_cast<int>(i);
            if (operation.role != Role::Spot) work.to_mm = std::min(work.to_mm, operation.z_floor_mm);
        }
    work.way = ways.empty() ? "not made" : listed(ways);
    return work;
}

long rounded(double value_mm) {
    return std::lround(value_mm / kEqualMm);
}

/// "A" to "Z", then "A1" and so on.
std::string groupName(std::size_t number) {
    const std::string letter(1, static_cast<char>('A' + number % 26));
    return number < 26 ? letter : letter + std::to_string(number / 26);
}

std::string placesWords(const std::vector<Vec2>& centres, const Measures& in) {
    std::vector<std::string> places;
    places.reserve(centres.size());
    for (const Vec2& centre : centres)
        places.push_back(
            fmt::format("X\u00a0{} Y\u00a0{}", in.number(centre.x(), 3), in.number(centre.y(), 3)));
    return fmt::format("{}", fmt::join(places, "; "));
}

}  // namespace

bool HoleGroup::isMadeInPart() const {
    return last >= 0 && made_to_mm > floor_mm + kMadeWholeMm;
}

std::string HoleGroup::depthWords(const Measures& in) const {
    const std::string whole = in.number(top_mm - floor_mm) + (through ? " through" : "");
    return isMadeInPart() ? fmt::format("{} of {}", in.number(top_mm - made_to_mm), whole) : whole;
}

std::vector<HoleGroup> holeGroups(const SheetSubject& subject, const PlannedSetup& setup) {
    std::vector<HoleGroup> groups;
    std::map<std::tuple<long, long, long, long, bool, std::string>, std::size_t> known;
    for (const WholeFeature<PlannedFeature>& whole : wholeFeatures(setup.features)) {
        if (!isHole(whole.featureClass()) || whole.lowest().target.empty()) continue;
        const Feature& lowest = whole.lowest();
        const HoleWork work = workOn(subject, setup, whole);
        HoleGroup hole;
        hole.diameter_mm = 2 * holeRadiusMm(lowest);
        hole.top_mm = whole.uppermost().top_z_mm;
        hole.floor_mm = whole.lowest().floor_z_mm;
        hole.through = !hasFloor(whole.featureClass());
        hole.made_to_mm = work.last < 0 ? hole.floor_mm : std::max(hole.floor_mm, work.to_mm);
        const auto [found, is_new] =
            known.emplace(std::tuple(rounded(hole.diameter_mm), rounded(hole.top_mm), rounded(hole.floor_mm),
                                     rounded(hole.made_to_mm), hole.through, work.way),
                          groups.size());
        if (is_new) {
            hole.name = groupName(groups.size());
            hole.way = work.way;
            groups.push_back(std::move(hole));
        }
        HoleGroup& group = groups[found->second];
        const std::vector<Vec2> centres = holeCentres(lowest);
        group.centres.insert(group.centres.end(), centres.begin(), centres.end());
        group.last = std::max(group.last, work.last);
        group.time_s += work.time_s;
    }
    return groups;
}

std::optional<Element> holeTable(const SheetSubject& subject, const std::vector<HoleGroup>& groups) {
    const Measures& in = subject.measures;
    const std::string unit = in.unit();
    Table table({"group",
                 numbers("count"),
                 {"Ø " + unit, true},
                 {"Z from, to " + unit, true},
                 {"depth " + unit, true},
                 "way",
                 {"time", true},
                 {"s a hole", true},
                 "centres " + unit});
    for (const HoleGroup& hole : groups)
        table.row(Element("b", hole.name), std::to_string(hole.centres.size()),
                  in.number(hole.diameter_mm, 3),
                  fmt::format("{}, {}", in.number(hole.top_mm), in.number(hole.made_to_mm)),
                  hole.depthWords(in), hole.way, hole.last < 0 ? "-" : clockTime(hole.time_s),
                  hole.last < 0 ? "-" : fixed(hole.time_s / static_cast<double>(hole.centres.size()), 1),
                  placesWords(hole.centres, in));
    if (table.empty()) return std::nullopt;
    return titled("Holes", std::move(table).element());
}

}  // namespace stepmill::report
