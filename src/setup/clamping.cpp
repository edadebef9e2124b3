// How the stock could be held in a setup: the first way that will do.

#include "stepmill/setup/clamping.h"

#include <algorithm>

#include <fmt/format.h>

#include "setup/ways_to_hold.h"
#include "stepmill/core/enum_words.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {

namespace {

using setup::kPlaneMm;
using setup::WayToHold;

/// Who asks for a plate rests the stock on whatever is flat.
constexpr double kAnySeatMm2 = 0.01;

/// Flat bottom that stays.
double seatArea(const StockToHold& stock, const Tolerances& tol) {
    const double bottom_mm = stock.arriving.back().bottom_z_mm;
    const Region& bottom = stock.standing.back();
    std::vector<Region> gone;
    for (const Prism& prism : stock.removed)
        if (prism.bottom_z_mm < bottom_mm + kPlaneMm) gone.push_back(prism.region);
    return area(gone.empty() ? bottom : subtract(bottom, unite(gone, tol), tol));
}

/// On a plate, where the stock has a seat for it.
WayToHold onPlate(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol) {
    const double seat_mm2 = seatArea(stock, tol);
    const double least_mm2 = wish.kind ? kAnySeatMm2 : kLeastPlateSeatMm2;
    if (seat_mm2 < least_mm2)
        return {{}, fmt::format("no plate: {:.3g} mm2 to rest on, expected {:g}", seat_mm2, least_mm2)};
    Clamping clamping;
    clamping.kind = wish.kind.value_or(HoldKind::Plate);
    clamping.text =
        fmt::format("sacrificial plate of {:.4g} mm under all of it, by tape or glue", wish.plate_mm);
    if (clamping.kind == HoldKind::Skin && setup::cutsThrough(stock)) {
        clamping.held_mm = kSkinMm;
        clamping.holds_all = true;
        clamping.text += fmt::format("; a skin of {:g} mm stays at the bottom", kSkinMm);
    }
    return {std::move(clamping), {}};
}

WayToHold heldBy(HoldKind kind, const StockToHold& stock, const HoldWish& wish, const Tolerances& tol) {
    switch (kind) {
        case HoldKind::Vise:
            return setup::inVise(stock, wish, tol);
        case HoldKind::SoftJaws:
            return setup::inSoftJaws(stock, wish, tol);
        case HoldKind::Screws:
            return setup::onScrews(stock, wish, tol);
        case HoldKind::Plate:
        case HoldKind::Skin:
            return onPlate(stock, wish, tol);
        case HoldKind::Tabs:
        case HoldKind::None:
        case HoldKind::Given:
            break;
    }
    return {};
}

/// The first that will do; else why none does. A plate is less than a vise: there it is said too.
Clamping firstOf(const std::vector<HoldKind>& kinds, const StockToHold& stock, const HoldWish& wish,
                 const Tolerances& tol) {
    std::string why_not;
    for (const HoldKind kind : kinds) {
        WayToHold way = heldBy(kind, stock, wish, tol);
        if (way.clamping) {
            if (!why_not.empty()) way.clamping->text += " (" + why_not + ")";
            return std::move(*way.clamping);
        }
        // Of soft jaws and screws nobody thought who was not told of them.
        const bool told = kinds.size() == 1 || kind == HoldKind::Vise || kind == HoldKind::Plate;
        if (told) why_not += (why_not.empty() ? "" : "; ") + way.why_not;
    }
    Clamping none;
    none.text = why_not;
    return none;
}

constexpr EnumWord<HoldKind> kHolds[] = {{HoldKind::None, "none"},     {HoldKind::Given, "given"},
                                         {HoldKind::Vise, "vise"},     {HoldKind::SoftJaws, "soft-jaws"},
                                         {HoldKind::Screws, "screws"}, {HoldKind::Plate, "plate"},
                                         {HoldKind::Skin, "skin"},     {HoldKind::Tabs, "tabs"}};

}  // namespace

bool setup::cutsThrough(const StockToHold& stock) {
    const double bottom_mm = stock.arriving.back().bottom_z_mm;
    return std::any_of(stock.removed.begin(), stock.removed.end(),
                       [&](const Prism& prism) { return prism.bottom_z_mm < bottom_mm + kPlaneMm; });
}

std::string toString(HoldKind kind) {
    return wordOf(kHolds, kind);
}

std::optional<HoldKind> anyHoldKindFrom(std::string_view word) {
    return valueOf(kHolds, word);
}

std::optional<HoldKind> holdKindFrom(std::string_view word) {
    const std::optional<HoldKind> kind = anyHoldKindFrom(word);
    return kind == HoldKind::None || kind == HoldKind::Given ? std::nullopt : kind;
}

Clamping suggestClamping(const StockToHold& stock, const HoldWish& asked, const Tolerances& tol) {
    if (stock.arriving.empty() || stock.arriving.back().region.empty()) {
        Clamping none;
        none.text = "no vise: the stock is empty at its bottom";
        return none;
    }
    HoldWish wish = asked;
    if (wish.kind == HoldKind::Tabs) wish.kind.reset();  // they ask nothing of what holds the frame
    const std::vector<HoldKind> kinds =
        wish.kind ? std::vector{*wish.kind}
                  : std::vector{HoldKind::Vise, HoldKind::SoftJaws, HoldKind::Screws, HoldKind::Plate};
    Clamping clamping = firstOf(kinds, stock, wish, tol);
    clamping.seat_mm2 = clamping.holds_all ? area(stock.standing.back()) : seatArea(stock, tol);
    if (clamping.seat_mm2 <= 0) clamping.text += "; nothing flat to rest on at the bottom";
    return clamping;
}

}  // namespace stepmill
