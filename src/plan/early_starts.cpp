#include "plan/early_starts.h"

#include <algorithm>

#include "stepmill/access/collision.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge_index.h"

namespace stepmill {
namespace {

/// What still stands over a band's floor.
struct Standing {
    Region region;
    EdgeIndex edges;
};

/// Does the cylinder stay clear of what stands up to `top_z_mm` on every move?
bool passes(const Toolpath& path, double radius_mm, double bottom_mm, const Standing& standing,
            double top_z_mm, const Tolerances& tol) {
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const double low_mm = std::min(from.z(), move.to.z()) + bottom_mm;
        const Edge way = makeEdge(from.head<2>(), {Vec2(move.to.head<2>()), move.arc});
        from = move.to;
        if (low_mm >= top_z_mm) continue;
        if (standing.edges.anyNearer(way, radius_mm - tol.gouge_mm)) return false;
        if (contains(standing.region, way.segment.to)) return false;
    }
    return true;
}

bool toolPasses(const BandOperation& lower, const Standing& standing, double top_z_mm,
                const Tolerances& tol) {
    const Toolpath& path = lower.operation->path;
    if (!passes(path, lower.tool.radius_mm(), 0, standing, top_z_mm, tol)) return false;
    const std::vector<HolderCylinder> cylinders = access::cylindersOf(lower.tool);
    return std::all_of(cylinders.begin(), cylinders.end(), [&](const HolderCylinder& cylinder) {
        return passes(path, cylinder.diameter_mm / 2, cylinder.bottom_mm, standing, top_z_mm, tol);
    });
}

/// A band and what stands over its floor as its operations run.
class BandBefore {
  public:
    BandBefore(const BandOperations& band, const Tolerances& tol)
        : band_(band), tol_(tol), after_(band.operations.size()) {}

    /// How many of its operations must be done before that one of a lower band.
    int operationsBefore(const BandOperation& lower) {
        const int all = static_cast<int>(band_.operations.size());
        for (int done = 1; done < all; ++done) {
            const BandOperation& last = band_.operations[done - 1];
            // What a wider cutter leaves is in the way of a narrower one that goes there.
            if (last.tool.diameter_mm > lower.tool.diameter_mm) continue;
            if (last.operation->leaves.floors_mm > 0) continue;
            if (toolPasses(lower, after(done), band_.feature().top_z_mm, tol_)) return done;
        }
        return all;
    }

  private:
    const Standing& after(int done) {
        std::optional<Standing>& known = after_[done - 1];
        if (known) return *known;
        std::vector<Region> gone;
        gone.reserve(static_cast<std::size_t>(done) + band_.planned->sequence.residual.size());
        for (int i = 0; i < done; ++i)
            gone.push_back(band_.operations[i].cleared);
        // What stays for good is kept clear of anyway.
        for (const Residual& residual : band_.planned->sequence.residual)
            gone.push_back(residual.region);
        known.emplace();
        known->region = subtract(band_.feature().target, unite(gone, tol_), tol_);
        known->edges = EdgeIndex(known->region);
        return *known;
    }

    const BandOperations& band_;
    const Tolerances& tol_;
    std::vector<std::optional<Standing>> after_;
};

bool mayBeLeftHalfDone(const BandOperations& band) {
    return !band.operations.empty() && !band.plain_ways;
}

}  // namespace

std::vector<BandStarts> earlyStarts(const std::vector<BandOperations>& bands, const Tolerances& tol) {
    std::vector<BandStarts> starts;
    starts.reserve(bands.size());
    for (const BandOperations& band : bands)
        starts.emplace_back(band.operations.size());
    const auto end = std::find_if_not(bands.begin(), bands.end(), mayBeLeftHalfDone) - bands.begin();
    for (std::ptrdiff_t i = 0; i < end; ++i) {
        BandBefore above(bands[i], tol);
        for (std::ptrdiff_t lower = i + 1; lower < end; ++lower)
            for (std::size_t k = 0; k < starts[lower].size(); ++k)
                starts[lower][k].push_back(
                    {bands[i].planned->feature.id, above.operationsBefore(bands[lower].operations[k])});
    }
    return starts;
}

}  // namespace stepmill
