#include "stepmill/planar/clearance_diagram.h"

#include <array>
#include <map>
#include <mutex>

#include "planar/clearance/axis.h"
#include "planar/clearance/edge_band.h"
#include "planar/clearance/outline.h"
#include "planar/components.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/unsure_offset.h"

namespace stepmill {

namespace {

using clearance::kNearerMm;
using clearance::Level;
using clearance::Profile;
using clearance::Tie;

/// Does every edge of the rings stay that far from the boundary?
bool keepsDistance(const Profile& profile, const Region& rings, double distance) {
    for (const auto& [from, segment] : eachEdge(rings)) {
        for (const Vec2& p : {segment.to, pointAt(from, segment, 0.5)})
            if (profile.tree().distance(p, distance) < distance - kNearerMm) return false;
    }
    return true;
}

/// Rings that may stand for an offset: far enough from the boundary, and every hole inside an outer loop.
bool isSound(const Profile& profile, const Region& rings, double distance) {
    return keepsDistance(profile, rings, distance) && planar::componentsIfNested(rings);
}

Region reversedLoops(const Region& region) {
    Region result;
    for (const Loop& loop : region.loops)
        result.loops.push_back(reversed(loop));
    return result;
}

/// All points that the loops wind around. The Boolean counts windings, so any region around them will do.
Region withoutOverlaps(const Region& swept, const Tolerances& tol) {
    const Box2 box = grown(boundingBox(swept), 1);
    return intersect(swept, makeRectangle(box.min(), box.max()), tol);
}

/// The profile of one side, built when first asked for, once, whichever thread comes first.
class LazyProfile {
  public:
    const Profile& of(const Region& region, bool outside) const {
        std::call_once(once_, [&] { profile_ = std::make_unique<Profile>(region, outside); });
        return *profile_;
    }

  private:
    mutable std::once_flag once_;
    mutable std::unique_ptr<const Profile> profile_;
};

/// What has been found for a radius, kept for the next time it is asked. The values stay where they are.
template <typename Value>
class Memo {
  public:
    template <typename Make>
    const Value& of(double radius, const Make& make) const {
        {
            const std::lock_guard lock(mutex_);
            if (const auto known = values_.find(radius); known != values_.end()) return known->second;
        }
        // Not under the lock: making it may start tasks. Two threads that make the same value make equal
        // ones.
        Value made = make();
        const std::lock_guard lock(mutex_);
        return values_.emplace(radius, std::move(made)).first->second;
    }

  private:
    mutable std::mutex mutex_;
    mutable std::map<double, Value> values_;
};

}  // namespace

struct ClearanceDiagram::Impl {
    Region region;
    Tolerances tol;
    LazyProfile lazy_inside;
    LazyProfile lazy_outside;

    Impl(const Region& r, const Tolerances& t) : region(r), tol(t) {}

    const Profile& inside() const { return lazy_inside.of(region, false); }
    const Profile& outside() const { return lazy_outside.of(region, true); }
    /// Where discs of that radius pass, those that just fill an arc among them.
    const std::optional<Level>& passableBy(double radius) const {
        return levels.of(radius, [&]() -> std::optional<Level> {
            const std::optional<Level> level = clearance::levelAt(inside(), radius, Tie::Filled);
            if (!level) return std::nullopt;
            return clearance::withoutEmptyRings(inside(), *level);
        });
    }
    struct Opened {
        ClearanceDiagram diagram;  ///< of the opening; costs nothing until it is asked
        bool by_booleans = false;  ///< the level alone does not tell
    };
    Memo<std::optional<Level>> levels;
    Memo<Opened> openings;
    Memo<Region> bands;                  ///< around the boundary: both sides of it ask for the same ones
    Memo<std::optional<Region>> inward;  ///< offsets; nothing where none is sure
    Memo<std::optional<Region>> outward;

    const Opened& opened(double radius) const {
        return openings.of(radius, [&] { return open(radius); });
    }
    Opened open(double radius) const {
        if (const std::optional<Level>& level = passableBy(radius)) {
            if (std::optional<clearance::Swept> swept = clearance::sweptBy(inside(), *level)) {
                if (!swept->overlapping) return {{swept->region, tol}};
                return {{withoutOverlaps(swept->region, tol), tol}, true};
            }
        }
        return {{openedByBooleans(radius), tol}, true};
    }

