#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/access/swept.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/feature/feature.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// Why a tool takes no part in a feature.
enum class ExclusionReason {
    WrongType,       ///< a drill in a pocket, a ball or bull cutter on a flat floor
    NoCuttingData,   ///< the library has no data for the material
    TooWide,         ///< no free centre: the tool fits nowhere
    NoEntry,         ///< fits, but can neither plunge, ramp, helix nor come in over an open edge
    TooShort,        ///< flutes or stick-out do not reach the floor
    HolderCollision  ///< holder or shank would touch part or stock somewhere the cutter must go
};
std::string toString(ExclusionReason reason);

struct Exclusion {
    ExclusionReason reason;
    std::string text;  ///< for people, with the numbers ("reaches 30 mm, the floor is 45 mm deep")
};

/// How a tool gets down to depth in one component of its free centres.
enum class EntryKind { OpenEdge, Helix, Ramp, Plunge };
std::string toString(EntryKind kind);

struct Entry {
    EntryKind kind = EntryKind::Plunge;
    /// OpenEdge: where to go down beside the material, the disc clear of target and obstruction; up to 1 mm
    /// outside the component of the free centres, and the straight way from it into the component is free.
    /// Helix: the helix' centre; Ramp: where the ramp starts; Plunge: where to go down.
    Vec2 at = Vec2::Zero();
    double helix_radius_mm = 0;   ///< of the centre's path; Helix only
    Vec2 ramp_to = Vec2::Zero();  ///< other end of the ramp's zigzag; Ramp only
};

/// A feature with what every tool asks of it computed once: the clearance diagrams of target and
/// obstruction. Immutable; share it between threads.
class FeatureGround {
  public:
    FeatureGround(const Feature& feature, const Tolerances& tol);
    ~FeatureGround();
    FeatureGround(FeatureGround&&) noexcept;

