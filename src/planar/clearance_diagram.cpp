#include "stepmill/planar/clearance_diagram.h"

#include "planar/clearance_diagram_check.h"
#include "planar/clearance_diagram_opening.h"
#include "planar/clearance_diagram_trace.h"
#include "stepmill/core/error.h"

namespace stepmill {

namespace {

using clearance::Graph;
using clearance::Side;
using clearance::TracedLoop;

// A topology that fails its check is built again with chords this many times finer.
constexpr double kFiner = 16;
// The first attempt's chords are coarser than asked for: they only decide which sites meet.
constexpr double kCoarser = 3;
constexpr int kAttempts = 4;

Graph makeGraph(const Region& region, double chord_mm) {
    return clearance::buildGraph(clearance::makeSites(region, chord_mm), chord_mm);
}

Region toRegion(const std::vector<TracedLoop>& loops, bool reverse) {
    Region result;
    for (const TracedLoop& traced : loops)
        if (const std::optional<Loop> loop = clearance::toLoop(traced))
            result.loops.push_back(reverse ? reversed(*loop) : *loop);
    return result;
}

}  // namespace

struct ClearanceDiagram::Impl {
    Region region;
    Tolerances tol;
    Graph graph;
    clearance::SiteIndex index;

    std::vector<TracedLoop> traceChecked(Side side, double distance) const;
};

/// Traces, and where the self check finds chords too coarse, again on finer ones.
std::vector<TracedLoop> ClearanceDiagram::Impl::traceChecked(Side side, double distance) const {
    const clearance::DistanceBand band{distance - tol.gouge_mm / 2, distance + tol.linear_mm};
    double chord = kCoarser * tol.chord_mm;
    std::optional<Graph> finer;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const Graph& used = finer ? *finer : graph;
        std::vector<TracedLoop> loops = clearance::trace(used, side, distance, tol.linear_mm / 2);
        if (clearance::keepDistance(index, toRegion(loops, false).loops, band)) return loops;
        chord /= kFiner;
        finer = makeGraph(region, chord);
    }
    throw Error(ErrorCode::Internal, "clearance diagram",
                "an offset comes closer to the boundary than it should");
}

ClearanceDiagram::ClearanceDiagram(const Region& region, const Tolerances& tol)
    : impl_(std::make_unique<Impl>(Impl{region, tol, {}, {}})) {
    if (region.empty()) return;
    impl_->graph = makeGraph(region, kCoarser * tol.chord_mm);
    impl_->index = clearance::SiteIndex(impl_->graph.set);
}
ClearanceDiagram::~ClearanceDiagram() = default;
ClearanceDiagram::ClearanceDiagram(ClearanceDiagram&&) noexcept = default;
ClearanceDiagram& ClearanceDiagram::operator=(ClearanceDiagram&&) noexcept = default;

const Region& ClearanceDiagram::region() const {
    return impl_->region;
}

Region ClearanceDiagram::offset(double distance_mm) const {
    const double distance = snapToGrid(distance_mm);
    if (impl_->region.empty() || distance == 0) return impl_->region;
    const bool grow = distance > 0;
    const auto loops = impl_->traceChecked(grow ? Side::Outside : Side::Inside, std::abs(distance));
    Region result = toRegion(loops, grow);
#ifdef STEPMILL_COSTLY_CHECKS
    validate(result, "offset of a region");
#endif
    return result;
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
    const auto loops = impl_->traceChecked(Side::Inside, radius);
    return clearance::sweptByContacts(impl_->graph.set, loops, radius, impl_->tol);
}

std::optional<ClearanceDiagram::Disc> ClearanceDiagram::largestInscribedDisc() const {
    std::optional<Disc> best;
    const auto consider = [&](const Vec2& centre, double radius) {
        if (!best || radius > best->radius_mm) best = Disc{centre, radius};
    };
    const Graph& graph = impl_->graph;
    for (const clearance::HalfEdge& e : graph.edges) {
        if (e.side != Side::Inside) continue;
        const clearance::Vertex& vertex = graph.vertices[static_cast<std::size_t>(e.from)];
        consider(vertex.point, vertex.clearance);
    }
    // An arc's centre is a maximum of its own, which the chords meet only roughly.
    for (const clearance::Site& site : graph.set.sites)
        if (site.concaveOn(Side::Inside) && !impl_->index.closerThan(site.centre, site.radius - kGridMm))
            consider(site.centre, site.radius);
    return best;
}

Region offset(const Region& region, double distance_mm, const Tolerances& tol) {
    return ClearanceDiagram(region, tol).offset(distance_mm);
}

}  // namespace stepmill
