// Two jaws that hold the stock at flat sides.

#include <algorithm>

#include <fmt/format.h>

#include "setup/ways_to_hold.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill::setup {

namespace {

/// Less length than this holds nothing [mm].
constexpr double kLeastLengthMm = 5;
/// Stock that stands over the jaws by more than so many times the length they hold is a lever that tips it.
constexpr double kMostLengthsOverJaws = 10;
/// The tip of a form cutter goes so far below the ground it cuts, where the jaws can leave it room [mm].
constexpr double kTipBelowMm = 5;
/// ... which then still hold this share of the height that they could.
constexpr double kLeastHeldShare = 0.5;
/// Holds within this share are as good as each other.
constexpr double kSameHold = 1e-6;
/// Directions this near are one.
constexpr double kSameSine = 1e-4;

struct Interval {
    double from = 0;
    double to = 0;
};

/// Furthest a segment reaches in a direction.
double reachOf(const Vec2& from, const Segment& segment, const Vec2& direction) {
    double reach = std::max(direction.dot(from), direction.dot(segment.to));
    if (!segment.arc) return reach;
    const Vec2 top = segment.arc->centre + segment.arc->radius_mm * direction;
    if (distanceTo(top, from, segment) < kGridMm) reach = std::max(reach, direction.dot(top));
    return reach;
}

/// Stretches of straight side on the line `normal . p = offset`, along the line.
std::vector<Interval> sidesOn(const Region& region, const Vec2& normal, double offset_mm) {
    const Vec2 along(-normal.y(), normal.x());
    std::vector<Interval> found;
    for (const auto& [from, segment] : eachEdge(region)) {
        const bool on = std::abs(normal.dot(from) - offset_mm) < kPlaneMm &&
                        std::abs(normal.dot(segment.to) - offset_mm) < kPlaneMm;
        if (!segment.arc && on) {
            const double one = along.dot(from);
            const double other = along.dot(segment.to);
            found.push_back({std::min(one, other), std::max(one, other)});
        }
    }
    return found;
}

/// What two jaws hold of the stock.
struct Hold {
    double length_mm = 0;
    double middle_mm = 0;  ///< where the jaws' middle stands along them
    double beside_mm = 0;  ///< that sticks out beside them [besideJawsMm()]
};

/// Where both sides have material. Stretches of one side do not overlap.
std::vector<Interval> facing(const std::vector<Interval>& a, const std::vector<Interval>& b) {
    std::vector<Interval> found;
    for (const Interval& one : a)
        for (const Interval& other : b) {
            const Interval both{std::max(one.from, other.from), std::min(one.to, other.to)};
            if (both.to > both.from) found.push_back(both);
        }
    return found;
}

/// So much of the stretches lies between the jaws' ends.
double within(const std::vector<Interval>& stretches, const Interval& jaws) {
    double length_mm = 0;
    for (const Interval& stretch : stretches)
        length_mm += std::max(0.0, std::min(stretch.to, jaws.to) - std::max(stretch.from, jaws.from));
    return length_mm;
}

/// Jaws of that width where they hold most of the level at which they hold least; of equal places the one
/// nearest to the middle of what they could hold.
/// \param levels  the stretches they meet at each height
Hold longestHold(const std::vector<std::vector<Interval>>& levels, double width_mm) {
    Interval all{1e300, -1e300};
    std::vector<double> starts;  // somewhere else nothing changes but in proportion
    for (const std::vector<Interval>& stretches : levels)
        for (const Interval& stretch : stretches) {
            all = {std::min(all.from, stretch.from), std::max(all.to, stretch.to)};
            starts.insert(starts.end(), {stretch.from, stretch.to - width_mm});
        }
    const double middle_mm = (all.from + all.to) / 2;
    starts.push_back(middle_mm - width_mm / 2);
    Hold best;
    for (const double start : starts) {
        double least_mm = 1e300;
        for (const std::vector<Interval>& stretches : levels)
            least_mm = std::min(least_mm, within(stretches, {start, start + width_mm}));
        const double at = start + width_mm / 2;
        const bool longer = least_mm > best.length_mm * (1 + kSameHold);
        const bool as_long = least_mm > best.length_mm * (1 - kSameHold);
        if (longer || (as_long && std::abs(at - middle_mm) < std::abs(best.middle_mm - middle_mm)))
            best = {least_mm, at, 0};
    }
    return best;
}

/// Heights over the stock's bottom at which the jaws can end, with what the stock stands on, from the
/// highest.
struct JawTop {
    double over_bottom_mm = 0;
    double parallels_mm = 0;
};

/// \param on_bed  may the stock lie on the bed?
std::vector<JawTop> jawTops(const Vise& vise, bool on_bed) {
    std::vector<JawTop> tops;
    if (on_bed || vise.parallels_mm.empty()) tops.push_back({vise.jaw_height_mm, 0});
    for (const double parallels_mm : vise.parallels_mm)
        if (parallels_mm < vise.jaw_height_mm)
            tops.push_back({vise.jaw_height_mm - parallels_mm, parallels_mm});
    return tops;
}

/// Adds the directions across straight sides that are not known yet.
void addDirections(const Region& region, std::vector<Vec2>& found) {
    for (const auto& [from, segment] : eachEdge(region)) {
        const Vec2 edge = segment.to - from;
        if (segment.arc || edge.norm() < kLeastLengthMm) continue;
        Vec2 across = Vec2(edge.y(), -edge.x()).normalized();
        if (across.x() < -kSameSine || (across.x() < kSameSine && across.y() < 0)) across = -across;
        const bool known = std::any_of(found.begin(), found.end(), [&](const Vec2& other) {
            return std::abs(cross(other, across)) < kSameSine;
        });
        if (!known) found.push_back(across);
    }
}

/// The slabs between which jaws could close: each side's furthest reach and from which height on.
struct Grip {
    double right_mm = 0;
    double left_mm = 0;
    double from_mm = 0;  ///< over the stock's bottom
    double to_mm = 0;
};

/// What keeps the jaws from going higher.
enum class ViseUse {
    Free,       ///< nothing is cut beside them
    GripStock,  ///< they hold stock below the part
    GripSides   ///< they hold as little as they may of sides that are cut above them
};

class ViseFinder {
  public:
    ViseFinder(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol)
        : stock_(stock),
          vise_(wish.vise),
          tol_(tol),
          growth_mm_(wish.growth_mm),
          bottom_mm_(stock.arriving.back().bottom_z_mm),
          tops_(jawTops(wish.vise, !cutsThrough(stock))),
          height_mm_(stock.arriving.front().top_z_mm - bottom_mm_) {}

