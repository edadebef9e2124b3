// Tools and cutting data of a plan against the library it names, its machine against the machine file.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/catalog/spindle.h"
#include "stepmill/core/units.h"
#include "stepmill/record/plan_json.h"
#include "stepmill/toolpath/adaptive_cutting.h"
#include "stepmill/toolpath/path_frame.h"
#include "stepmill/verify/claim.h"

namespace stepmill {
namespace {

/// Numbers in plan.json have six decimals; two of them differ by a rounding each.
constexpr double kWritten = 2e-6;
/// Feeds and speeds come from products of such numbers.
constexpr double kFeedShare = 1e-6;

/// Looks at one tool or operation; every difference is a failure.
class Comparison {
  public:
    Comparison(std::string place, std::vector<ProofFailure>& failures)
        : place_(std::move(place)), failures_(failures) {}

    void same(const char* what, double recorded, double expected) {
        if (std::abs(recorded - expected) > kWritten) differs(what, recorded, expected);
    }

    void atMost(const char* what, double recorded, double limit) {
        if (limit > 0 && recorded > limit * (1 + kFeedShare) + kWritten) differs(what, recorded, limit);
    }

    void sameWord(const char* what, const std::string& recorded, const std::string& expected) {
        if (recorded != expected) fail(fmt::format("{} is {}, in the library {}", what, recorded, expected));
    }

    void same(const HolderCylinder& recorded, const HolderCylinder& expected, const char* what) {
        same(what, recorded.diameter_mm, expected.diameter_mm);
        same(what, recorded.bottom_mm, expected.bottom_mm);
        same(what, recorded.top_mm, expected.top_mm);
    }

    void fail(const std::string& text) { failures_.push_back({"plan.json", 0, place_, text}); }

  private:
    void differs(const char* what, double recorded, double expected) {
        fail(fmt::format("{} is {:g}, in the library {:g}", what, recorded, expected));
    }

