#include "plan/plan_warnings.h"

#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "plan/holding/hold_warnings.h"
#include "stepmill/catalog/spindle.h"
#include "stepmill/plan/books.h"
#include "stepmill/plan/hold_stage.h"
#include "stepmill/planar/edge.h"

namespace stepmill {
namespace {

using Warnings = std::vector<Warning>;

/// What stays on the part for one kind of reason, in all features together.
struct StayingKind {
    double sum_mm3 = 0;
    int places = 0;
    const PlannedFeature* feature = nullptr;  ///< with the largest
    const Residual* largest = nullptr;
};

double staysMm3(const Residual& residual) {
    return residual.stays_mm3.value_or(residual.volume_mm3);
}

Warning warningOf(const StayingKind& kind) {
    const Residual& largest = *kind.largest;
    const bool nothing_done = kind.feature->sequence.steps.empty();
    const std::string reason = toString(largest.reason);
    const std::string text =
        kind.places == 1 ? fmt::format("{:.4g} mm3 stay: {}; needs {}", kind.sum_mm3, reason, largest.advice)
                         : fmt::format("{:.4g} mm3 stay in {} places: {}; the largest, {:.4g} mm3, needs {}",
                                       kind.sum_mm3, kind.places, reason, staysMm3(largest), largest.advice);
    return {nothing_done ? "no-tool" : "residual", kind.feature->feature.id, text, kind.places};
}

/// Of what is there on the finished part: what a later setup takes is no trouble. The largest first.
/// \param least_mm3  smaller ones are left out
std::vector<StayingKind> stayingKinds(const std::vector<PlannedSetup>& setups, double least_mm3) {
    std::map<std::pair<bool, Reason>, StayingKind> kinds;
    for (const PlannedSetup& setup : setups)
        for (const PlannedFeature& planned : setup.features)
            for (const Residual& residual : planned.sequence.residual) {
                if (staysMm3(residual) < least_mm3 || residual.reason == Reason::AsAsked) continue;
                StayingKind& kind = kinds[{planned.sequence.steps.empty(), residual.reason.kind}];
                kind.sum_mm3 += staysMm3(residual);
                ++kind.places;
                if (kind.largest != nullptr && staysMm3(*kind.largest) >= staysMm3(residual)) continue;
                kind.feature = &planned;
                kind.largest = &residual;
            }
    std::vector<StayingKind> sorted;
    for (const auto& entry : kinds)
        sorted.push_back(entry.second);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const StayingKind& a, const StayingKind& b) { return a.sum_mm3 > b.sum_mm3; });
    return sorted;
}

void warnOfResiduals(const Plan& plan, const Tolerances& tol, Warnings& into) {
    std::vector<StayingKind> kinds = stayingKinds(plan.setups, kWorthAWarningMm3);
    // A plan is not left incomplete without a word.
    if (kinds.empty() && !leavesNothing(plan.balance, plan.request.roughing.has_value(), tol))
        kinds = stayingKinds(plan.setups, kVolumeRoundingMm3);
    for (const StayingKind& kind : kinds)
        into.push_back(warningOf(kind));
}

/// What an old machine file does not say.
void warnOfDefaults(const Machine& machine, Warnings& into) {
    if (machine.by_default.empty()) return;
    into.push_back({"defaults", machine.name,
                    fmt::format("the machine's file does not say these; taken are: {}",
                                fmt::join(machine.by_default, ", "))});
}

void warnOfAllowance(const PlannedFeature& planned, Warnings& into) {
    const std::string& why = planned.sequence.no_allowance;
    if (!why.empty()) into.push_back({"no-allowance", planned.feature.id, "finishing allowance: " + why});
}

/// A part is called not 2.5D when more than this share of stock minus part is out of reach from above, ...
constexpr double kUnreachableShare = 0.1;
/// ... or when more than this share of its faces is neither flat nor a cylinder.
constexpr double kCurvedFaceShare = 0.2;

/// Faces that no vertical wall and no flat floor can be. Cylinders count as walls: where one lies on its
/// side, what it hides shows in the volumes.
int curvedFaces(const Part& part) {
    int count = 0;
    for (const auto& [kind, faces] : part.surfaces) {
        if (kind != "plane" && kind != "cylinder") count += faces;
    }
    return count;
}