    Clamping best(ViseUse use) {
        std::vector<Vec2> directions;
        for (std::size_t i = stock_.standing.size(); i-- > 0;)
            addDirections(stock_.standing[i], directions);
        Clamping best;
        if (tops_.empty()) {
            why_ = "none of its parallels is lower than its jaws";
            return best;
        }
        for (const Vec2& across : directions)
            for (const Grip& grip : gripsAlong(across))
                consider(across, grip, use, best);
        return best;
    }

    /// Why the last use that was asked for will not do.
    const std::string& why() const { return why_; }

  private:
    /// Jaws meet what sticks out furthest so far, going up; where something sticks out farther still they
    /// end, and higher ones could begin.
    std::vector<Grip> gripsAlong(const Vec2& across) const {
        std::vector<Grip> grips;
        Grip now{-1e300, -1e300, 0, 0};
        bool open = false;
        for (std::size_t i = stock_.arriving.size(); i-- > 0;) {
            const Prism& slab = stock_.arriving[i];
            const double right = furthest(slab.region, across);
            const double left = furthest(slab.region, -across);
            if (right > now.right_mm + kPlaneMm || left > now.left_mm + kPlaneMm) {
                if (open) grips.push_back(now);
                now = {std::max(right, now.right_mm), std::max(left, now.left_mm),
                       slab.bottom_z_mm - bottom_mm_, 0};
                open = true;
            }
            const bool touches = right > now.right_mm - kPlaneMm && left > now.left_mm - kPlaneMm;
            if (open && touches) now.to_mm = slab.top_z_mm - bottom_mm_;
            if (open && !touches) {
                grips.push_back(now);
                open = false;
            }
        }
        if (open) grips.push_back(now);
        std::erase_if(grips,
                      [&](const Grip& grip) { return grip.to_mm - grip.from_mm < vise_.grip_mm - kPlaneMm; });
        return grips;
    }