    std::string place_;
    std::vector<ProofFailure>& failures_;
};

const ToolAssembly* toolIn(const ToolLibrary& library, const std::string& id) {
    for (const ToolAssembly& tool : library.tools)
        if (tool.id == id) return &tool;
    return nullptr;
}

bool mayStandOut(const ToolAssembly& tool, double stick_out_mm) {
    const StickOutRange range =
        tool.stick_out_range.value_or(StickOutRange{tool.stick_out_mm, tool.stick_out_mm});
    return stick_out_mm >= range.shortest_mm - kWritten && stick_out_mm <= range.longest_mm + kWritten;
}

void compareTool(const ToolAssembly& recorded, const ToolAssembly& in_library, const Machine& machine,
                 std::vector<ProofFailure>& failures) {
    Comparison compare("tool " + recorded.id, failures);
    compare.same("the number", recorded.number, in_library.number);
    compare.sameWord("the type", toString(recorded.type), toString(in_library.type));
    compare.same("the diameter", recorded.diameter_mm, in_library.diameter_mm);
    compare.same("the corner radius", recorded.corner_radius_mm, in_library.corner_radius_mm);
    compare.same("the tip diameter", recorded.tip_diameter_mm, in_library.tip_diameter_mm);
    compare.same("the included angle", recorded.included_angle_deg, in_library.included_angle_deg);
    compare.same("the point angle", recorded.point_angle_deg, in_library.point_angle_deg);
    compare.same("whether it centres itself", recorded.self_centring ? 1 : 0,
                 in_library.self_centring ? 1 : 0);
    compare.same("the lead", recorded.lead_mm, in_library.lead_mm);
    if (in_library.isTap())
        compare.sameWord("the thread", recorded.thread ? recorded.thread->name : "none",
                         in_library.thread->name);
    compare.same("the number of teeth", recorded.flutes, in_library.flutes);
    compare.sameWord("the cutter's material", toString(recorded.cutter_material),
                     toString(in_library.cutter_material));
    compare.same("the flute length", recorded.flute_length_mm, in_library.flute_length_mm);
    compare.same("the deepest plunge", recorded.max_plunge_mm, in_library.max_plunge_mm);
    if (!mayStandOut(in_library, recorded.stick_out_mm))
        return compare.fail(fmt::format("the stick-out of {:g} is not the library's", recorded.stick_out_mm));
    const ToolAssembly expected = inSpindle(setTo(in_library, recorded.stick_out_mm), machine);
    compare.same(recorded.shank, expected.shank, "the shank");
    if (recorded.holder.size() != expected.holder.size())
        return compare.fail(fmt::format("the holder has {} cylinders, in the library {}",
                                        recorded.holder.size(), expected.holder.size()));
    for (std::size_t i = 0; i < expected.holder.size(); ++i)
        compare.same(recorded.holder[i], expected.holder[i], "the holder");
}

void compareRampAngle(const RecordedOperation& operation, const CuttingData& data, Comparison& compare) {
    const double angle_deg = toolpath::rampAngleDeg(data);
    if (operation.ramp_angle_deg <= 0) return compare.fail("no ramp angle is told");
    compare.atMost("the ramp angle", operation.ramp_angle_deg, angle_deg);
}

/// A hole that is not deep is drilled in one go.
double largestStepDownMm(const RecordedOperation& operation, const CuttingData& data) {
    if (operation.tool.isSizer()) return 0;  // it goes as deep as the bore
    // Told is how far its tip is under what leans highest; it cuts a cone's height.
    if (operation.tool.isCountersink()) return 0;
    const bool one_go = operation.tool.isForHoles() && operation.depths == 1;
    return one_go ? std::max(data.step_down_mm, kOneGoDiameters * operation.tool.diameter_mm)
                  : data.step_down_mm;
}

/// No cut may be rated for more than the library's; rated it is where the plan tells what cuts ask for.
void compareRating(const RecordedOperation& operation, const ToolAssembly& in_library,
                   const CuttingData& data, const PlanRecord& record, Comparison& compare) {
    const bool told = record.cut_material && !record.machine.spindle_curve.empty();
    if (!isClearing(operation.role)) return;
    if (!operation.rating) {
        if (told) compare.fail("no rating is told");
        return;
    }
    compare.atMost("the rated step-over", operation.rating->step_over_mm, data.step_over_mm);
    compare.atMost("the rated step-down", operation.rating->step_down_mm, data.step_down_mm);
    compare.atMost("the slot step-down", operation.rating->slot_step_down_mm,
                   slotStepDownMm(in_library, data));
    compare.atMost("the rated removal", operation.rating->removal_mm3_per_min, ratedRemovalMm3PerMin(data));
}

/// What the library has for the operation; of an adaptive one for the depth that it cuts to.
std::optional<CuttingData> dataFor(const RecordedOperation& operation, const ToolAssembly& in_library,
                                   const CuttingData& data) {
    if (operation.engagement_deg <= 0) return data;
    return adaptiveCutting(in_library, data, operation.depths * operation.step_down_mm);
}

void compareCutting(const RecordedOperation& operation, const ToolAssembly& in_library,
                    const CuttingData& usual, const PlanRecord& record, std::vector<ProofFailure>& failures) {
    Comparison compare(operation.id, failures);
    const std::optional<CuttingData> found = dataFor(operation, in_library, usual);
    if (!found) return compare.fail("the library has no cutting data for constant engagement so deep");
    const CuttingData& data = *found;
    if (operation.engagement_deg > 0)
        compare.atMost("the engagement", operation.engagement_deg,
                       radToDeg(engagementRad(in_library.radius_mm(), data.step_over_mm)));
    compareRating(operation, in_library, data, record, compare);
    // A tap's feed is its pitch x speed, whatever the library rounds it to.
    const double feed =
        in_library.isTap() ? in_library.thread->pitch_mm * data.speed_rpm : data.feed_mm_per_min;
    const bool same_down = in_library.isTap() || data.plunge_feed_mm_per_min <= 0;
    const double plunge = same_down ? feed : data.plunge_feed_mm_per_min;
    compare.atMost("the feed", operation.feed_mm_per_min, feed);
    compare.atMost("the feed down", operation.plunge_feed_mm_per_min, plunge);
    compare.atMost("the speed", operation.speed_rpm, data.speed_rpm);
    // A finishing pass takes little off a wall and goes deeper for it.
    if (operation.role != Role::Finish)
        compare.atMost("the step-down", operation.step_down_mm, largestStepDownMm(operation, data));
    if (!operation.tool.isForHoles()) compareRampAngle(operation, data, compare);
    compare.sameWord("the coolant", toString(operation.coolant), toString(data.coolant));
}

}  // namespace

std::vector<ProofFailure> compareWithLibrary(const PlanRecord& record, const ToolLibrary& library) {
    std::vector<ProofFailure> failures;
    for (const auto& [id, tool] : record.tools) {
        const ToolAssembly* in_library = toolIn(library, id);
        if (in_library != nullptr)
            compareTool(tool, *in_library, record.machine, failures);
        else
            Comparison("tool " + id, failures).fail("is not in " + library.file);
    }
    for (const auto& [id, operation] : record.operations) {
        const ToolAssembly* tool = toolIn(library, operation.tool.id);
        if (tool == nullptr) continue;
        if (const CuttingData* data = tool->cuttingFor(record.material))
            compareCutting(operation, *tool, *data, record, failures);
        else
            Comparison(id, failures)
                .fail(fmt::format("{} has no cutting data for {}", tool->id, record.material));
    }
    return failures;
}

std::vector<ProofFailure> compareWithMachine(const RecordedPlan& plan, const Machine& machine) {
    const auto orNothing = [](const std::string& value) { return value.empty() ? "missing" : value; };
    std::vector<ProofFailure> failures;
    for (const MachineDifference& found : machineDifferences(plan.files.plan_json, machine))
        failures.push_back(
            {"plan.json", 0, "machine" + found.pointer,
             fmt::format("is {}, of the machine {}", orNothing(found.recorded), orNothing(found.expected))});
    return failures;
}

}  // namespace stepmill
