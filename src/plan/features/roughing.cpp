// The features of a setup as roughing sees them.

#include "stepmill/plan/roughing.h"

#include <algorithm>
#include <deque>
#include <map>

#include "stepmill/access/slivers.h"
#include "stepmill/feature/describe_boundary.h"
#include "stepmill/feature/heights.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/sequence/drilling.h"

namespace stepmill {
namespace {

/// Offsets of regions, each made once: obstacles repeat from feature to feature.
class GrownRegions {
  public:
    GrownRegions(double by_mm, const Tolerances& tol) : by_mm_(by_mm), tol_(tol) {}

    const Region& of(const Region& region) {
        for (const auto& [known, grown] : known_)
            if (feature::identical(known, region)) return grown;
        Region grown = region.empty() || by_mm_ <= 0 ? region : offset(region, by_mm_, tol_);
        return known_.emplace_back(region, std::move(grown)).second;
    }

  private:
    double by_mm_;
    const Tolerances& tol_;
    std::deque<std::pair<Region, Region>> known_;
};

/// A feature before and after.
struct Roughed {
    Feature whole;
    Feature rough;
    bool gone = false;  ///< nothing of it is left to rough
};

class Rougher {
  public:
    Rougher(const FinishAllowance& leaves, const ToolLibrary& drills, const std::string& material,
            const Tolerances& tol)
        : leaves_(leaves), drills_(drills), material_(material), tol_(tol), grown_(leaves.walls_mm, tol) {}

    FeatureSet run(FeatureSet found) {
        for (Feature& feature : found.features)
            add(std::move(feature));
        double before_mm3 = 0;
        double after_mm3 = 0;
        found.features.clear();
        std::vector<Unplanned> left;
        for (const Roughed& one : all_) {
            before_mm3 += one.whole.volume_mm3;
            addLeft(one, left);
            if (one.gone) continue;
            after_mm3 += one.rough.volume_mm3;
            found.features.push_back(one.rough);
        }
        // What offsets and slivers round goes with the rest.
        double left_mm3 = 0;
        for (const Unplanned& entry : left)
            left_mm3 += entry.volume_mm3;
        for (Unplanned& entry : left)
            entry.volume_mm3 *= std::max(0.0, before_mm3 - after_mm3) / left_mm3;
        found.unplanned.insert(found.unplanned.end(), left.begin(), left.end());
        return found;
    }

  private:
    void add(Feature whole) {
        Roughed one{whole, whole, false};
        number_.emplace(whole.id, all_.size());
        Feature& rough = one.rough;
        rough.parents = parentsLeft(whole);
        rough.top_z_mm = topOf(whole);
        if (!isDrilled(whole)) {
            if (!whole.through) rough.floor_z_mm += leaves_.floors_mm;
            moveWallsIn(rough);
        }
        rough.obstacles = obstaclesOf(whole, rough.floor_z_mm);
        rough.volume_mm3 = rough.area_mm2 * rough.depth_mm();
        one.gone = rough.target.empty() || rough.depth_mm() <= kSameHeightMm;
        all_.push_back(std::move(one));
    }

    const Roughed& parent(const std::string& id) const { return all_[number_.at(id)]; }

    /// The nearest features above that are not gone.
    std::vector<std::string> parentsLeft(const Feature& whole) const {
        std::vector<std::string> left;
        for (const std::string& id : whole.parents) {
            if (!parent(id).gone)
                left.push_back(id);
            else
                left.insert(left.end(), parent(id).rough.parents.begin(), parent(id).rough.parents.end());
        }
        std::sort(left.begin(), left.end(), [this](const std::string& a, const std::string& b) {
            return number_.at(a) < number_.at(b);
        });
        left.erase(std::unique(left.begin(), left.end()), left.end());
        return left;
    }

