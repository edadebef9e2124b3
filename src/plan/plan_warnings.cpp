#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "plan/plan_steps.h"

namespace stepmill {
namespace {

/// Residuals smaller than this are listed, but not worth a warning [mm3].
constexpr double kWorthAWarningMm3 = 1;

void warnOfResiduals(Plan& plan, const PlannedFeature& planned) {
    for (const Residual& residual : planned.sequence.residual) {
        if (residual.volume_mm3 < kWorthAWarningMm3) continue;
        const bool nothing_done = planned.sequence.steps.empty();
        plan.warnings.push_back({nothing_done ? "no-tool" : "residual", planned.feature.id,
                                 fmt::format("{:.4g} mm3 stay: {}; needs {}", residual.volume_mm3,
                                             toString(residual.reason), residual.advice)});
    }
}

void warnOfAllowance(Plan& plan, const PlannedFeature& planned) {
    const std::string& why = planned.sequence.no_allowance;
    if (!why.empty())
        plan.warnings.push_back({"no-allowance", planned.feature.id, "finishing allowance: " + why});
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

void warnOfTravel(Plan& plan, const PlannedSetup& setup) {
    Box3 box;
    for (const Operation& operation : setup.operations) {
        if (operation.path.moves.empty()) continue;
        box.extend(operation.path.start);
        for (const Move& move : operation.path.moves) {
            box.extend(move.to);
            if (!move.arc) continue;
            // The whole circle stands for the arc: generous by less than a radius.
            const Vec2 reach = Vec2::Constant(move.arc->radius_mm);
            const Vec2 low = move.arc->centre - reach;
            const Vec2 high = move.arc->centre + reach;
            box.extend(Vec3(low.x(), low.y(), move.to.z()));
            box.extend(Vec3(high.x(), high.y(), move.to.z()));
        }
    }
    if (box.isEmpty()) return;
    const char* const axes = "XYZ";
    for (int axis = 0; axis < 3; ++axis) {
        const double travel = plan.machine.travel_mm[axis];
        const double needed = box.sizes()[axis];
        if (travel <= 0 || needed <= travel) continue;
        plan.warnings.push_back(
            {"travel", setup.setup.id,
             fmt::format("the program moves {:.4g} mm along {}, the machine travels {:.4g} mm", needed,
                         axes[axis], travel)});
    }
}

/// What is done about a program that was not proven, the strongest measure.
std::string measuresOf(const FeatureCaution& caution) {
    if (caution.dropped) return "nothing of the feature is cut";
    if (!caution.left.empty()) return "what its tools leave is named as staying";
    if (!caution.without_tools.empty())
        return fmt::format("planned without {}", fmt::join(caution.without_tools, ", "));
    return "planned with plain rapids";
}

}  // namespace

void warnOfInput(Plan& plan, const LayerStack& layers) {
    for (const std::string& remark : layers.remarks)
        plan.warnings.push_back({"section", layers.setup_id, remark});
}

void warnOfUnreachable(Plan& plan) {
    for (const ReasonVolume& entry : plan.balance.unreachable_by_reason) {
        if (entry.volume_mm3 < kWorthAWarningMm3) continue;
        plan.warnings.push_back({"unreachable", plan.part.file,
                                 fmt::format("{:.4g} mm3 are not planned in any setup: {}", entry.volume_mm3,
                                             toString(entry.reason))});
    }
}

void warnOfBooks(Plan& plan, const std::vector<SetupAccount>& accounts, const Tolerances& tol) {
    if (plan.balance.gapShare() > tol.volume_share)
        plan.warnings.push_back({"books", plan.part.file,
                                 fmt::format("the volume books miss {:.3g} % of stock minus part; {}",
                                             100 * plan.balance.gapShare(),
                                             largestGap(accounts, plan.balance.stock_minus_part_mm3, tol))});
    for (const PlannedSetup& setup : plan.setups) {
        const VolumeBalance& books = setup.balance;
        const double gap_mm3 =
            books.stock_minus_part_mm3 - books.planned_mm3 - books.residual_mm3 - books.unreachable_mm3;
        if (std::abs(gap_mm3) <= tol.volume_share * plan.balance.stock_minus_part_mm3 ||
            std::abs(gap_mm3) <= kVolumeRoundingMm3)
            continue;
        plan.warnings.push_back({"books", setup.setup.id,
                                 fmt::format("the volume books of the setup miss {:+.4g} mm3", gap_mm3)});
    }
}

void warnOfShape(Plan& plan) {
    const VolumeBalance& books = plan.balance;
    if (books.stock_minus_part_mm3 <= kVolumeRoundingMm3) return;
    const double unreachable = books.unreachable_mm3 / books.stock_minus_part_mm3;
    const int curved = curvedFaces(plan.part);
    int faces = 0;
    for (const auto& [kind, count] : plan.part.surfaces)
        faces += count;
    const bool sculpted = curved > kCurvedFaceShare * faces;
    if (unreachable <= kUnreachableShare && !sculpted) return;
    std::string axes;
    for (const PlannedSetup& setup : plan.setups)
        axes += (axes.empty() ? "" : ", ") + axisName(setup.setup.axis);
    plan.warnings.push_back(
        {"not-2.5d", plan.part.file,
         fmt::format("not a 2.5D part from {}: {:.4g} mm3 ({:.3g} % of what is to be removed) lie under "
                     "overhangs or behind walls that are not vertical, and {} of {} faces are neither flat "
                     "nor cylindrical; other setups or a 3-axis finishing pass must make these",
                     axes, books.unreachable_mm3, 100 * unreachable, curved, faces)});
}

void warnOfSetup(Plan& plan, const PlannedSetup& setup) {
    for (const PlannedFeature& planned : setup.features) {
        warnOfResiduals(plan, planned);
        warnOfAllowance(plan, planned);
    }
    warnOfSlowSteps(plan, setup);
    warnOfTravel(plan, setup);
}

void warnOfCautions(Plan& plan, const Cautions& cautions) {
    for (const auto& [feature, caution] : cautions)
        plan.warnings.push_back(
            {"proof", feature,
             fmt::format("a first program was not proven ({}); now {}", caution.why, measuresOf(caution))});
}

void warnOfMagazine(Plan& plan) {
    const int magazine = plan.machine.magazine_size;
    if (magazine <= 0 || plan.sharing.tools <= magazine) return;
    plan.warnings.push_back(
        {"magazine", plan.machine.name,
         fmt::format("{} tools are needed, the magazine holds {}", plan.sharing.tools, magazine)});
}

}  // namespace stepmill
