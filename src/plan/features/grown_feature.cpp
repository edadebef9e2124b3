// Features on a stock that may be larger than it is said to be.

#include "stepmill/plan/grown_feature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stepmill/plan/removed.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill {
namespace {

/// A height this near to the raw top lies on it [mm].
constexpr double kOnTopMm = 1e-4;
/// The box of the raw sides is made this much smaller, so that what lies outside it meets what lies inside
/// in spite of rounding [mm].
constexpr double kOverlapMm = 1e-5;

Region rectangle(const Box2& box, double grown_mm) {
    const Vec2 by(grown_mm, grown_mm);
    return makeRectangle(snapToGrid(Vec2(box.min() - by)), snapToGrid(Vec2(box.max() + by)));
}

/// The region on the other side of the line where the axis has that value.
Region mirrored(Region region, int axis, double at) {
    const auto over = [&](Vec2& p) { p[axis] = snapToGrid(2 * at - p[axis]); };
    for (Loop& loop : region.loops) {
        over(loop.start);
        for (Segment& segment : loop.segments) {
            over(segment.to);
            if (!segment.arc) continue;
            segment.arc->centre[axis] = 2 * at - segment.arc->centre[axis];
            segment.arc->ccw = !segment.arc->ccw;
        }
        loop = reversed(loop);
    }
    return region;
}

/// Where the stock may have too much.
class Surplus {
  public:
    Surplus(const StockGrowth& growth, const Tolerances& tol) : growth_(growth), tol_(tol) {
        if (!growth.raw_sides_mm) return;
        const Region within = rectangle(*growth.raw_sides_mm, -kOverlapMm);
        within_ = boundingBox(within);
        const double deep_mm = std::min(2 * growth.side_mm, growth.raw_sides_mm->sizes().minCoeff() / 4);
        rim_ = subtract(within, rectangle(*growth.raw_sides_mm, -deep_mm), tol);
        frame_ = subtract(rectangle(*growth.raw_sides_mm, growth.side_mm), within, tol);
    }

    /// What may stand beside a section where the stock is raw.
    Region beside(const Region& section) const {
        if (section.empty() || growth_.side_mm <= 0) return {};
        if (!growth_.raw_sides_mm) return subtract(offset(section, growth_.side_mm, tol_), section, tol_);
        if (!reachesRim(section)) return {};
        const Region at_rim = intersect(section, rim_, tol_);
        if (at_rim.empty()) return {};
        // As far as the corner of a box that is larger on both its sides.
        return intersect(offset(at_rim, std::numbers::sqrt2 * growth_.side_mm, tol_), frame_, tol_);
    }

    Region with(const Region& section) const {
        if (section.empty() || growth_.side_mm <= 0) return section;
        if (!growth_.raw_sides_mm) return offset(section, growth_.side_mm, tol_);
        const Region more = beside(section);
        return more.empty() ? section : unite(section, more, tol_);
    }

    /// What a feature's target gains.
    Region overOpenEdges(const Feature& feature) const {
        return without(straightOut(feature.target), feature.obstruction);
    }

  private:
    /// What may stand straight before a section: farther aside it would stand before what is left beside a
    /// slot, and wide cutters were sent after it. Mirror images of the rim, which go on where that is cut by
    /// a raw side; where the section narrows inwards they lack what stands before its walls.
    Region straightOut(const Region& section) const {
        if (!growth_.raw_sides_mm) return beside(section);
        if (section.empty() || growth_.side_mm <= 0 || !reachesRim(section)) return {};
        const Region at_rim = intersect(section, rim_, tol_);
        if (at_rim.empty()) return {};
        std::vector<Region> out;
        const auto mirror = [&](const Region& region, int axis) {
            const Box2 box = boundingBox(region);
            std::vector<Region> images;
            if (box.min()[axis] - within_.min()[axis] < growth_.side_mm)
                images.push_back(mirrored(region, axis, within_.min()[axis]));
            if (within_.max()[axis] - box.max()[axis] < growth_.side_mm)
                images.push_back(mirrored(region, axis, within_.max()[axis]));
            out.insert(out.end(), images.begin(), images.end());
            return images;
        };
        for (const Region& aside : mirror(at_rim, 0))
            mirror(aside, 1);  // before corners
        mirror(at_rim, 1);
        return intersect(unite(out, tol_), frame_, tol_);
    }

