// What the setter must know of how setups are held.

#include "plan/holding/hold_warnings.h"

#include <algorithm>

#include <fmt/format.h>

#include "stepmill/feature/heights.h"

namespace stepmill {
namespace {

/// Room for cutters below the stock, and what fills what lies under it.
struct RoomBelow {
    double height_mm = 0;
    const char* under = "";
};

std::optional<RoomBelow> roomBelow(const Clamping& clamping, const FixtureFile& shop) {
    if (clamping.kind == HoldKind::Vise) return RoomBelow{clamping.parallels_mm, "the vise's bed"};
    if (clamping.kind == HoldKind::SoftJaws) return RoomBelow{0, "the step of the soft jaws"};
    if (clamping.isOnPlate()) return RoomBelow{shop.plate_mm, "what lies under the plate"};
    return std::nullopt;
}

void warnOfBed(const PlannedSetup& setup, const FixtureFile& shop, std::vector<Warning>& into) {
    const std::optional<RoomBelow> room = roomBelow(setup.clamping, shop);
    if (!room) return;
    const double bottom_mm = setup.setup.stock_bbox_mm.min().z();
    for (const Operation& operation : setup.operations) {
        const double below_mm = bottom_mm - lowestMm(operation);
        if (below_mm > room->height_mm + kSameHeightMm)
            into.push_back({"below-stock", operation.id,
                            fmt::format("goes {:.4g} mm below the stock and {:.4g} mm into {}", below_mm,
                                        below_mm - room->height_mm, room->under)});
    }
}

void warnOfHold(const PlannedSetup& setup, std::vector<Warning>& into) {
    if (setup.clamping.kind != HoldKind::None || setup.operations.empty()) return;
    into.push_back({"no-hold", setup.setup.id,
                    fmt::format("no way to hold it is known, and the paths keep clear of no clamp ({}): "
                                "--fixtures says how it is held, --no-setup does without",
                                setup.clamping.text)});
}

/// Jaws on walls with little between them.
void warnOfHollow(const PlannedSetup& setup, std::vector<Warning>& into) {
    const Clamping& held = setup.clamping;
    if (!held.isVise() || held.solid_share >= kLeastSolidShare || setup.operations.empty()) return;
    into.push_back(
        {"hollow-grip", setup.setup.id,
         fmt::format(
             "when all is cut {:.0f} % of what lies between the jaws is material: they "
             "bend or crush its walls; fill the gap with a block, or say how else it is held (--fixtures)",
             100 * held.solid_share)});
}

/// Tape or glue that nobody asked for may be too weak for what is cut.
void warnOfPlate(const PlannedSetup& setup, const PlanRequest& request, std::vector<Warning>& into) {
    const bool asked_for = request.hold && *request.hold != HoldKind::Tabs;
    if (setup.clamping.kind != HoldKind::Plate || asked_for || setup.operations.empty()) return;
    const Vec3 size_mm = setup.setup.stock_bbox_mm.sizes();
    const bool may_fit_vise = std::min(size_mm.x(), size_mm.y()) < request.fixtures.vise.opening_mm &&
                              request.setup.margin.bottom_mm <= 0;
    into.push_back(
        {"taped", setup.setup.id,
         fmt::format("tape or glue alone holds it on a plate, which no force of cutting is weighed "
                     "against: take less at once, or {}",
                     may_fit_vise ? "leave stock for the vise (--stock auto)"
                                  : "say which clamps hold it (--fixtures)")});
}

/// Held stock that no later setup takes.
void warnOfHeldStock(const Plan& plan, std::vector<Warning>& into) {
    for (const ReasonVolume& entry : plan.balance.residual_by_reason)
        if (entry.reason == Reason::Holding && entry.volume_mm3 >= kWorthAWarningMm3)
            into.push_back({"held-stock", plan.part.file,
                            fmt::format("{:.4g} mm3 stay where the part is held: no later setup takes them",
                                        entry.volume_mm3)});
}

}  // namespace

std::vector<Warning> holdWarnings(const Plan& plan) {
    std::vector<Warning> warnings;
    for (const PlannedSetup& setup : plan.setups) {
        warnOfHold(setup, warnings);
        warnOfHollow(setup, warnings);
        warnOfPlate(setup, plan.request, warnings);
        warnOfBed(setup, plan.request.fixtures, warnings);
    }
    warnOfHeldStock(plan, warnings);
    return warnings;
}

}  // namespace stepmill