    /// The lowest of these that comes to the jaw on this side, over the stock's bottom.
    double lowestOf(const std::vector<Prism>& prisms, const Vec2& out, double offset_mm) const {
        double lowest = 1e300;
        for (const Prism& prism : prisms)
            if (furthest(prism.region, out) > offset_mm - kPlaneMm)
                lowest = std::min(lowest, prism.bottom_z_mm - bottom_mm_);
        return lowest;
    }

    /// What faces the other jaw at every height of the grip.
    Hold held(const Vec2& across, const Grip& grip, double to_mm) const {
        std::vector<std::vector<Interval>> levels;
        for (std::size_t i = 0; i < stock_.arriving.size(); ++i) {
            const Prism& slab = stock_.arriving[i];
            const double low = slab.bottom_z_mm - bottom_mm_;
            const double high = slab.top_z_mm - bottom_mm_;
            if (high <= grip.from_mm + kPlaneMm || low >= to_mm - kPlaneMm) continue;
            const Region& standing = stock_.standing[i];
            // Along -across the stretches run the other way round.
            std::vector<Interval> opposite = sidesOn(standing, -across, grip.left_mm);
            for (Interval& interval : opposite)
                interval = {-interval.to, -interval.from};
            std::vector<Interval> stretches = facing(sidesOn(standing, across, grip.right_mm), opposite);
            if (!stretches.empty())
                levels.push_back(std::move(stretches));
            else if (area(standing) >= area(slab.region))
                return {};
        }
        if (levels.empty()) return {};
        Hold hold = longestHold(levels, vise_.jaw_width_mm);
        hold.beside_mm = besideJawsMm(stock_, vise_, across, hold.middle_mm);
        return hold;
    }

    /// Where the sides narrow downwards to less than holds, as at an end that is round, the jaws hold from
    /// where they are long enough to hold most.
    Hold heldFromBest(const Vec2& across, Grip& grip, double to_mm) const {
        Hold best = held(across, grip, to_mm);
        if (best.length_mm >= kLeastLengthMm) return best;
        Grip from = grip;
        for (std::size_t i = stock_.arriving.size(); i-- > 0;) {
            from.from_mm = stock_.arriving[i].bottom_z_mm - bottom_mm_;
            if (from.from_mm <= grip.from_mm) continue;
            if (to_mm - from.from_mm < vise_.grip_mm - kPlaneMm) break;
            const Hold hold = held(across, from, to_mm);
            if (hold.length_mm * (to_mm - from.from_mm) <= best.length_mm * (to_mm - grip.from_mm)) continue;
            best = hold;
            grip = from;
        }
        return best;
    }

    /// The jaws reach no higher over the stock's bottom.
    double highestJaws(const Vec2& across, const Grip& grip, ViseUse use) const {
        const double clear_mm =
            std::min(grip.to_mm, std::min(height_mm_, stock_.round_above_mm) - vise_.jaw_clearance_mm);
        if (use == ViseUse::GripStock) {
            const double spare_mm = stock_.under_part_mm - vise_.jaw_clearance_mm - vise_.grip_mm;
            return std::min(clear_mm, stock_.under_part_mm - vise_.jaw_clearance_mm -
                                          std::clamp(spare_mm, 0.0, kGripOverlapMm));
        }
        if (use == ViseUse::GripSides) return clear_mm;
        return std::min(clear_mm, lowestBeside(stock_.removed, across, grip) - vise_.jaw_clearance_mm);
    }

    double lowestBeside(const std::vector<Prism>& prisms, const Vec2& across, const Grip& grip) const {
        return std::min(lowestOf(prisms, across, grip.right_mm), lowestOf(prisms, -across, grip.left_mm));
    }

    /// Jaws that leave form cutters room at the outside, if these still hold enough of what the highest
    /// would.
    std::optional<JawTop> jawTopBelowTips(const Vec2& across, const Grip& grip, ViseUse use) const {
        const double highest_mm = highestJaws(across, grip, use);
        const std::optional<JawTop> highest = jawTop(grip, highest_mm, use);
        const double tips_mm =
            lowestBeside(stock_.leaning, across, grip) - kTipBelowMm - vise_.jaw_clearance_mm;
        if (use != ViseUse::Free || tips_mm >= highest_mm || !highest) return highest;
        const std::optional<JawTop> lower = jawTop(grip, tips_mm, use);
        const auto depth = [&](const JawTop& top) { return top.over_bottom_mm - grip.from_mm; };
        return lower && depth(*lower) >= kLeastHeldShare * depth(*highest) ? lower : highest;
    }