/// Around all places of the path, arcs included.
Box3 boxOf(const Toolpath& path) {
    Box3 box;
    if (path.moves.empty()) return box;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const Box2 flat = edgeOf(from, move).box;
        for (const Vec2& corner : {flat.min(), flat.max()})
            for (const double z_mm : {from.z(), move.to.z()})
                box.extend(Vec3(corner.x(), corner.y(), z_mm));
        from = move.to;
    }
    return box;
}

/// Around all that the setup's programs go through.
Box3 boxOf(const PlannedSetup& setup) {
    Box3 box;
    for (const Operation& operation : setup.operations)
        box.extend(boxOf(operation.path));
    return box;
}

void warnOfTravel(const Machine& machine, const PlannedSetup& setup, const Box3& box, Warnings& into) {
    const char* const axes = "XYZ";
    for (int axis = 0; axis < 3; ++axis) {
        const double travel = machine.travel_mm[axis];
        const double needed = box.sizes()[axis];
        if (travel <= 0 || needed <= travel) continue;
        into.push_back({"travel", setup.setup.id,
                        fmt::format("no program is written: it would move {:.4g} mm along {}, the machine "
                                    "travels {:.4g} mm",
                                    needed, axes[axis], travel)});
    }
}

/// From the tip of an operation's tool to the gauge line. The plan's tools stand in the spindle: their last
/// cylinders are its nose.
double toGaugeLineMm(const Plan& plan, const Operation& operation) {
    const double nose_mm = plan.machine.spindle_nose.empty() ? 0 : plan.machine.spindle_nose.back().top_mm;
    return gaugeLengthMm(plan.library.tool(operation.tool_id)) - nose_mm;
}

/// The tool that takes the spindle highest over the table the stock lies on, where that is too high. Vise and
/// parallels make it higher still.
void warnOfSpindleHeight(const Plan& plan, const PlannedSetup& setup, Warnings& into) {
    const double highest_mm = plan.machine.gauge_over_table_mm[1];
    const double stock_mm = setup.setup.stock_bbox_mm.sizes().z();
    double needed_mm = 0;
    std::string longest;
    for (const Operation& operation : setup.operations) {
        double top_mm = operation.path.start.z();
        for (const Move& move : operation.path.moves)
            top_mm = std::max(top_mm, move.to.z());
        const double over_mm = stock_mm + top_mm + toGaugeLineMm(plan, operation);
        if (over_mm <= needed_mm) continue;
        needed_mm = over_mm;
        longest = operation.tool_id;
    }
    if (highest_mm <= 0 || needed_mm <= highest_mm) return;
    into.push_back(
        {"travel", setup.setup.id,
         fmt::format("no program is written: {} over a stock of {:.4g} mm takes the spindle {:.4g} mm "
                     "over the table, the machine goes up to {:.4g} mm",
                     longest, stock_mm, needed_mm, highest_mm)});
}

/// A short tool over a low plate takes the spindle lower than it comes. How high a vise lifts the stock is
/// not known.
void warnOfLowSpindle(const Plan& plan, const PlannedSetup& setup, Warnings& into) {
    const double lowest_mm = plan.machine.gauge_over_table_mm[0];
    if (lowest_mm <= 0 || !setup.clamping.isOnPlate()) return;
    const double top_mm = plan.request.fixtures.plate_mm + setup.setup.stock_bbox_mm.sizes().z();
    double missing_mm = 0;
    std::string shortest;
    for (const Operation& operation : setup.operations) {
        const double over_mm = top_mm + lowestMm(operation) + toGaugeLineMm(plan, operation);
        if (lowest_mm - over_mm <= missing_mm) continue;
        missing_mm = lowest_mm - over_mm;
        shortest = operation.tool_id;
    }
    if (shortest.empty()) return;
    into.push_back({"low-spindle", setup.setup.id,
                    fmt::format("with the plate on the table {} takes the spindle {:.4g} mm lower than it "
                                "comes: put {:.0f} mm or more under the plate",
                                shortest, missing_mm, std::ceil(missing_mm))});
}

