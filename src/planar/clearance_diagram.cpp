#include "stepmill/planar/clearance_diagram.h"

#include <mutex>

#include "planar/clearance_axis.h"
#include "planar/clearance_outline.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {

namespace {

using clearance::Level;
using clearance::Profile;
using clearance::Tie;

/// How much nearer to the boundary than asked a ring may come: half of what edges of a region may overlap by,
/// a twentieth of Tolerances::gouge_mm [mm].
constexpr double kNearerMm = 5e-5;

/// Throws if a loop comes closer to the boundary than it should.
void checkDistance(const Profile& profile, const Region& rings, double distance) {
    for (const Loop& loop : rings.loops) {
        Vec2 from = loop.start;
        for (const Segment& segment : loop.segments) {
            for (const Vec2& p : {segment.to, pointAt(from, segment, 0.5)}) {
                if (profile.tree().distance(p, distance) >= distance - kNearerMm) continue;
                throw Error(ErrorCode::Internal, "clearance diagram",
                            "an offset comes closer to the boundary than it should");
            }
            from = segment.to;
        }
    }
}

Region reversedLoops(const Region& region) {
    Region result;
    for (const Loop& loop : region.loops)
        result.loops.push_back(reversed(loop));
    return result;
}

/// What the loops wind around at all; the Boolean counts windings, so any region around them will do.
Region withoutOverlaps(const Region& swept, const Tolerances& tol) {
    const Box2 box = boundingBox(swept).grown(1);
    return intersect(swept, makeRectangle(box.min, box.max), tol);
}

}  // namespace

struct ClearanceDiagram::Impl {
    Region region;
    Tolerances tol;
    Profile inside;
    std::once_flag outside_once;
    std::unique_ptr<Profile> outside;

    Impl(const Region& r, const Tolerances& t) : region(r), tol(t), inside(r, false) {}

    const Profile& seenFromOutside() {
        std::call_once(outside_once, [&] { outside = std::make_unique<Profile>(region, true); });
        return *outside;
    }
    /// Where discs of that radius pass, those that just fill an arc among them.
    Level passableBy(double radius) const {
        return clearance::withoutEmptyRings(inside, clearance::levelAt(inside, radius, Tie::Filled));
    }
    Region openingAt(const Level& level, bool& overlapping) const {
        clearance::Swept swept = clearance::sweptBy(inside, level);
        overlapping = swept.overlapping;
        return overlapping ? withoutOverlaps(swept.region, tol) : std::move(swept.region);
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
    const bool grow = distance_mm > 0;
    const Profile& profile = grow ? impl_->seenFromOutside() : impl_->inside;
    const Level level = clearance::levelAt(profile, distance, Tie::Blocked);
    Region rings = clearance::ringsOf(profile, level);
    checkDistance(profile, rings, distance);
    return grow ? reversedLoops(rings) : rings;
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
    bool overlapping = false;
    return impl_->openingAt(impl_->passableBy(radius), overlapping);
}

Region ClearanceDiagram::restCentres(double large_mm, double small_mm) const {
    STEPMILL_CHECK(small_mm <= large_mm, "the first of a pair of discs is the larger one");
    const double large = snapToGrid(large_mm), small = snapToGrid(small_mm);
    if (impl_->region.empty() || large == small) return {};
    const Level coarse = impl_->passableBy(large);
    const Level fine = impl_->passableBy(small);
    if (coarse.runs.empty()) return clearance::ringsOf(impl_->inside, fine);
    bool overlapping = false;
    const Region opened = impl_->openingAt(coarse, overlapping);
    if (!overlapping)
        if (std::optional<Region> left = clearance::centresLeft(impl_->inside, coarse, fine)) return *left;
    const Region done = ClearanceDiagram(opened, impl_->tol).offset(-small);
    return subtract(clearance::ringsOf(impl_->inside, fine), done, impl_->tol);
}

double ClearanceDiagram::accessibleArea(double radius_mm) const {
    return area(opening(radius_mm));
}

MedialAxis ClearanceDiagram::medialAxis() const {
    return clearance::medialAxisOf(impl_->inside);
}

std::vector<ClearanceEvent> ClearanceDiagram::events() const {
    return clearance::eventsOf(impl_->inside, medialAxis());
}

std::optional<ClearanceDiagram::Disc> ClearanceDiagram::largestInscribedDisc() const {
    std::optional<Disc> best;
    for (int site = 0; site < static_cast<int>(impl_->inside.sites().size()); ++site) {
        for (const clearance::Piece& piece : impl_->inside.pieces(site)) {
            for (const bool end : {false, true}) {
                const double radius = end ? piece.at_to : piece.at_from;
                if (best && radius <= best->radius_mm) continue;
                best = Disc{impl_->inside.centreAt(site, end ? piece.to : piece.from, radius), radius};
            }
        }
    }
    return best;
}

double ClearanceDiagram::distanceToBoundary(const Vec2& p) const {
    return impl_->inside.tree().distance(p);
}

Region offset(const Region& region, double distance_mm, const Tolerances& tol) {
    return ClearanceDiagram(region, tol).offset(distance_mm);
}

}  // namespace stepmill
