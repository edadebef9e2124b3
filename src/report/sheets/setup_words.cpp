// Datum, flip, blank and clamping of a setup, in words.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/sheets/flip.h"
#include "report/sheets/sheet_sections.h"
#include "stepmill/core/units.h"
#include "stepmill/setup/stock_growth.h"

namespace stepmill::report {
namespace {

/// A point as near to a corner of the stock's box stands for it [mm].
constexpr double kBesideCornerMm = 0.01;
constexpr double kAlongAxis = 1e-6;

Element told(const std::string& label, const std::string& text) {
    return Element("p", Element("b", label), " " + text);
}

bool isIn(const Prism& prism, const Vec3& p) {
    return p.z() <= prism.top_z_mm && p.z() >= prism.bottom_z_mm && contains(prism.region, p.head<2>());
}

/// Does the stock reach the corner of its box that is the work offset? Of a stock from a file nobody knows.
bool standsAtZero(const Setup& setup) {
    if (setup.stock.kind != Stock::Kind::Box) return false;
    const Vec3 corner(kBesideCornerMm, kBesideCornerMm, -kBesideCornerMm);
    const Vec3 in_part = setup.part_to_setup.inverse() * corner;
    if (!setup.stock.raw_bbox_mm.contains(in_part)) return false;
    for (const CutPrisms& cut : setup.stock.cuts)
        for (const Prism& prism : cut.prisms)
            if (isIn(prism, cut.part_to_setup * in_part)) return false;
    return true;
}

std::string datumWords(const Measures& in, const Setup& setup) {
    const StockGrowth growth = growthOf(setup.stock, setup.part_to_setup);
    std::string words = fmt::format(
        "G54. X0 Y0: {}. Z0: {} over what the stock rests on, its top as it arrives.",
        standsAtZero(setup)
            ? "the stock's front left corner"
            : "left of the leftmost and in front of the foremost the stock has; its corner is gone",
        in.length(setup.stock_bbox_mm.sizes().z()));
    if (growth.side_mm > 0)
        words += fmt::format(" Of a larger blank share what is too much: at most {} a side beyond X0 and Y0.",
                             in.length(growth.side_mm));
    if (growth.top_mm > 0) words += fmt::format(" A raw top may stand {} over Z0.", in.length(growth.top_mm));
    return words;
}

std::string blankWords(const Measures& in, const Setup& setup) {
    const Box3& stock = setup.stock_bbox_mm;
    const StockGrowth growth = growthOf(setup.stock, setup.part_to_setup);
    std::string words = fmt::format("{} as it arrives (X × Y × Z), ", in.size(stock.sizes()));
    if (!setup.stock.isRaw())
        words += "raw sides as they were";
    else if (setup.stock.tolerance_mm > 0)
        words += fmt::format("raw, X and Y up to {} larger, Z up to {}", in.length(2 * growth.side_mm),
                             in.length(growth.top_mm));
    else
        words += "raw, no larger";
    return fmt::format("{}; from {} to {}.", words, in.place(stock.min()), in.place(stock.max()));
}

std::string partWords(const Measures& in, const Plan& plan, const Setup& setup) {
    // A box is larger in a tilted one.
    if (!isSquare(setup))
        return fmt::format("{} as drawn; the tool's axis is {}.", in.size(plan.part.bbox_mm.sizes()),
                           tiltWords(setup));
    const Box3 part = plan.part.bbox_mm.transformed(setup.part_to_setup);
    return fmt::format("{} in it, from {} to {}.", in.size(part.sizes()), in.place(part.min()),
                       in.place(part.max()));
}

std::string acrossWords(const Vec3& across) {
    if (std::abs(across.y()) < kAlongAxis) return "X";
    if (std::abs(across.x()) < kAlongAxis) return "Y";
    return fmt::format("{:.2f}° from X", radToDeg(std::atan2(across.y(), across.x())));
}

std::string seatWords(const Measures& in, const Clamping& held) {
    return held.parallels_mm > 0
               ? fmt::format("on parallels {} high, clear of what goes through", in.length(held.parallels_mm))
               : std::string("on the vise's bed");
}

/// Where no jaw is: along them.
const char* stopSide(const Vec3& across) {
    if (std::abs(across.y()) < kAlongAxis) return "in front";
    return std::abs(across.x()) < kAlongAxis ? "at the left" : "at one end of the jaws";
}

std::string viseWords(const Measures& in, const PlannedSetup& planned) {
    const Clamping& held = planned.clamping;
    const double jaw_top_mm = planned.setup.stock_bbox_mm.min().z() + held.from_mm + held.depth_mm;
    std::string words =
        fmt::format("vise, {} open across {}, grip {} deep on {} of length, ", in.length(held.opening_mm),
                    acrossWords(held.across), in.length(held.depth_mm), in.length(held.length_mm));
    if (held.from_mm > kAlongAxis)
        words += fmt::format("from {} over the bottom up, ", in.length(held.from_mm));
    return words + fmt::format("{}; jaw tops at Z {}. Stop: {}.", seatWords(in, held), in.length(jaw_top_mm),
                               stopSide(held.across));
}

/// The setup that cuts what this one holds; null where none does.
const Setup* takerOf(const Plan& plan, const PlannedSetup& planned) {
    const auto self = std::find_if(plan.setups.begin(), plan.setups.end(),
                                   [&](const PlannedSetup& one) { return one.setup.id == planned.setup.id; });
    for (auto later = self == plan.setups.end() ? self : self + 1; later != plan.setups.end(); ++later)
        if (!isSameAxis(later->setup.axis, planned.setup.axis) && !later->operations.empty())
            return &later->setup;
    return nullptr;
}

std::string heldWords(const Measures& in, const Plan& plan, const PlannedSetup& planned) {
    const Clamping& held = planned.clamping;
    if (held.held_mm <= 0) return {};
    const Setup* taker = takerOf(plan, planned);
    return fmt::format(" {} up to Z {} is held and not cut here; {}.",
                       held.holds_all ? "All stock" : "The outside",
                       in.length(planned.setup.stock_bbox_mm.min().z() + held.held_mm),
                       taker != nullptr ? taker->id + " takes it" : "it stays");
}

std::string plateWords(const Measures& in, const Plan& plan, const PlannedSetup& planned) {
    const std::string skin = planned.clamping.held_mm > 0 ? " Cut the skin by hand." : "";
    return fmt::format(
        "sacrificial plate, {} thick, under all of it: by tape, glue, or screws where nothing is cut.{}",
        in.length(plan.request.fixtures.plate_mm), skin);
}

std::string softJawWords(const Measures& in, const PlannedSetup& planned) {
    const Clamping& held = planned.clamping;
    return fmt::format(
        "vise, soft jaws bored {} deep to the stock's outline, {} wide across {}; jaw tops at Z {}.",
        in.length(held.depth_mm), in.length(held.opening_mm), acrossWords(held.across),
        in.length(planned.setup.stock_bbox_mm.min().z() + held.depth_mm));
}

std::string screwWords(const Measures& in, const Plan& plan, const PlannedSetup& planned) {
    std::string words = fmt::format("plate, {} thick, screwed to it through its own holes:",
                                    in.length(plan.request.fixtures.plate_mm));
    for (const Fixture& fixture : planned.setup.fixtures) {
        const Vec2 at = centroid(fixture.section);
        words += fmt::format(" {} at X {} Y {}, head up to Z {};", fixture.name, in.length(at.x()),
                             in.length(at.y()), in.length(fixture.top_z_mm));
    }
    words.back() = '.';
    return words;
}

std::string fixtureWords(const Measures& in, const Plan& plan, const Setup& setup) {
    std::string words = fmt::format("as {} says:", plan.request.fixtures.file);
    std::vector<const Fixture*> highest;  // a solid's blocks have one name, the uppermost stands first
    for (const Fixture& fixture : setup.fixtures) {
        const bool is_below = std::any_of(highest.begin(), highest.end(), [&](const Fixture* other) {
            return other->name == fixture.name && other->bottom_z_mm > fixture.bottom_z_mm;
        });
        if (!is_below) highest.push_back(&fixture);
    }
    for (const Fixture* fixture : highest)
        words += fmt::format(" {} up to Z {};", fixture->name, in.length(fixture->top_z_mm));
    if (setup.fixtures.empty()) words += " nothing stands in the way;";
    words.back() = '.';
    return words;
}

std::string tabWords(const Plan& plan, const PlannedSetup& planned) {
    if (plan.request.hold != HoldKind::Tabs || planned.reserve.empty()) return {};
    return fmt::format(" {} tabs at the bottom tie the part to a frame that stays: part them afterwards.",
                       components(planned.reserve.back().region).size());
}

std::string holdWords(const Measures& in, const Plan& plan, const PlannedSetup& planned) {
    switch (planned.clamping.kind) {
        case HoldKind::Given:
            return fixtureWords(in, plan, planned.setup);
        case HoldKind::Vise:
            return viseWords(in, planned) + heldWords(in, plan, planned);
        case HoldKind::SoftJaws:
            return softJawWords(in, planned);
        case HoldKind::Screws:
            return screwWords(in, plan, planned);
        case HoldKind::Plate:
        case HoldKind::Skin:
            return plateWords(in, plan, planned) + heldWords(in, plan, planned);
        case HoldKind::Tabs:
        case HoldKind::None:
            break;
    }
    return planned.clamping.text + ". To be held otherwise: ______________________________";
}

/// What the setter has to see to beside clamping it.
std::string careWords(const Measures& in, const Clamping& held) {
    std::string words;
    if (held.beside_mm > 0)
        words += fmt::format(" {} of stock stick out beside the jaws: support it, or use a second vise.",
                             in.length(held.beside_mm));
    if (held.kind != HoldKind::None && held.kind != HoldKind::Given && held.seat_mm2 <= 0)
        words += " Nothing flat to rest on at the bottom.";
    return words;
}

std::string clampingWords(const Measures& in, const Plan& plan, const PlannedSetup& planned) {
    return holdWords(in, plan, planned) + careWords(in, planned.clamping) + tabWords(plan, planned);
}

}  // namespace

Element setupWords(const SheetSubject& subject, const PlannedSetup& planned, const Setup* before) {
    const Measures& in = subject.measures;
    const Setup& setup = planned.setup;
    Element words("div.words");
    words.add(told("Datum", datumWords(in, setup)));
    if (before != nullptr) words.add(told("Turn from " + before->id, flipWords(*before, setup)));
    words.add(told("Stock", blankWords(in, setup)), told("Part", partWords(in, subject.plan(), setup)),
              told("Hold", clampingWords(in, subject.plan(), planned)));
    return words;
}

}  // namespace stepmill::report
