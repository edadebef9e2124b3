#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
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
    /// Does some stretch of the target keep the width of that disc, within the fit tolerance?
    bool hasSlotOf(double radius_mm) const;
    /// Points a disc of that radius sweeps inside T.
    Region targetOpening(double radius_mm) const;
    /// Centres left inside T to a disc of radius `small` after one of radius `large`.
    Region targetRestCentres(double large_mm, double small_mm) const;
    /// The section of feature().obstacles[index], offset.
    /// \throws std::out_of_range
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

/// What a disc can do in a feature: where its centre may stand and what it covers from there
/// [docs/algorithms/accessibility.md]. A plain value; copies share what is made lazily.
struct CutterArea {
    double radius_mm = 0;
    /// C_t: where the axis may stand, cutter clear of the obstruction, components without an entry left
    /// out. May leave the target over open edges [Yao2000].
    Region free_centres;
    /// One per component of `free_centres`, in the order of components().
    std::vector<Entry> entries;
    /// Of the components that stand for slots as wide as the cutter: their middles, of slots that cross
    /// several in a component. The axis goes nowhere else there; the components are strips around them, wide
    /// enough to count as material.
    std::vector<Path> slot_middles;
    /// A_t = offset(C_t, r).
    Region accessible;
    /// A_t n T, less ground that is given up.
    Region coverable;
    double coverable_area_mm2 = 0;
    double access_volume_mm3 = 0;  ///< coverable area x depth of the feature [Lim2000]
    /// Is `accessible` all a disc sweeps inside the target, so that pairs need no Booleans?
    bool opens_target = false;
    /// What the axis keeps its radius from, where that is more than the feature's obstruction.
    std::optional<SharedRegion> wider_obstruction;
    /// What its passes clear for sure: the pairs that start with this tool shrink it.
    SureSweep swept;

    /// What the axis keeps its radius from.
    const SharedRegion& obstructionIn(const Feature& feature) const {
        return wider_obstruction ? *wider_obstruction : feature.obstruction;
    }
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

/// The tool does all that its cutter reaches: shank and holder are clear everywhere.
struct Unhindered {};

/// Shank or holder keep the tool off part of what its cutter reaches, and nobody stands in for it there.
struct Limited {
    /// A'_t with its own centres and entries: what the tool does [DSouza2006, Alg. 3].
    CutterArea whole_tool;
    std::string why;  ///< what is in the way, with the numbers
};

/// Shank or holder keep the tool off part of what its cutter reaches, and surrogates clear that part.
struct WithSurrogates {
    CutterArea whole_tool;  ///< A'_t: what the tool itself does
    /// What tool and surrogates do together: all that its cutter reaches, but for ground that no tool
    /// reaches.
    CutterArea together;
    std::vector<BlockedLump> lumps;  ///< what the surrogates do [docs/algorithms/tool-dag.md]
};

/// What one tool can do in one feature: what its cutter reaches, and what shank and holder make of that.
struct ToolReach {
    std::string tool_id;
    CutterArea cutter;                   ///< A_t: the cutter alone
    double collision_free_area_mm2 = 0;  ///< A'_t within the target: the whole tool [DSouza2006, Alg. 3]
    /// How the tool takes part; an Exclusion where it takes none.
    std::variant<Unhindered, Limited, WithSurrogates, Exclusion> use;

    /// Null where the tool takes part in another way.
    const Exclusion* exclusion() const { return std::get_if<Exclusion>(&use); }
    const Limited* limited() const { return std::get_if<Limited>(&use); }
    const WithSurrogates* surrogates() const { return std::get_if<WithSurrogates>(&use); }

    /// What the tool itself does; of an excluded tool what its cutter could do.
    const CutterArea& own() const;
    /// What is cleared when the tool and its surrogates are done; of an excluded tool as own().
    const CutterArea& cleared() const;
};

/// What the tool can do. Turns it down with the first thing that rules it out, but tells what it could do
/// without that: a holder in the way somewhere is an Exclusion here, which collisionFreeArea() may lift.
/// \return  Limited and WithSurrogates are never among the results. A tool that does not fit is a result, not
///          an error, with empty areas.
/// \see docs/algorithms/accessibility.md for the figures
ToolReach toolReach(const FeatureGround& ground, const ToolAssembly& tool, const std::string& material);

/// A'_t: the areas of a tool that toolReach() excluded for collisions of its holder, shrunk to where the
/// holder is clear. Nothing when the tool was turned down for something else, or when nothing is left for it.
std::optional<CutterArea> collisionFreeArea(const FeatureGround& ground, const ToolAssembly& tool,
                                            const ToolReach& reach);

/// The reach of a tool that is Limited to this.
ToolReach limitedTo(const ToolReach& excluded, CutterArea whole_tool);

/// How deep a tool can go in a feature before its shank or holder keeps it off some of its free centres.
struct DepthLimit {
    double floor_z_mm = 0;    ///< lowest floor at which nothing is lost; the feature's own if that is
    double stick_out_mm = 0;  ///< what would do for the feature's own floor
};
DepthLimit depthLimitOf(const FeatureGround& ground, const ToolAssembly& tool, const CutterArea& area);

/// Stick-outs of a range are tried in steps of this [mm].
inline constexpr double kStickOutStepMm = 1;

/// The shortest stick-out of the tool's range, in whole steps from its shorter end, at which shank and holder
/// touch nothing while the axis is on the area's free centres and at its entries; the longest where none is
/// shorter. A tool without a range: its own.
/// \pre a mill, its area made at the longest stick-out
double leastStickOutMm(const FeatureGround& ground, const ToolAssembly& tool, const CutterArea& area);

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
DecomposedArea decomposedArea(const FeatureGround& ground, const CutterArea* m, const CutterArea& n);

}  // namespace stepmill
