// Screws through the stock's own holes, into a plate.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "setup/ways_to_hold.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::setup {

namespace {

/// Screws of a shop [mm]: thread, the hole they pass through, head with its washer.
struct ScrewSize {
    double thread_mm;
    double hole_mm;
    double head_mm;
    double head_height_mm;
};
constexpr std::array kSizes = {ScrewSize{3, 3.2, 7, 3.5},  ScrewSize{4, 4.3, 9, 4.8},
                               ScrewSize{5, 5.3, 10, 6},   ScrewSize{6, 6.4, 12, 7.6},
                               ScrewSize{8, 8.4, 16, 9.6}, ScrewSize{10, 10.5, 20, 12}};

/// Cutting stays so far off a head: a cutter passes beside it [mm].
constexpr double kBesideHeadMm = 12;
/// Width of the ring under a head that carries it [mm].
constexpr double kLeastSeatMm = 1;
/// Screws nearer to each other than this share of the stock's length let it turn.
constexpr double kLeastSpread = 0.25;
constexpr std::size_t kMostScrews = 6;

/// A screw in its hole, its head on `seat_z_mm`.
struct Screw {
    ScrewSize size{};
    Vec2 at = Vec2::Zero();
    double seat_z_mm = 0;

    double topMm() const { return seat_z_mm + size.head_height_mm; }
};

/// Centre and radius of a hole in a section that is a full circle.
std::optional<Arc> circleOf(const Loop& loop) {
    const std::optional<Arc>& first = loop.segments.front().arc;
    if (!first || first->ccw) return std::nullopt;
    const bool round = std::all_of(loop.segments.begin(), loop.segments.end(),
                                   [&](const Segment& segment) { return segment.arc == first; });
    return round ? first : std::nullopt;
}

bool isFree(const Region& section, const Vec2& at, double radius_mm) {
    return !contains(section, at) && distanceToBoundary(section, at) > radius_mm - kPlaneMm;
}

class ScrewFinder {
  public:
    ScrewFinder(const StockToHold& stock, double growth_mm, const Tolerances& tol)
        : stock_(stock), growth_mm_(growth_mm), tol_(tol) {}

    std::vector<Screw> find() const {
        std::vector<Screw> found;
        for (const Loop& loop : stock_.arriving.back().region.loops) {
            const std::optional<Arc> hole = circleOf(loop);
            const ScrewSize* size = hole ? sizeFor(*hole) : nullptr;
            if (size == nullptr) continue;
            const std::optional<double> seat_z_mm = seatOf(hole->centre, *size);
            if (!seat_z_mm) continue;
            const Screw screw{*size, hole->centre, *seat_z_mm};
            if (staysUncut(screw)) found.push_back(screw);
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const Screw& a, const Screw& b) { return a.size.thread_mm > b.size.thread_mm; });
        return mostSpread(std::move(found));
    }

    /// How far apart the farthest two are, as a share of the stock's length.
    double spread(const std::vector<Screw>& screws) const {
        double most_mm = 0;
        for (const Screw& one : screws)
            for (const Screw& other : screws)
                most_mm = std::max(most_mm, (one.at - other.at).norm());
        return most_mm / boundingBox(stock_.arriving.back().region).sizes().maxCoeff();
    }

  private:
    /// As many as are of use, the two that are farthest apart first: of plates with many holes these hold
    /// best.
    static std::vector<Screw> mostSpread(std::vector<Screw> screws) {
        if (screws.size() <= kMostScrews) return screws;
        std::pair<std::size_t, std::size_t> farthest{0, 1};
        for (std::size_t i = 0; i < screws.size(); ++i)
            for (std::size_t k = i + 1; k < screws.size(); ++k)
                if ((screws[i].at - screws[k].at).norm() >
                    (screws[farthest.first].at - screws[farthest.second].at).norm() + kPlaneMm)
                    farthest = {i, k};
        std::swap(screws[0], screws[farthest.first]);
        std::swap(screws[1], screws[farthest.second]);
        screws.resize(kMostScrews);
        return screws;
    }

    /// The thickest that passes through the hole in every slab.
    const ScrewSize* sizeFor(const Arc& hole) const {
        const auto passes = [&](const ScrewSize& size) {
            return std::all_of(stock_.arriving.begin(), stock_.arriving.end(), [&](const Prism& slab) {
                return isFree(slab.region, hole.centre, size.hole_mm / 2);
            });
        };
        const auto widest = std::find_if(kSizes.rbegin(), kSizes.rend(), passes);
        return widest == kSizes.rend() ? nullptr : &*widest;
    }

    /// The top of the highest slab that carries the head all round; above it there is room for the head.
    std::optional<double> seatOf(const Vec2& at, const ScrewSize& size) const {
        const Region head = makeCircle(at, size.head_mm / 2);
        for (const Prism& slab : stock_.arriving) {
            if (isFree(slab.region, at, size.head_mm / 2)) continue;
            const double hole_mm = distanceToBoundary(slab.region, at);
            const bool carries =
                size.head_mm / 2 - hole_mm > kLeastSeatMm &&
                covers(makeCircle(at, hole_mm), subtract(head, slab.region, tol_), kPlaneMm, tol_);
            return carries ? std::optional<double>(slab.top_z_mm) : std::nullopt;
        }
        return std::nullopt;
    }

    bool staysUncut(const Screw& screw) const {
        return std::none_of(stock_.removed.begin(), stock_.removed.end(), [&](const Prism& prism) {
            return prism.bottom_z_mm < screw.topMm() + growth_mm_ &&
                   distanceToRegion(prism.region, screw.at) < screw.size.head_mm / 2 + kBesideHeadMm;
        });
    }

    const StockToHold& stock_;
    double growth_mm_ = 0;
    const Tolerances& tol_;
};

}  // namespace

WayToHold onScrews(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol) {
    const ScrewFinder finder(stock, wish.growth_mm, tol);
    const std::vector<Screw> screws = finder.find();
    if (screws.size() < 2 || finder.spread(screws) < kLeastSpread)
        return {{}, "no screws: no two holes far apart that a head can stay in"};
    Clamping made;
    made.kind = HoldKind::Screws;
    std::string places;
    for (const Screw& screw : screws) {
        const double radius_mm = screw.size.head_mm / 2 + wish.growth_mm;
        made.fixtures.push_back({fmt::format("screw M{:g}", screw.size.thread_mm),
                                 makeCircle(screw.at, radius_mm), screw.seat_z_mm,
                                 screw.topMm() + wish.growth_mm, FixtureKind::Screw});
        places += fmt::format("{}M{:g} at X{:.4g} Y{:.4g}", places.empty() ? "" : ", ", screw.size.thread_mm,
                              screw.at.x(), screw.at.y());
    }
    made.text = fmt::format("{} screws through its own holes into a plate of {:.4g} mm: {}", screws.size(),
                            wish.plate_mm, places);
    return {std::move(made), {}};
}

}  // namespace stepmill::setup