    const Feature& feature() const;
    const Tolerances& tolerances() const;
    /// Is the target closed all round, so that only centres inside it are free?
    bool walledIn() const;
    /// offset(T, x) and offset(O, x), from diagrams built once.
    Region targetOffset(double distance_mm) const;
    Region obstructionOffset(double distance_mm) const;
    /// Points a disc of that radius sweeps inside T.
    Region targetOpening(double radius_mm) const;
    /// Centres left inside T to a disc of radius `small` after one of radius `large`.
    Region targetRestCentres(double large_mm, double small_mm) const;
    /// The section of feature().obstacles[index], offset. \throws std::out_of_range
    Region obstacleOffset(std::size_t index, double distance_mm) const;
    /// Diameter of the widest disc clear of the obstruction and centred in the target; the cutter that would
    /// fit. Infinite where nothing obstructs, 0 for an empty target. With open edges to within 0.01 mm.
    double widestCutterMm() const;
    /// Largest disc inside the target alone; nothing for an empty target.
    std::optional<ClearanceDiagram::Disc> widestDiscInTarget() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// A piece of what a tool's cutter could reach but for its shank or holder, and other tools can reach.
struct BlockedLump {
    Region region;  ///< its parts are nearer to each other than the cutter's diameter
    double area_mm2 = 0;
    /// Tools with all of it in their collision-free area [DSouza2006, eq. 21], by falling diameter. Empty
    /// when it takes several.
    std::vector<std::string> surrogates;
    std::string reason;  ///< what keeps the tool off, in words with the numbers
};

/// Areas of one tool in one feature [accessibility.md].
struct AccessibleArea {
    std::string tool_id;
    double radius_mm = 0;
    /// C_t: where the axis may stand, cutter clear of the obstruction, components without an entry left
    /// out. May leave the target over open edges [Yao2000].
    Region free_centres;
    /// One per component of `free_centres`, in the order of components().
    std::vector<Entry> entries;
    /// A_t = offset(C_t, r).
    Region accessible;
    /// A_t n T; of a tool with surrogates without what no tool at all reaches.
    Region coverable;
    /// Is `accessible` all a disc sweeps inside the target, so that pairs need no Booleans?
    bool opens_target = false;
    double accessible_area_mm2 = 0;  ///< within the target
    double coverable_area_mm2 = 0;
    double collision_free_area_mm2 = 0;  ///< A'_t within the target [DSouza2006, Alg. 3]
    double access_volume_mm3 = 0;        ///< coverable area x depth [Lim2000]
    /// What the axis keeps its radius from: the feature's obstruction, and around it where shank or holder
    /// would touch. Null: the feature's obstruction alone.
    std::shared_ptr<const Region> obstruction;
    /// Where shank or holder hold the tool off part of what its cutter could reach, in words with the
    /// numbers; empty when nothing does. Set by limitedArea().
    std::string limited;
    /// Where surrogates do part of the tool's area: A'_t with its own centres and entries, which is what the
    /// tool itself may do. Null: all of the above.
    std::shared_ptr<const AccessibleArea> clear_of_holder;
    std::vector<BlockedLump> blocked_lumps;  ///< what the surrogates do [tool-dag.md, 'Surrogates']
    /// Set when the tool cannot be used; the areas then tell what it could do without that.
    std::optional<Exclusion> excluded;
    /// What of `accessible` nobody clears: where surrogates do part of it, ground that none of them reaches.
    Region given_up;
    /// What the tool's passes clear for sure: the pairs that start with this tool shrink it.
    SureSweep swept;
};

/// A_t and its kin for one cutter. Never throws for a tool that does not fit: that is a result.
AccessibleArea accessibleArea(const FeatureGround& ground, const ToolAssembly& tool,
                              const std::string& material);

/// The areas of a tool that accessibleArea() excluded for collisions of its holder, shrunk to where the
/// holder is clear, with `limited` instead of `excluded`. Nothing when the tool was turned down for
/// something else, or when nothing is left for it.
std::optional<AccessibleArea> limitedArea(const FeatureGround& ground, const ToolAssembly& tool,
                                          const AccessibleArea& excluded);

/// How deep a tool can go in a feature before its shank or holder keeps it off some of its free centres.
struct Reach {
    double floor_z_mm = 0;    ///< lowest floor at which nothing is lost; the feature's own if that is
    double stick_out_mm = 0;  ///< what would do for the feature's own floor
};
Reach reachOf(const FeatureGround& ground, const ToolAssembly& tool, const AccessibleArea& area);

/// Stick-outs of a range are tried in steps of this [mm].
inline constexpr double kStickOutStepMm = 1;

/// The shortest stick-out of the tool's range, in whole steps from its shorter end, at which shank and holder
/// touch nothing while the axis is on the area's free centres and at its entries; the longest where none is
/// shorter. A tool without a range: its own. \pre a mill, its area made at the longest stick-out
double leastStickOutMm(const FeatureGround& ground, const ToolAssembly& tool, const AccessibleArea& area);

/// The same for every tool: the first of the range's steps at which `clears` the tool so set; longer ones do
/// too, so O(log steps) questions.
double leastStickOutMm(const ToolAssembly& tool, const std::function<bool(const ToolAssembly&)>& clears);

/// What tool n has to sweep after the larger tool m [accessibility.md, step 5].
struct DecomposedArea {
    /// C = C_n minus where n's disc lies in what m has swept: the centres n must visit.
    Region centres;
    /// D_mn = offset(C, r_n).
    Region area;
    /// Centres of n whose disc meets no material: swept by m before. Links and entries there are free.
    Region cleared_centres;
    /// Area of the target n newly clears [mm2].
    double new_area_mm2 = 0;
};

/// D_mn for a pair; `m` null stands for tool 0, nothing used yet: D_0n = A_n.
/// Empty when m reaches all that n does.
/// \pre m == nullptr or m->radius_mm >= n.radius_mm
DecomposedArea decomposedArea(const FeatureGround& ground, const AccessibleArea* m, const AccessibleArea& n);

}  // namespace stepmill
