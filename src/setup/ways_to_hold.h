#pragma once

#include <optional>
#include <string>

#include "stepmill/setup/clamping.h"

namespace stepmill::setup {

/// Sides this near to one plane are one [mm]: a hundredth is what jaws take up.
inline constexpr double kPlaneMm = 0.01;

/// One way to hold a stock, or why it will not do.
struct WayToHold {
    std::optional<Clamping> clamping;
    std::string why_not;
};

/// Is anything cut down to the stock's bottom?
bool cutsThrough(const StockToHold& stock);

/// On two flat sides, on stock below the part, or, where it was asked for, on sides that are cut above.
WayToHold inVise(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol);
/// In jaws that are bored to the lowest outline of the stock, which is cut nowhere beside them.
WayToHold inSoftJaws(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol);
/// By screws through upright holes that the stock arrives with, into a plate.
WayToHold onScrews(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol);

/// How far the stock sticks out beside jaws whose middle is there along them, at the end where that is more.
double besideJawsMm(const StockToHold& stock, const Vise& vise, const Vec2& across, double middle_mm);
/// Is that so much that no one clamps it so, with one vise? More than twice the jaws' width.
bool holdsOneEndAlone(const Vise& vise, double beside_mm);
/// That, as the reason why a vise will not do.
std::string endsStickOut(double beside_mm);
/// Notes in `held` what sticks out by more than the jaws' width.
void askForSupport(Clamping& held, const Vise& vise, double beside_mm);

/// A jaw against the plane `out . p = offset`, its middle at `middle_mm` along it, wider on both sides and
/// thicker by `growth_mm` and higher by the clearance.
Fixture viseJaw(const Vise& vise, double growth_mm, const Vec2& out, double offset_mm, double middle_mm,
                double top_z_mm);
/// Furthest a region reaches in a direction.
double furthest(const Region& region, const Vec2& direction);
/// "x", "y", or the angle from x.
std::string directionName(const Vec2& across);

}  // namespace stepmill::setup
