// Rings from the outer boundary inwards.

#include "toolpath/patterns/stock_offset.h"

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill::toolpath {

namespace {

class StockOffset {
  public:
    StockOffset(double step_over_mm, const Tolerances& tol) : step_over_mm_(step_over_mm), tol_(tol) {}

    RingFamily::Variant make(const Region& guarded) {
        variant_.pattern = Pattern::StockOffset;
        for (const Region& part : stepmill::components(guarded)) {
            std::vector<Region> islands;
            for (const Loop& loop : part.loops)
                if (signedArea(loop) < 0) islands.push_back({{reversed(loop)}});
            goIn(withoutHoles(part), islands, 0);
        }
        return std::move(variant_);
    }

  private:
    using Islands = std::vector<Region>;

    /// `ground`: one component that the rings have not reached yet; `islands`: the islands that lie whole in
    /// it.
    void goIn(const Region& ground, const Islands& islands, int level) {
        // The first ring has the wall on the side where the others have material.
        for (const Loop& loop : ground.loops)
            add(level == 0 ? loop : reversed(loop), level, true);
        Region next = ClearanceDiagram(ground, tol_).offset(-step_over_mm_);
        Islands whole;
        for (const Region& island : islands) {
            if (isWithin(island, next))
                whole.push_back(island);
            else
                next = meet(island, next, level + 1);
        }
        for (const Region& part : stepmill::components(next)) {
            Islands within;
            for (const Region& island : whole)
                if (contains(part, island.loops.front().start)) within.push_back(island);
            goIn(part, within, level + 1);
        }
    }

    /// The wall the rings have passed already is cut on its own, the rest is part of the next ring.
    Region meet(const Region& island, const Region& next, int level) {
        for (const Path& passed : split(reversed(island.loops.front()), next, tol_).outside)
            add(passed, level, false);
        return next.empty() ? next : subtract(next, island, tol_);
    }

    bool isWithin(const Region& island, const Region& front) const {
        if (!contains(front, island.loops.front().start)) return false;
        const std::vector<Edge> edges = edgesOf(island);
        const EdgeIndex others(front);
        return std::none_of(edges.begin(), edges.end(),
                            [&](const Edge& edge) { return others.anyNearer(edge, tol_.linear_mm); });
    }

    void add(const Path& path, int level, bool outside_in) {
        variant_.rings.push_back({path, level, outside_in});
    }

    double step_over_mm_;
    const Tolerances& tol_;
    RingFamily::Variant variant_;
};

}  // namespace

std::optional<RingFamily::Variant> stockOffset(const RingFamily::Component& component, double step_over_mm,
                                               const Tolerances& tol) {
    const bool has_islands = std::any_of(component.guarded.loops.begin(), component.guarded.loops.end(),
                                         [](const Loop& loop) { return signedArea(loop) < 0; });
    if (!has_islands) return std::nullopt;
    return StockOffset(step_over_mm, tol).make(component.guarded);
}

}  // namespace stepmill::toolpath
