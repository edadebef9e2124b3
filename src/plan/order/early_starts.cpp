#include "plan/order/early_starts.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "stepmill/access/collision.h"
#include "stepmill/plan/removed.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge_index.h"

namespace stepmill {
namespace {

/// What still stands over a feature's floor.
struct StandingOver {
    Region region;
    EdgeIndex edges;
};

/// An upright cylinder that goes along with the tool: the cutter, or a piece of shank or holder.
struct Cylinder {
    double radius_mm = 0;
    double bottom_mm = 0;  ///< over the tip
};

/// An operation of a lower feature, as it may meet what stands above.
class LowerOperation {
  public:
    explicit LowerOperation(const EarlyOperation& lower) : path_(lower.operation->path) {
        cylinders_.push_back({lower.tool.radius_mm(), 0});
        for (const HolderCylinder& cylinder : access::cylindersOf(lower.tool))
            cylinders_.push_back({cylinder.diameter_mm / 2, cylinder.bottom_mm});
        double widest_mm = 0;
        for (const Cylinder& cylinder : cylinders_)
            widest_mm = std::max(widest_mm, cylinder.radius_mm);
        Vec3 from = path_.start;
        for (const Move& move : path_.moves) {
            box_.extend(edgeOf(from, move).box);
            from = move.to;
        }
        if (!box_.isEmpty()) box_ = grown(box_, widest_mm);
    }

    bool passes(const StandingOver& standing, double top_z_mm, const Tolerances& tol) const {
        if (standing.edges.empty() || !box_.intersects(standing.edges.box())) return true;
        return std::all_of(cylinders_.begin(), cylinders_.end(), [&](const Cylinder& cylinder) {
            return passes(cylinder, standing, top_z_mm, tol);
        });
    }

  private:
    /// Does the cylinder stay clear of what stands up to `top_z_mm` on every move?
    bool passes(const Cylinder& cylinder, const StandingOver& standing, double top_z_mm,
                const Tolerances& tol) const {
        Vec3 from = path_.start;
        for (const Move& move : path_.moves) {
            const double low_mm = std::min(from.z(), move.to.z()) + cylinder.bottom_mm;
            const Edge way = edgeOf(from, move);
            from = move.to;
            if (low_mm >= top_z_mm) continue;
            if (standing.edges.anyNearer(way, cylinder.radius_mm - tol.gouge_mm)) return false;
            if (contains(standing.region, way.segment.to)) return false;
        }
        return true;
    }

    const Toolpath& path_;
    std::vector<Cylinder> cylinders_;
    Box2 box_;  ///< around all that the tool goes over
};

/// Does the operation clear its region down to the feature's floor? Spot drills, taps and what brings bores
/// to their fit clear nothing.
bool clears(const Operation& operation) {
    const bool mills = isClearing(operation.role) || operation.role == Role::Finish;
    return (mills || operation.role == Role::Drill) && operation.leaves.floors_mm <= 0;
}

/// What stays for good from the top down is kept clear of anyway. Over what stays at the floor alone material
/// stands until it is cut.
bool isKeptClearOf(const Residual& residual, const Feature& feature) {
    return residual.reason == Reason::DrillPoint || standsOver(residual, feature.depth_mm());
}

/// A feature and what stands over its floor as its operations run.
class FeatureBefore {
  public:
    FeatureBefore(const FeatureOperations& feature, const Tolerances& tol)
        : feature_(feature), tol_(tol), after_(feature.operations.size()) {}

    /// How many of its operations must be done before that one of a lower feature.
    int operationsBefore(const LowerOperation& lower) {
        const int all = static_cast<int>(feature_.operations.size());
        if (feature_.plain_ways) return all;
        for (int done = 0; done < all; ++done)
            if (lower.passes(after(done), feature_.target.top_z_mm, tol_)) return done;
        return all;
    }

  private:
    const StandingOver& after(int done) {
        std::optional<StandingOver>& known = after_[done];
        if (known) return *known;
        std::vector<Region> gone;
        for (int i = 0; i < done; ++i)
            if (clears(*feature_.operations[i].operation)) gone.push_back(feature_.operations[i].cleared);
        for (const Residual& residual : feature_.planned->sequence.residual)
            if (isKeptClearOf(residual, feature_.planned->feature)) gone.push_back(residual.region);
        known.emplace();
        known->region = subtract(feature_.target.region, unite(gone, tol_), tol_);
        known->edges = EdgeIndex(known->region);
        return *known;
    }

    const FeatureOperations& feature_;
    const Tolerances& tol_;
    std::vector<std::optional<StandingOver>> after_;
};

/// Of each feature all above it that have operations, ascending.
std::vector<std::vector<std::size_t>> allAbove(const std::vector<FeatureOperations>& features) {
    std::map<std::string, std::size_t> number;
    std::vector<std::set<std::size_t>> above(features.size());
    for (std::size_t f = 0; f < features.size(); ++f) {
        const Feature& feature = features[f].planned->feature;
        number.emplace(feature.id, f);
        for (const std::string& parent : feature.parents) {
            const auto found = number.find(parent);
            if (found == number.end()) continue;
            above[f].insert(found->second);
            above[f].insert(above[found->second].begin(), above[found->second].end());
        }
    }
    std::vector<std::vector<std::size_t>> with_operations(features.size());
    for (std::size_t f = 0; f < features.size(); ++f)
        std::copy_if(above[f].begin(), above[f].end(), std::back_inserter(with_operations[f]),
                     [&](std::size_t one) { return !features[one].operations.empty(); });
    return with_operations;
}

}  // namespace

std::vector<EarlyStarts> earlyStarts(const std::vector<FeatureOperations>& features, const Tolerances& tol) {
    const std::vector<std::vector<std::size_t>> above = allAbove(features);
    std::vector<FeatureBefore> before;
    before.reserve(features.size());
    for (const FeatureOperations& feature : features)
        before.emplace_back(feature, tol);
    std::vector<EarlyStarts> starts;
    for (std::size_t f = 0; f < features.size(); ++f) {
        const FeatureOperations& lower = features[f];
        EarlyStarts& of_feature = starts.emplace_back(lower.operations.size());
        if (lower.plain_ways) continue;
        for (std::size_t k = 0; k < lower.operations.size(); ++k) {
            const LowerOperation operation(lower.operations[k]);
            bool any_early = false;
            std::vector<Wait> waits;
            for (const std::size_t one : above[f]) {
                const int done = before[one].operationsBefore(operation);
                any_early |= done < static_cast<int>(features[one].operations.size());
                waits.push_back({features[one].planned->feature.id, done});
            }
            if (any_early) of_feature[k] = std::move(waits);
        }
    }
    return starts;
}

}  // namespace stepmill