/// Stock or fixtures that would come to the machine's column behind the spindle.
void warnOfColumn(const Machine& machine, const PlannedSetup& planned, const Box3& box, Warnings& into) {
    if (machine.column_behind_mm <= 0) return;
    const Setup& setup = planned.setup;
    const double back_mm = farthestBackMm(setup.stock_bbox_mm.max().y(),
                                          growthOf(setup.stock, setup.part_to_setup), setup.fixtures);
    const double needed_mm = back_mm - box.min().y() + machine.side_clearance_mm;
    if (needed_mm <= machine.column_behind_mm) return;
    into.push_back(
        {"travel", setup.id,
         fmt::format("no program is written: stock and fixtures need {:.4g} mm behind the spindle, "
                     "the machine's column stands {:.4g} mm behind it: turn them on the table",
                     needed_mm, machine.column_behind_mm)});
}

/// What is done about a program that was not proven, the strongest measure.
std::string measuresOf(const FeatureCaution& caution) {
    if (caution.dropped) return "nothing of the feature is cut";
    if (!caution.left.empty()) return "what its tools leave is named as staying";
    if (!caution.without_tools.empty())
        return fmt::format("planned without {}", fmt::join(caution.without_tools, ", "));
    return caution.plain_ways ? "planned with plain rapids" : "planned without constant engagement";
}

void warnOfUnreachable(const Plan& plan, Warnings& into) {
    const std::size_t before = into.size();
    for (const ReasonVolume& entry : plan.balance.unreachable_by_reason) {
        if (entry.volume_mm3 < kWorthAWarningMm3) continue;
        if (plan.request.roughing && isLeftByRoughing(entry.reason)) continue;
        into.push_back({"unreachable", plan.part.file,
                        fmt::format("{:.4g} mm3 are not planned in any setup: {}", entry.volume_mm3,
                                    toString(entry.reason))});
    }
    if (into.size() == before || !plan.request.setup.axes.empty()) return;
    if (const std::size_t axes = axesNotWeighed(plan.part); axes > 0)
        into.push_back(
            {"axes-not-weighed", plan.part.file,
             fmt::format("{} directions of its faces were not weighed as tool axes, as they are too "
                         "many: holes along them stay unless --setup names them",
                         axes)});
}

void warnOfBooks(const Plan& plan, const std::string& largest_gap, const Tolerances& tol, Warnings& into) {
    if (plan.balance.gapShare() > tol.volume_share)
        into.push_back({"books", plan.part.file,
                        fmt::format("the volume books miss {:.3g} % of stock minus part; {}",
                                    100 * plan.balance.gapShare(), largest_gap)});
    for (const PlannedSetup& setup : plan.setups) {
        if (closes(setup.balance, plan.balance.stock_minus_part_mm3, tol)) continue;
        into.push_back(
            {"books", setup.setup.id,
             fmt::format("the volume books of the setup miss {:+.4g} mm3", setup.balance.gapMm3())});
    }
}

void warnOfShape(const Plan& plan, Warnings& into) {
    const VolumeBalance& books = plan.balance;
    if (plan.request.roughing || books.stock_minus_part_mm3 <= kVolumeRoundingMm3) return;
    const double unreachable = books.unreachable_mm3 / books.stock_minus_part_mm3;
    const int curved = curvedFaces(plan.part);
    int faces = 0;
    for (const auto& [kind, count] : plan.part.surfaces)
        faces += count;
    const bool sculpted = curved > kCurvedFaceShare * faces && books.unreachable_mm3 >= kWorthAWarningMm3;
    if (unreachable <= kUnreachableShare && !sculpted) return;
    std::string axes;
    for (const PlannedSetup& setup : plan.setups)
        axes += (axes.empty() ? "" : ", ") + axisName(setup.setup.axis);
    into.push_back(
        {"not-2.5d", plan.part.file,
         fmt::format("not a 2.5D part from {}: {:.4g} mm3 ({:.3g} % of what is to be removed) lie under "
                     "overhangs or behind walls that are not vertical, and {} of {} faces are neither flat "
                     "nor cylindrical; other setups or a 3-axis finishing pass must make these",
                     axes, books.unreachable_mm3, 100 * unreachable, curved, faces)});
}

/// Feeds that are held by the bending come to it but for rounding, as a share.
constexpr double kBendingRounding = 1e-6;

