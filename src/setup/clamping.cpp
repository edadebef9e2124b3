// How the stock could be held in a setup.

#include "stepmill/setup/clamping.h"

#include <fmt/format.h>

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill {

namespace {

/// Jaws of an ordinary vise for machining centres [mm].
constexpr double kJawHeightMm = 40;
constexpr double kJawWidthMm = 150;
constexpr double kJawThicknessMm = 40;
/// Cutting and the stock's top stay this far above the jaws: by what these are grown [mm].
constexpr double kOverJawsMm = kFixtureGrowth * kJawHeightMm;
/// Less depth or length than this holds nothing [mm].
constexpr double kLeastDepthMm = 3;
constexpr double kLeastLengthMm = 5;
/// Sides this near to one plane are one [mm]: a hundredth is what jaws take up.
constexpr double kPlaneMm = 0.01;
/// Holds within this share are as good as each other.
constexpr double kSameHold = 1e-6;
/// Directions this near are one.
constexpr double kSameSine = 1e-4;

struct Interval {
    double from = 0;
    double to = 0;
};

/// Furthest a segment reaches in a direction.
double furthest(const Vec2& from, const Segment& segment, const Vec2& direction) {
    double reach = std::max(direction.dot(from), direction.dot(segment.to));
    if (!segment.arc) return reach;
    const Vec2 top = segment.arc->centre + segment.arc->radius_mm * direction;
    if (distanceTo(top, from, segment) < kGridMm) reach = std::max(reach, direction.dot(top));
    return reach;
}

double furthest(const Region& region, const Vec2& direction) {
    double reach = -1e300;
    for (const auto& [from, segment] : eachEdge(region))
        reach = std::max(reach, furthest(from, segment, direction));
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

/// What two jaws hold: how long, and from where to where along them.
struct Hold {
    double length_mm = 0;
    Interval span{1e300, -1e300};
};

/// Where both sides have material. Stretches of one side do not overlap.
Hold facing(const std::vector<Interval>& a, const std::vector<Interval>& b) {
    Hold hold;
    for (const Interval& one : a) {
        for (const Interval& other : b) {
            const Interval both{std::max(one.from, other.from), std::min(one.to, other.to)};
            if (both.to <= both.from) continue;
            hold.length_mm += both.to - both.from;
            hold.span = {std::min(hold.span.from, both.from), std::max(hold.span.to, both.to)};
        }
    }
    return hold;
}

/// A jaw against the plane `out . p = offset`, its middle at `middle_mm` along it.
Fixture jaw(const std::string& name, const Vec2& out, double offset_mm, double middle_mm, double top_z_mm) {
    const Vec2 along(-out.y(), out.x());
    const double half_mm = (1 + kFixtureGrowth) * kJawWidthMm / 2;
    const double far_mm = offset_mm + (1 + kFixtureGrowth) * kJawThicknessMm;
    const Vec2 from = (middle_mm - half_mm) * along;
    const Vec2 to = (middle_mm + half_mm) * along;
    return {
        name,
        makePolygon({from + offset_mm * out, from + far_mm * out, to + far_mm * out, to + offset_mm * out}),
        top_z_mm - kJawHeightMm, top_z_mm + kFixtureGrowth * kJawHeightMm};
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

std::string directionName(const Vec2& across) {
    if (std::abs(across.y()) < kSameSine) return "x";
    if (std::abs(across.x()) < kSameSine) return "y";
    return fmt::format("a line {:.1f} degrees from x", std::atan2(across.y(), across.x()) * 180 / M_PI);
}

/// The slabs between which jaws could close: each side's furthest reach and from which height on.
struct Grip {
    double right_mm = 0;
    double left_mm = 0;
    double from_mm = 0;  ///< over the stock's bottom
    double to_mm = 0;
};

class ViseFinder {
  public:
    ViseFinder(const std::vector<Prism>& arriving, const std::vector<bool>& upright,
               const std::vector<Prism>& removed)
        : arriving_(arriving),
          upright_(upright),
          removed_(removed),
          bottom_mm_(arriving.back().bottom_z_mm) {}

    Clamping best() {
        std::vector<Vec2> directions;
        for (std::size_t i = arriving_.size(); i-- > 0;)
            if (upright_[i]) addDirections(arriving_[i].region, directions);
        Clamping best;
        for (const Vec2& across : directions)
            for (const Grip& grip : gripsAlong(across))
                consider(across, grip, best);
        if (!best.vise) best.text = "no vise: " + why_;
        return best;
    }

  private:
    /// Jaws meet what sticks out furthest so far, going up; where something sticks out farther still they
    /// end, and higher ones could begin.
    std::vector<Grip> gripsAlong(const Vec2& across) const {
        std::vector<Grip> grips;
        Grip now{-1e300, -1e300, 0, 0};
        bool open = false;
        for (std::size_t i = arriving_.size(); i-- > 0;) {
            const Prism& slab = arriving_[i];
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
        std::erase_if(grips, [](const Grip& grip) { return grip.to_mm - grip.from_mm < kLeastDepthMm; });
        return grips;
    }

    /// Lowest cutting that comes to the jaw on this side, over the stock's bottom.
    double lowestCut(const Vec2& out, double offset_mm) const {
        double lowest = 1e300;
        for (const Prism& prism : removed_)
            if (furthest(prism.region, out) > offset_mm - kPlaneMm)
                lowest = std::min(lowest, prism.bottom_z_mm - bottom_mm_);
        return lowest;
    }

    /// What faces the other jaw at every height of the grip.
    Hold held(const Vec2& across, const Grip& grip, double to_mm) const {
        Hold least;
        least.length_mm = 1e300;
        for (std::size_t i = 0; i < arriving_.size(); ++i) {
            const Prism& slab = arriving_[i];
            const double low = slab.bottom_z_mm - bottom_mm_;
            const double high = slab.top_z_mm - bottom_mm_;
            if (!upright_[i] || high <= grip.from_mm + kPlaneMm || low >= to_mm - kPlaneMm) continue;
            // Along -across the stretches run the other way round.
            std::vector<Interval> opposite = sidesOn(slab.region, -across, grip.left_mm);
            for (Interval& interval : opposite)
                interval = {-interval.to, -interval.from};
            const Hold hold = facing(sidesOn(slab.region, across, grip.right_mm), opposite);
            if (hold.length_mm < least.length_mm) least = hold;
        }
        return least.length_mm < 1e300 ? least : Hold{};
    }

    void consider(const Vec2& across, const Grip& grip, Clamping& best) {
        const double cut = std::min(lowestCut(across, grip.right_mm), lowestCut(-across, grip.left_mm));
        const double top = arriving_.front().top_z_mm - bottom_mm_;
        const double to =
            std::min({grip.to_mm, grip.from_mm + kJawHeightMm, std::min(cut, top) - kOverJawsMm});
        const double depth = to - grip.from_mm;
        if (depth < kLeastDepthMm) {
            why_ = "the cutting reaches down the sides that jaws could hold";
            return;
        }
        const Hold hold = held(across, grip, to);
        if (hold.length_mm < kLeastLengthMm) return;
        const double opening = grip.right_mm + grip.left_mm;
        const double area = hold.length_mm * depth;
        const double most = best.length_mm * best.depth_mm;
        if (best.vise && area < most * (1 - kSameHold)) return;
        if (best.vise && area < most * (1 + kSameHold) && opening >= best.opening_mm) return;
        best.vise = true;
        best.across = Vec3(across.x(), across.y(), 0);
        best.opening_mm = opening;
        best.from_mm = grip.from_mm;
        best.depth_mm = depth;
        best.length_mm = hold.length_mm;
        const double middle = (hold.span.from + hold.span.to) / 2;
        best.jaws = {jaw("vise jaw", across, grip.right_mm, middle, bottom_mm_ + to),
                     jaw("vise jaw", -across, grip.left_mm, -middle, bottom_mm_ + to)};
        best.text = fmt::format(
            "vise, jaws {:.4g} mm open across {}, {:.3g} mm deep{}", opening, directionName(across), depth,
            grip.from_mm > kPlaneMm ? fmt::format(" from {:.3g} mm over the bottom", grip.from_mm)
                                    : std::string());
    }

    const std::vector<Prism>& arriving_;
    const std::vector<bool>& upright_;
    const std::vector<Prism>& removed_;
    double bottom_mm_ = 0;
    std::string why_ = "no two flat parallel sides face each other";
};

double seatArea(const Prism& lowest, const std::vector<Prism>& removed, const Tolerances& tol) {
    std::vector<Region> gone;
    for (const Prism& prism : removed)
        if (prism.bottom_z_mm < lowest.bottom_z_mm + kPlaneMm) gone.push_back(prism.region);
    return area(gone.empty() ? lowest.region : subtract(lowest.region, unite(gone, tol), tol));
}

}  // namespace

Clamping suggestClamping(const std::vector<Prism>& arriving, const std::vector<bool>& upright,
                         const std::vector<Prism>& removed, const Tolerances& tol) {
    Clamping clamping;
    if (arriving.empty() || arriving.back().region.empty()) {
        clamping.text = "no vise: the stock is empty at its bottom";
        return clamping;
    }
    clamping = ViseFinder(arriving, upright, removed).best();
    if (upright.back()) clamping.seat_mm2 = seatArea(arriving.back(), removed, tol);
    if (clamping.seat_mm2 <= 0) clamping.text += "; nothing flat to rest on at the bottom";
    return clamping;
}

}  // namespace stepmill