    /// Where those above end; where the stock does, if they are gone.
    double topOf(const Feature& whole) const {
        double top_mm = whole.parents.empty() ? whole.top_z_mm : whole.floor_z_mm;
        for (const std::string& id : whole.parents)
            top_mm =
                std::max(top_mm, parent(id).gone ? parent(id).rough.top_z_mm : parent(id).rough.floor_z_mm);
        return top_mm;
    }

    /// A drill makes the hole, in ground that those above it have cleared.
    bool isDrilled(const Feature& whole) const {
        if (!isHole(whole.feature_class)) return false;
        const bool drill =
            std::any_of(drills_.tools.begin(), drills_.tools.end(), [&](const ToolAssembly& tool) {
                return tool.isDrill() && tool.cuttingFor(material_) != nullptr &&
                       drillCheck(whole, tool, tol_).fits;
            });
        return drill && std::all_of(whole.parents.begin(), whole.parents.end(), [&](const std::string& id) {
                   const Roughed& above = parent(id);
                   return !above.gone &&
                          area(subtract(whole.target, above.rough.target, tol_)) <= tol_.area_mm2;
               });
    }

    void moveWallsIn(Feature& rough) {
        rough.obstruction = grown_.of(rough.obstruction);
        rough.target = access::withoutSliverComponents(subtract(rough.target, rough.obstruction, tol_), tol_);
        rough.area_mm2 = area(rough.target);
        if (!rough.target.empty()) describeBoundary(rough, tol_);
    }

    std::vector<Obstacle> obstaclesOf(const Feature& whole, double floor_mm) {
        std::vector<Obstacle> grown;
        for (const Obstacle& obstacle : whole.obstacles) {
            const double bottom_mm = grown.empty() ? floor_mm : grown.back().top_z_mm;
            grown.push_back({bottom_mm, obstacle.top_z_mm + leaves_.floors_mm, grown_.of(obstacle.section)});
        }
        return grown;
    }

    /// What stays of a feature: along its walls over its whole depth, and on its floor where none goes on
    /// below.
    void addLeft(const Roughed& one, std::vector<Unplanned>& left) const {
        const Feature& whole = one.whole;
        if (one.gone && one.rough.target.empty())
            return add(whole.target, whole.top_z_mm, whole.floor_z_mm, left);
        add(subtract(whole.target, one.rough.target, tol_), whole.top_z_mm, whole.floor_z_mm, left);
        add(subtract(one.rough.target, belowIt(whole.id), tol_),
            std::min(whole.top_z_mm, one.rough.floor_z_mm), whole.floor_z_mm, left);
    }

    Region belowIt(const std::string& id) const {
        std::vector<Region> below;
        for (const Roughed& other : all_) {
            const std::vector<std::string>& parents = other.whole.parents;
            const bool nested = std::find(parents.begin(), parents.end(), id) != parents.end();
            if (nested && !other.gone) below.push_back(other.rough.target);
        }
        return below.empty() ? Region{} : unite(below, tol_);
    }

    void add(Region region, double top_mm, double bottom_mm, std::vector<Unplanned>& left) const {
        const double volume_mm3 = area(region) * (top_mm - bottom_mm);
        if (region.empty() || top_mm - bottom_mm <= kSameHeightMm || volume_mm3 <= 0) return;
        left.push_back({{Reason::Allowance, {}}, volume_mm3, top_mm, bottom_mm, std::move(region)});
    }

    const FinishAllowance& leaves_;
    const ToolLibrary& drills_;
    const std::string& material_;
    const Tolerances& tol_;
    GrownRegions grown_;
    std::vector<Roughed> all_;
    std::map<std::string, std::size_t> number_;  ///< in `all_`
};

}  // namespace

FeatureSet withAllowance(FeatureSet found, const FinishAllowance& leaves, const ToolLibrary& drills,
                         const std::string& material, const Tolerances& tol) {
    if (!leaves.any()) return found;
    return Rougher(leaves, drills, material, tol).run(std::move(found));
}

}  // namespace stepmill