    /// Surplus that an obstruction does not hold: fixtures stand beside the stock.
    Region without(const Region& surplus, const Region& obstruction) const {
        if (surplus.empty() || obstruction.empty()) return surplus;
        if (!growth_.raw_sides_mm) return subtract(surplus, obstruction, tol_);
        const Box2 box = boundingBox(obstruction);
        if (growth_.raw_sides_mm->contains(box)) return surplus;
        return subtract(surplus, intersect(obstruction, frame_, tol_), tol_);
    }

    bool reachesRim(const Region& section) const {
        const Box2 box = boundingBox(section);
        const Box2& raw = *growth_.raw_sides_mm;
        return ((box.min() - raw.min()).array() < growth_.side_mm).any() ||
               ((raw.max() - box.max()).array() < growth_.side_mm).any();
    }

    const StockGrowth& growth_;
    const Tolerances& tol_;
    Box2 within_;   ///< just inside the raw sides
    Region rim_;    ///< along them, inside
    Region frame_;  ///< outside them
};

void grow(std::vector<Obstacle>& obstacles, const Surplus& surplus, double top_mm) {
    for (Obstacle& obstacle : obstacles) {
        obstacle.section = surplus.with(obstacle.section);
        if (std::abs(obstacle.top_z_mm) < kOnTopMm) obstacle.top_z_mm += top_mm;
        if (std::abs(obstacle.bottom_z_mm) < kOnTopMm) obstacle.bottom_z_mm += top_mm;
    }
}

double grownTopMm(double top_z_mm, const StockGrowth& growth) {
    return toolpath::isRawTop(top_z_mm) ? top_z_mm + growth.top_mm : top_z_mm;
}

}  // namespace

GrownTarget targetOnGrownStock(const Feature& feature, const StockGrowth& growth, const Tolerances& tol) {
    if (!growth.any() || feature.target.empty()) return {feature.target, feature.top_z_mm};
    const Region more = Surplus(growth, tol).overOpenEdges(feature);
    return {more.empty() ? feature.target : unite(feature.target, more, tol),
            grownTopMm(feature.top_z_mm, growth)};
}

Feature onGrownStock(Feature feature, const StockGrowth& growth, const Tolerances& tol) {
    if (!growth.any() || feature.target.empty()) return feature;
    const Surplus surplus(growth, tol);
    if (const Region more = surplus.overOpenEdges(feature); !more.empty()) {
        feature.target = unite(feature.target, more, tol);
        feature.area_mm2 = area(feature.target);
    }
    feature.skirt = surplus.beside(feature.obstruction);
    if (!feature.skirt.empty()) feature.skirt = subtract(feature.skirt, feature.target, tol);
    grow(feature.obstacles, surplus, growth.top_mm);
    feature.top_z_mm = grownTopMm(feature.top_z_mm, growth);
    feature.volume_mm3 = feature.area_mm2 * feature.depth_mm();
    return feature;
}

std::vector<Obstacle> onGrownStock(std::vector<Obstacle> obstacles, const StockGrowth& growth,
                                   const Tolerances& tol) {
    if (growth.any()) grow(obstacles, Surplus(growth, tol), growth.top_mm);
    return obstacles;
}

std::vector<Residual> onNominalStock(std::vector<Residual> residual, const Feature& feature,
                                     const Feature& grown, const Tolerances& tol) {
    if (grown.area_mm2 == feature.area_mm2 && grown.top_z_mm == feature.top_z_mm) return residual;
    for (Residual& one : residual) {
        // A drill's point leaves less than a prism: its height is a mean.
        const double height_mm = meanHeightMm(one);
        const bool whole = height_mm >= grown.depth_mm() - kOnTopMm;
        if (grown.area_mm2 != feature.area_mm2) {
            one.region = intersect(one.region, feature.target, tol);
            one.area_mm2 = area(one.region);
        }
        one.volume_mm3 =
            one.area_mm2 * (whole ? feature.depth_mm() : std::min(height_mm, feature.depth_mm()));
    }
    std::erase_if(residual, [&](const Residual& one) { return one.area_mm2 <= tol.area_mm2; });
    return residual;
}

GrownTarget targetAsFound(Feature feature, const CutById& by_id, const std::vector<Fixture>& fixtures,
                          const StockGrowth& growth, const Tolerances& tol) {
    feature.obstacles.clear();
    return targetOnGrownStock(reduced(feature, by_id, fixtures, tol).feature, growth, tol);
}

Feature asFound(const Feature& feature, const CutById& by_id, const std::vector<Fixture>& fixtures,
                const StockGrowth& growth, const Tolerances& tol) {
    return onGrownStock(reduced(feature, by_id, fixtures, tol).feature, growth, tol);
}

}  // namespace stepmill
