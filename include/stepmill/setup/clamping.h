#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/catalog/fixture.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/part/part.h"
#include "stepmill/setup/prism.h"

namespace stepmill {

/// What holds the stock in a setup [docs/algorithms/holding.md].
enum class HoldKind {
    None,   ///< nothing that is known
    Given,  ///< the fixtures of the shop's file
    Vise,   ///< two jaws; what they must not lose stays (Clamping::held_mm)
    Plate,  ///< a sacrificial plate under all of it, by tape, glue or screws
    Skin    ///< the same, and a skin at the bottom that ties all together stays
};
/// "none", "given", "vise", "plate", "skin".
std::string toString(HoldKind kind);
/// The reverse, of the kinds one can ask for: "vise", "plate", "skin"; nothing for another word.
std::optional<HoldKind> holdKindFrom(std::string_view word);
/// The same of all kinds: of a plan.json.
std::optional<HoldKind> anyHoldKindFrom(std::string_view word);

/// A skin that ties part and waste together is so thick [mm]: a knife takes it off.
inline constexpr double kSkinMm = 0.3;
/// So far below the part profiles go into stock that a later setup faces off, so that no burr stands there
/// [mm].
inline constexpr double kGripOverlapMm = 1;
/// Less of the stock's bottom that stays flat holds nothing on a plate [mm2].
inline constexpr double kLeastPlateSeatMm2 = 400;

/// How a setup's stock can be held: a suggestion, whose jaws and held stock the plan keeps clear of.
struct Clamping {
    HoldKind kind = HoldKind::None;
    /// Across the jaws, a unit vector in setup coordinates (z = 0).
    Vec3 across = Vec3::Zero();
    double opening_mm = 0;    ///< between the jaws
    double from_mm = 0;       ///< lower edge of the grip over the stock's bottom
    double depth_mm = 0;      ///< height the jaws hold, from there up
    double length_mm = 0;     ///< of jaw that touches on both sides
    double parallels_mm = 0;  ///< height of the parallels under the stock; 0: it lies on the vise's bed
    double seat_mm2 = 0;      ///< of the stock's bottom that is flat and stays: what it rests on
    /// Stock is not cut below this height over its bottom where it is held; 0: nothing is kept from cutting.
    double held_mm = 0;
    /// Is it all the stock below that height, holes apart? Else what the outside is cut from.
    bool holds_all = false;
    /// The vise's jaws, in the middle of what they hold, wider and thicker by kFixtureGrowth and higher by
    /// the jaw clearance, but not grown into the stock; empty without a vise.
    std::vector<Fixture> jaws;
    /// For the setup sheet: "vise, jaws 80 mm open across x, 12 mm deep", or why none will do.
    std::string text;

    bool isVise() const { return kind == HoldKind::Vise; }
};

/// The stock of a setup as planar slabs, from the top down, in setup coordinates, with what the setup would
/// cut of it.
struct StockToHold {
    std::vector<Prism> arriving;
    /// By slab: are all the stock's walls in it upright? Slabs whose walls lean stand as their hull: their
    /// sides are no flat sides and are passed over.
    std::vector<bool> upright;
    std::vector<Prism> removed;      ///< all the setup cuts where nothing is kept from it
    double under_part_mm = 0;        ///< height of the stock that lies below all of the part
    bool turned_over_later = false;  ///< a later setup cuts from the other side
};

/// What the shop has, and which kind was asked for; nothing: the first of the order below that will do.
struct HoldWish {
    Vise vise;
    double plate_mm = kPlateThicknessMm;
    std::optional<HoldKind> kind;
};

/// How to hold it, the first of:
/// 1. The vise on two opposite, parallel, upright flat sides with nothing sticking out farther below them,
///    which the setup cuts nowhere along the jaws' height and the clearance over them, that face each other
///    over enough length and no farther apart than the vise opens. Of several pairs the one with the largest
///    area held, of equal ones the smaller opening. The stock stands on the lowest parallels that keep the
///    jaws clear.
/// 2. The vise on stock below the part, which is not cut in this setup.
/// 3. The vise on the lowest part of the sides where a later setup cuts from the other side and can grip what
///    this one cut: the outside is cut down to over the jaws alone, the rest is the later setup's.
/// 4. A sacrificial plate, where enough of the bottom is flat and stays.
/// Otherwise the reason why none will do. A vise that was asked for is also taken as in 3 without a later
/// setup; what it holds stays then.
Clamping suggestClamping(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol);

}  // namespace stepmill