    /// The highest jaws that hold enough; of sides that are cut above them the lowest.
    std::optional<JawTop> jawTop(const Grip& grip, double highest_mm, ViseUse use) const {
        std::optional<JawTop> found;
        for (const JawTop& top : tops_) {
            if (top.over_bottom_mm > highest_mm + kPlaneMm) continue;
            if (top.over_bottom_mm - grip.from_mm < vise_.grip_mm - kPlaneMm) continue;
            if (!found || use == ViseUse::GripSides) found = top;
        }
        return found;
    }

    std::string whyNoTop(const Grip& grip, double highest_mm) const {
        const bool room = highest_mm - grip.from_mm >= vise_.grip_mm - kPlaneMm;
        if (room && tops_.back().over_bottom_mm > highest_mm + kPlaneMm)
            return fmt::format(
                "its jaws must end {:.4g} mm over the stock's bottom, on the highest parallels they "
                "end {:.4g} mm over it",
                highest_mm, tops_.back().over_bottom_mm);
        return "the cutting reaches down the sides that jaws could hold";
    }

    /// Is there enough above held sides for the next setup's jaws to hold what this one cut?
    bool canBeTurnedOver(double held_mm) const {
        return height_mm_ - held_mm >= vise_.grip_mm + vise_.jaw_clearance_mm - kPlaneMm;
    }

    void consider(const Vec2& across, Grip grip, ViseUse use, Clamping& best) {
        const double opening = grip.right_mm + grip.left_mm;
        if (opening > vise_.opening_mm) {
            if (why_ == kNoSides)
                why_ =
                    fmt::format("it opens {:.4g} mm, the stock is {:.4g} mm wide", vise_.opening_mm, opening);
            return;
        }
        const std::optional<JawTop> top = jawTopBelowTips(across, grip, use);
        if (!top || (use == ViseUse::GripSides && !canBeTurnedOver(heldTo(*top, use)))) {
            why_ = whyNoTop(grip, highestJaws(across, grip, use));
            return;
        }
        std::optional<Held> vise = heldBy(across, grip, *top);
        if (!vise) return;
        const double best_mm2 = best.length_mm * best.depth_mm;
        const bool best_is_solid = best.isVise() && best.solid_share >= kLeastSolidShare;
        // What holds less than a hold that bends nothing need not be measured.
        if (best_is_solid && vise->area_mm2() < best_mm2 * (1 - kSameHold)) return;
        vise->solid_share = solidShare(across, *vise);
        if (!isSolid(*vise) && use == ViseUse::Free)
            if (const auto lower = solidBelow(across, grip, *top)) vise = lower;
        if (best.isVise() && isSolid(*vise) == best_is_solid) {
            if (vise->area_mm2() < best_mm2 * (1 - kSameHold)) return;
            if (vise->area_mm2() < best_mm2 * (1 + kSameHold) && opening >= best.opening_mm) return;
        } else if (best_is_solid) {
            return;
        }
        best = made(across, *vise, use);
    }

    /// Jaws at a height, and what they hold there.
    struct Held {
        Grip grip;
        JawTop top;
        Hold hold;
        double solid_share = 1;  ///< material between them when all is cut

        double area_mm2() const { return hold.length_mm * (top.over_bottom_mm - grip.from_mm); }
    };
    static bool isSolid(const Held& held) { return held.solid_share >= kLeastSolidShare; }

    /// What jaws hold at that height, how much stands between them not measured; nothing where that is too
    /// little.
    std::optional<Held> heldBy(const Vec2& across, Grip grip, const JawTop& top) {
        const Hold hold = heldFromBest(across, grip, top.over_bottom_mm);
        if (hold.length_mm < kLeastLengthMm) {
            if (why_ == kNoSides && hold.length_mm > 0)
                why_ = fmt::format("{:.2g} mm of two sides face each other where its jaws would hold",
                                   hold.length_mm);
            return std::nullopt;
        }
        if (holdsOneEndAlone(vise_, hold.beside_mm)) {
            why_ = endsStickOut(hold.beside_mm);
            return std::nullopt;
        }
        const double over_jaws_mm = height_mm_ - top.over_bottom_mm;
        if (over_jaws_mm > kMostLengthsOverJaws * hold.length_mm) {
            why_ =
                fmt::format("{:.3g} mm of the stock would stand over jaws that hold {:.2g} mm of its length",
                            over_jaws_mm, hold.length_mm);
            return std::nullopt;
        }
        return Held{grip, top, hold};
    }