void warnOfDeflection(const PlannedSetup& setup, Warnings& into) {
    for (const Operation& operation : setup.operations)
        if (operation.cuts.deflection_mm > kMostDeflectionMm * (1 + kBendingRounding))
            into.push_back(
                {"deflection", operation.id,
                 fmt::format("{} bends by more than {:g} mm in its widest cuts: set it out less, or rate it "
                             "lower",
                             operation.tool_id, kMostDeflectionMm)});
}

void warnOfSetup(const Plan& plan, const PlannedSetup& setup, Warnings& into) {
    for (const PlannedFeature& planned : setup.features) {
        warnOfAllowance(planned, into);
    }
    append(into, slowSteps(setup));
    warnOfDeflection(setup, into);
    const Box3 box = boxOf(setup);
    if (box.isEmpty()) return;
    warnOfTravel(plan.machine, setup, box, into);
    warnOfSpindleHeight(plan, setup, into);
    warnOfColumn(plan.machine, setup, box, into);
    warnOfLowSpindle(plan, setup, into);
}

void warnOfMaterial(const Plan& plan, Warnings& into) {
    if (plan.request.sequence.cut_material || plan.request.materials_file.empty()) return;
    into.push_back({"material-unknown", plan.material,
                    fmt::format("{} does not say what its cuts ask for; feeds are the library's, whatever is "
                                "cut",
                                plan.request.materials_file)});
}

void warnOfCautions(const Cautions& cautions, Warnings& into) {
    for (const auto& [feature, caution] : cautions)
        into.push_back(
            {"proof", feature,
             fmt::format("a first program was not proven ({}); now {}", caution.why, measuresOf(caution))});
}

void warnOfCycleTimes(const Plan& plan, Warnings& into) {
    for (const CycleOutcome& outcome : plan.cycle.outcomes) {
        if (outcome.isMet()) continue;
        const std::string& of = outcome.target.of;
        into.push_back({"cycle-time", of.empty() ? "part" : of, missedWords(outcome)});
    }
}

void warnOfMagazine(const Plan& plan, Warnings& into) {
    const int magazine = plan.machine.magazine_size;
    if (magazine <= 0 || plan.sharing.tools <= magazine) return;
    into.push_back({"magazine", plan.machine.name,
                    fmt::format("{} tools are needed, the magazine holds {}", plan.sharing.tools, magazine)});
}

}  // namespace

void append(std::vector<Warning>& warnings, const std::vector<Warning>& more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
}

std::vector<Warning> remarksOf(const Part& part) {
    Warnings warnings;
    for (const Remark& remark : part.remarks)
        warnings.push_back({remark.code, part.file, remark.text});
    return warnings;
}

std::vector<Warning> remarksOf(const LayerStack& layers) {
    Warnings warnings;
    for (const std::string& remark : layers.remarks)
        warnings.push_back({"section", layers.setup_id, remark});
    return warnings;
}

std::vector<Warning> unusedFixtures(const FixtureFile& given, const std::vector<PlannedSetup>& setups) {
    Warnings warnings;
    for (const auto& entry : given.setups) {
        const std::string& id = entry.first;
        const bool used = std::any_of(setups.begin(), setups.end(),
                                      [&](const PlannedSetup& setup) { return setup.setup.id == id; });
        if (!used)
            warnings.push_back(
                {"fixtures-unused", id,
                 fmt::format("{} has fixtures for it; the plan has no such setup", given.file)});
    }
    return warnings;
}

std::vector<Warning> warningsOf(const Plan& plan, const std::string& largest_gap, const Tolerances& tol) {
    Warnings warnings;
    warnOfUnreachable(plan, warnings);
    append(warnings, holdWarnings(plan));
    warnOfResiduals(plan, tol, warnings);
    for (const PlannedSetup& setup : plan.setups)
        warnOfSetup(plan, setup, warnings);
    warnOfCautions(plan.request.cautions, warnings);
    warnOfCycleTimes(plan, warnings);
    warnOfMagazine(plan, warnings);
    warnOfDefaults(plan.machine, warnings);
    warnOfMaterial(plan, warnings);
    warnOfShape(plan, warnings);
    warnOfBooks(plan, largest_gap, tol, warnings);
    return warnings;
}

}  // namespace stepmill
