#pragma once

#include <limits>
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
    None,      ///< nothing that is known
    Given,     ///< the fixtures of the shop's file
    Vise,      ///< two jaws; what they must not lose stays (Clamping::held_mm)
    SoftJaws,  ///< two jaws of the vise that are bored to the stock's outline
    Screws,    ///< through its own holes into a plate
    Plate,     ///< a sacrificial plate under all of it, by tape or glue
    Skin,      ///< the same, and a skin at the bottom that ties all together stays
    Tabs       ///< asked for alone: tabs tie the part to a frame, which another kind holds
};
/// "none", "given", "vise", "soft-jaws", "screws", "plate", "skin", "tabs".
std::string toString(HoldKind kind);
/// The reverse, of the kinds one can ask for: all but "none" and "given"; nothing for another word.
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
    /// Material, of what lies between a vise's jaws where they hold, when all is cut; 1: all, or not asked.
    double solid_share = 1;
    double beside_mm = 0;  ///< of stock beside the jaws that needs support or a second vise; 0: none does
    /// Stock is not cut below this height over its bottom where it is held; 0: nothing is kept from cutting.
    double held_mm = 0;
    /// Is it all the stock below that height, holes apart? Else what the outside is cut from.
    bool holds_all = false;
    /// The vise's jaws, in the middle of what they hold, wider and thicker by HoldWish::growth_mm and
    /// higher by the jaw clearance, but not grown into the stock; or the heads of screws, grown.
    std::vector<Fixture> fixtures;
    /// For the setup sheet: "vise, jaws 80 mm open across x, 12 mm deep", or why none will do.
    std::string text;

    /// Two jaws hold it.
    bool isVise() const { return kind == HoldKind::Vise || kind == HoldKind::SoftJaws; }
    /// A plate lies under all of it.
    bool isOnPlate() const {
        return kind == HoldKind::Screws || kind == HoldKind::Plate || kind == HoldKind::Skin;
    }
};

/// The stock of a setup as planar slabs, from the top down, in setup coordinates, with what the setup would
/// cut of it.
struct StockToHold {
    std::vector<Prism> arriving;
    /// By slab: what stands at every height of it, or less. That is all of it where its walls are upright;
    /// jaws pass over slabs none of whose sides are, and which stand as their hull in `arriving`.
    std::vector<Region> standing;
    std::vector<Prism> removed;  ///< all the setup cuts where nothing is kept from it
    /// From where to where walls lean under sky: form cutters finish them, with their tips below.
    std::vector<Prism> leaning;
    double under_part_mm = 0;  ///< height of the stock that lies below all of the part
    /// Height over the stock's bottom above which cutters go round it, whatever they cut of it [mm].
    double round_above_mm = std::numeric_limits<double>::infinity();
};

/// Of the ground between a vise's jaws so much is material, or the walls they press on want a block between
/// them: a fork of two tines of a quarter of its width each bends, a plate with a row of holes does not.
inline constexpr double kLeastSolidShare = 0.6;

/// What the shop has, and which kind was asked for; nothing: the first of the order below that will do.
struct HoldWish {
    Vise vise;
    double plate_mm = kPlateThicknessMm;
    std::optional<HoldKind> kind;
    double growth_mm = 0;  ///< jaws and screws' heads are taken for larger by so much
};

/// How to hold it, the first of:
/// 1. The vise on two opposite, parallel, upright flat sides with nothing sticking out farther below them,
///    which the setup cuts nowhere along the jaws' height and the clearance over them, that face each other
///    over enough length and no farther apart than the vise opens. Of several pairs those between which
///    enough stands when all is cut, lower down if need be, of these the one with the largest area held, of
///    equal ones the smaller opening. The stock stands on the lowest parallels that keep the jaws clear, and
///    below leaning ground at its outside by a tip's length if the vise still holds enough so; on some where
///    anything is cut through it.
/// 2. The vise on stock below the part, which is not cut in this setup.
/// 3. Soft jaws, where the lowest outline goes up far enough and is not cut.
/// 4. Screws through two holes or more that the stock arrives with, whose heads no cutter comes near.
/// 5. A sacrificial plate, where enough of the bottom is flat and stays.
/// Otherwise the reasons why none will do; of a kind that was asked for its own. A vise that was asked for
/// may also hold the lowest part of sides that are cut above it, where the next setup could grip what this
/// one cut: the outside is cut down to over the jaws alone.
Clamping suggestClamping(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol);

}  // namespace stepmill