    /// Lower jaws between which enough stands when all is cut, as on the base under fins.
    std::optional<Held> solidBelow(const Vec2& across, const Grip& grip, const JawTop& than) {
        for (const JawTop& top : tops_) {
            if (top.over_bottom_mm > than.over_bottom_mm - kPlaneMm) continue;
            if (top.over_bottom_mm - grip.from_mm < vise_.grip_mm - kPlaneMm) break;
            std::optional<Held> held = heldBy(across, grip, top);
            if (!held) continue;
            held->solid_share = solidShare(across, *held);
            if (isSolid(*held)) return held;
        }
        return std::nullopt;
    }

    /// Up to where stock is kept from cutting, over the stock's bottom; 0: it is not.
    double heldTo(const JawTop& top, ViseUse use) const {
        const double over_jaws_mm = top.over_bottom_mm + vise_.jaw_clearance_mm;
        if (use == ViseUse::Free) return 0;
        return use == ViseUse::GripSides ? over_jaws_mm
                                         : std::max(over_jaws_mm, stock_.under_part_mm - kGripOverlapMm);
    }

    Clamping made(const Vec2& across, const Held& held, ViseUse use) const {
        const auto& [grip, top, hold, solid_share] = held;
        Clamping made;
        made.kind = HoldKind::Vise;
        made.across = Vec3(across.x(), across.y(), 0);
        made.opening_mm = grip.right_mm + grip.left_mm;
        made.from_mm = grip.from_mm;
        made.depth_mm = top.over_bottom_mm - grip.from_mm;
        made.length_mm = hold.length_mm;
        made.parallels_mm = top.parallels_mm;
        made.held_mm = heldTo(top, use);
        made.holds_all = use == ViseUse::GripStock;
        const double top_z_mm = bottom_mm_ + top.over_bottom_mm;
        made.fixtures = {viseJaw(vise_, growth_mm_, across, grip.right_mm, hold.middle_mm, top_z_mm),
                         viseJaw(vise_, growth_mm_, -across, grip.left_mm, -hold.middle_mm, top_z_mm)};
        made.solid_share = solid_share;
        made.text = viseText(made);
        askForSupport(made, vise_, hold.beside_mm);
        return made;
    }

    /// How much of the ground between the jaws, as long as they hold, is material that stands when all is
    /// cut.
    double solidShare(const Vec2& across, const Held& held) const {
        const auto& [grip, top, hold, share] = held;
        const Vec2 along(-across.y(), across.x());
        const Vec2 begin = (hold.middle_mm - hold.length_mm / 2) * along;
        const Vec2 end = (hold.middle_mm + hold.length_mm / 2) * along;
        const Region between = makePolygon({begin - grip.left_mm * across, begin + grip.right_mm * across,
                                            end + grip.right_mm * across, end - grip.left_mm * across});
        double all_mm3 = 0;
        double solid_mm3 = 0;
        for (std::size_t i = 0; i < stock_.arriving.size(); ++i) {
            const Prism& slab = stock_.arriving[i];
            const double low = std::max(slab.bottom_z_mm - bottom_mm_, grip.from_mm);
            const double high = std::min(slab.top_z_mm - bottom_mm_, top.over_bottom_mm);
            if (high <= low) continue;
            all_mm3 += (high - low) * area(between);
            const Region standing = intersect(between, stock_.standing[i], tol_);
            solid_mm3 += (high - low) * area(standing);
            for (const Prism& cut : stock_.removed) {
                const double from = std::max(low, cut.bottom_z_mm - bottom_mm_);
                const double to = std::min(high, cut.top_z_mm - bottom_mm_);
                if (to > from) solid_mm3 -= (to - from) * area(intersect(standing, cut.region, tol_));
            }
        }
        return all_mm3 > 0 ? solid_mm3 / all_mm3 : 1;
    }