    Region shrunk(double distance) const {
        return sure(inward.of(distance, [&] { return shrink(distance); }));
    }
    Region grown(double distance) const {
        return sure(outward.of(distance, [&] { return grow(distance); }));
    }
    static const Region& sure(const std::optional<Region>& offset) {
        if (!offset) throw UnsureOffset();
        return *offset;
    }
    std::optional<Region> shrink(double distance) const {
        if (auto rings = byLevels(inside(), distance, [](Region drawn) { return drawn; })) return rings;
        return byBooleans(inside(), distance,
                          [&](const Region& band) { return subtract(region, band, tol); });
    }
    std::optional<Region> grow(double distance) const {
        if (auto rings = byLevels(outside(), distance, reversedLoops)) return rings;
        return byBooleans(outside(), distance, [&](const Region& band) { return unite(region, band, tol); });
    }
    /// Lines that bridge what rounding has parted lie a little nearer than the rings between them, and a
    /// stretch of a micrometre between them may close to a loop of its own; then rings a little farther off
    /// will do.
    template <typename Turn>
    std::optional<Region> byLevels(const Profile& profile, double distance, const Turn& turn) const {
        for (const double more : aside()) {
            const auto level = clearance::levelAt(profile, distance + more, Tie::Blocked);
            if (!level) continue;
            Region rings = turn(clearance::ringsOf(profile, *level));
            if (isSound(profile, rings, distance)) return rings;
        }
        return std::nullopt;
    }
    std::array<double, 3> aside() const { return {0.0, tol.linear_mm, 3 * tol.linear_mm}; }
    /// Booleans move curves that nearly coincide by their snapping distance, once or twice; then that is
    /// added.
    template <typename Combine>
    std::optional<Region> byBooleans(const Profile& profile, double distance, const Combine& combine) const {
        for (const double more : aside()) {
            const Region rings = combine(bandOf(distance + more));
            if (isSound(profile, rings, distance)) return rings;
        }
        return std::nullopt;
    }
    const Region& bandOf(double distance) const {
        return bands.of(distance, [&] { return clearance::bandAround(region, distance, tol); });
    }
    /// Without a level: the shrunk region grown again.
    Region openedByBooleans(double radius) const {
        const Region centres = shrunk(radius);
        if (centres.empty()) return {};
        const Region grown = unite(centres, clearance::bandAround(centres, radius, tol), tol);
        return intersect(region, grown, tol);
    }
};

ClearanceDiagram::ClearanceDiagram(const Region& region, const Tolerances& tol)
    : impl_(std::make_unique<Impl>(region, tol)) {}
ClearanceDiagram::~ClearanceDiagram() = default;
ClearanceDiagram::ClearanceDiagram(ClearanceDiagram&&) noexcept = default;
ClearanceDiagram& ClearanceDiagram::operator=(ClearanceDiagram&&) noexcept = default;

const Region& ClearanceDiagram::region() const {
    return impl_->region;
}

Region ClearanceDiagram::offset(double distance_mm) const {
    const double distance = snapToGrid(std::abs(distance_mm));
    if (impl_->region.empty() || distance == 0) return impl_->region;
    return distance_mm > 0 ? impl_->grown(distance) : impl_->shrunk(distance);
}

std::vector<Region> ClearanceDiagram::rings(double first_mm, double step_mm) const {
    STEPMILL_CHECK(step_mm > 0, "rings advance");
    std::vector<Region> result;
    for (double distance = first_mm;; distance += step_mm) {
        Region ring = offset(-distance);
        if (ring.empty()) return result;
        result.push_back(std::move(ring));
    }
}

Region ClearanceDiagram::opening(double radius_mm) const {
    const double radius = snapToGrid(radius_mm);
    if (impl_->region.empty() || radius <= 0) return impl_->region;
    return impl_->opened(radius).diagram.region();
}

Region ClearanceDiagram::withoutStrips(double width_mm) const {
    const double radius = snapToGrid(width_mm / 2);
    if (impl_->region.empty() || radius <= 0) return impl_->region;
    if (const std::optional<Level>& level = impl_->passableBy(radius))
        if (std::optional<Region> kept = clearance::withoutStrips(impl_->inside(), *level))
            return *std::move(kept);
    return impl_->opened(radius).diagram.region();
}

Region ClearanceDiagram::restCentres(double large_mm, double small_mm) const {
    STEPMILL_CHECK(small_mm <= large_mm, "the first of a pair of discs is the larger one");
    const double large = snapToGrid(large_mm), small = snapToGrid(small_mm);
    if (impl_->region.empty() || large == small) return {};
    const std::optional<Level>& coarse = impl_->passableBy(large);
    const std::optional<Level>& fine = impl_->passableBy(small);
    const auto centres = [&] {
        return fine ? clearance::ringsOf(impl_->inside(), *fine) : impl_->shrunk(small);
    };
    if (coarse && coarse->runs.empty()) return centres();
    const Impl::Opened& opened = impl_->opened(large);
    if (fine && !opened.by_booleans)
        if (std::optional<Region> left = clearance::centresLeft(impl_->inside(), *coarse, *fine))
            return *std::move(left);
    return subtract(centres(), opened.diagram.offset(-small), impl_->tol);
}

double ClearanceDiagram::accessibleArea(double radius_mm) const {
    return area(opening(radius_mm));
}

MedialAxis ClearanceDiagram::medialAxis() const {
    return clearance::medialAxisOf(impl_->inside());
}

std::vector<ClearanceEvent> ClearanceDiagram::events() const {
    return clearance::eventsOf(impl_->inside(), medialAxis());
}

std::optional<ClearanceDiagram::Disc> ClearanceDiagram::largestInscribedDisc() const {
    std::optional<Disc> best;
    for (int site = 0; site < static_cast<int>(impl_->inside().sites().size()); ++site) {
        for (const clearance::Piece& piece : impl_->inside().pieces(site)) {
            for (const bool end : {false, true}) {
                const double radius = end ? piece.at_to : piece.at_from;
                if (best && radius <= best->radius_mm) continue;
                best = Disc{impl_->inside().centreAt(site, end ? piece.to : piece.from, radius), radius};
            }
        }
    }
    return best;
}

double ClearanceDiagram::distanceToBoundary(const Vec2& p) const {
    return impl_->inside().tree().distance(p);
}

Region offset(const Region& region, double distance_mm, const Tolerances& tol) {
    return ClearanceDiagram(region, tol).offset(distance_mm);
}

}  // namespace stepmill