    static std::string viseText(const Clamping& vise) {
        std::string text = fmt::format("vise, jaws {:.4g} mm open across {}, {:.3g} mm deep", vise.opening_mm,
                                       directionName(vise.across.head<2>()), vise.depth_mm);
        if (vise.from_mm > kPlaneMm) text += fmt::format(" from {:.3g} mm over the bottom", vise.from_mm);
        if (vise.parallels_mm > 0) text += fmt::format(", on parallels of {:.4g} mm", vise.parallels_mm);
        if (vise.held_mm > 0)
            text += fmt::format("; {}the lowest {:.4g} mm stay in this setup",
                                vise.holds_all ? "" : "at the outside ", vise.held_mm);
        return text;
    }

    static constexpr const char* kNoSides = "no two flat parallel sides face each other";

    const StockToHold& stock_;
    const Vise& vise_;
    const Tolerances& tol_;
    double growth_mm_ = 0;
    double bottom_mm_ = 0;
    std::vector<JawTop> tops_;
    double height_mm_ = 0;
    std::string why_ = kNoSides;
};

}  // namespace

double furthest(const Region& region, const Vec2& direction) {
    double reach = -1e300;
    for (const auto& [from, segment] : eachEdge(region))
        reach = std::max(reach, reachOf(from, segment, direction));
    return reach;
}

double besideJawsMm(const StockToHold& stock, const Vise& vise, const Vec2& across, double middle_mm) {
    const Vec2 along(-across.y(), across.x());
    double out_mm = 0;
    for (const Prism& slab : stock.arriving)
        out_mm = std::max(
            {out_mm, furthest(slab.region, along) - middle_mm, furthest(slab.region, -along) + middle_mm});
    return out_mm - vise.jaw_width_mm / 2;
}

bool holdsOneEndAlone(const Vise& vise, double beside_mm) {
    constexpr double kMostOut = 2;
    return beside_mm > kMostOut * vise.jaw_width_mm;
}

std::string endsStickOut(double beside_mm) {
    return fmt::format("{:.3g} mm would stick out beside its jaws: two vises could hold it", beside_mm);
}

void askForSupport(Clamping& held, const Vise& vise, double beside_mm) {
    if (beside_mm <= vise.jaw_width_mm) return;
    held.beside_mm = beside_mm;
    held.text += fmt::format(
        "; {:.3g} mm of stock stick out beside the jaws: support it, or use a second vise", beside_mm);
}

Fixture viseJaw(const Vise& vise, double growth_mm, const Vec2& out, double offset_mm, double middle_mm,
                double top_z_mm) {
    const Vec2 along(-out.y(), out.x());
    const double half_mm = vise.jaw_width_mm / 2 + growth_mm;
    const double far_mm = offset_mm + vise.jaw_thickness_mm + growth_mm;
    const Vec2 from = (middle_mm - half_mm) * along;
    const Vec2 to = (middle_mm + half_mm) * along;
    return {
        "vise jaw",
        makePolygon({from + offset_mm * out, from + far_mm * out, to + far_mm * out, to + offset_mm * out}),
        top_z_mm - vise.jaw_height_mm, top_z_mm + vise.jaw_clearance_mm, FixtureKind::Jaw};
}

std::string directionName(const Vec2& across) {
    if (std::abs(across.y()) < kSameSine) return "x";
    if (std::abs(across.x()) < kSameSine) return "y";
    return fmt::format("a line {:.1f} degrees from x", radToDeg(std::atan2(across.y(), across.x())));
}

WayToHold inVise(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol) {
    ViseFinder finder(stock, wish, tol);
    Clamping found = finder.best(ViseUse::Free);
    const std::string why_not = finder.why();
    const Vise& vise = wish.vise;
    const bool grip_stock = stock.under_part_mm >= vise.grip_mm + vise.jaw_clearance_mm - kPlaneMm;
    if (!found.isVise() && grip_stock) found = finder.best(ViseUse::GripStock);
    if (!found.isVise() && wish.kind == HoldKind::Vise) found = finder.best(ViseUse::GripSides);
    return found.isVise() ? WayToHold{std::move(found), {}} : WayToHold{{}, "no vise: " + why_not};
}

}  // namespace stepmill::setup
