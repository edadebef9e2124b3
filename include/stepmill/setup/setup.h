#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/catalog/fixture.h"
#include "stepmill/part/part.h"
#include "stepmill/setup/prism.h"

namespace stepmill {

/// A solid to be cut, in part coordinates: a raw solid, less what setups have taken from it.
struct Stock {
    enum class Kind {
        Box,  ///< the part's box with margins
        Step  ///< from a file
    };
    Kind kind = Kind::Box;
    Box3 bbox_mm;                            ///< of what is left
    double volume_mm3 = 0;                   ///< of what is left
    std::shared_ptr<const PartShape> shape;  ///< the raw solid
    Box3 raw_bbox_mm;
    double tolerance_mm = 0;      ///< the raw solid may be this much larger on every side
    std::vector<CutPrisms> cuts;  ///< by setup, in the order they were made; empty: raw

    bool isRaw() const { return cuts.empty(); }
};

/// Extra material of a box stock over the part's bounding box, seen from the spindle of the (first)
/// setup [mm].
struct StockMargin {
    double side_mm = 0;
    double top_mm = 0;
    double bottom_mm = 0;
};

/// Tolerance of a box that nothing more is said of: sawn to length [mm].
inline constexpr double kSawnToleranceMm = 0.5;
/// A blank that may be larger by more is another blank [mm].
inline constexpr double kMostStockToleranceMm = 20;

/// What to plan on and from where.
struct SetupRequest {
    /// Tool axes asked for, unit vectors in part coordinates, in machining order; empty: choose.
    std::vector<Vec3> axes;
    /// Tool axes never to be chosen, unit vectors in part coordinates.
    std::vector<Vec3> forbidden;
    /// Form cutters finish from a setup what faces flat cutters leave steps on there: no further setup is
    /// chosen for these.
    bool steps_finished = false;
    StockMargin margin;
    /// Sizes that thickness and width of a box are rounded up to once it has its margins, ascending; its
    /// length, and what is over the last, to whole millimetres; empty: the box is as large as the margins
    /// make it.
    std::vector<double> stock_sizes_mm;
    /// How much larger on every side the blank may be than it is said to be [mm].
    double stock_tolerance_mm = 0;
    /// A solid to start from instead of a box, in the coordinates of the part's file.
    std::optional<Part> stock_part;
};

/// One clamping of the part.
///
/// Setup coordinates: z = 0 at the top of the stock as it arrives, pointing along the tool axis out of the
/// part; x = y = 0 at the stock's lower-left corner seen from the spindle (the corner of its box; work offset
/// G54).
struct Setup {
    std::string id;             ///< "S1"
    Vec3 axis = Vec3::UnitZ();  ///< in part coordinates
    Eigen::Isometry3d part_to_setup = Eigen::Isometry3d::Identity();
    Part part;
    /// As it arrives, in part coordinates. From chooseSetups: the raw stock in every setup; SetupWalk
    /// (plan/stages.h) replaces it by what the setups before left.
    Stock stock;
    Box3 stock_bbox_mm;        ///< in setup coordinates: min.z = -height, max.z = 0
    double removable_mm3 = 0;  ///< raw stock less part, in every setup: what all of them have to remove
    /// What holds the part, grown [holdStage(), plan/hold_stage.h].
    std::vector<Fixture> fixtures;
    bool indexed = false;  ///< the axis is no direction of the part's box: needs a sine vise or a rotary axis
    bool chosen = false;  ///< found by chooseSetups, not asked for: may fall away when nothing is left for it
};

/// Do two unit vectors point the same way, within rounding in files (0.06 degrees)?
bool isSameAxis(const Vec3& a, const Vec3& b);

/// The setups to machine a part in, in order: the axes asked for, or few that together reach all removable
/// volume some axis reaches.
///
/// Candidates are the six box directions, normals of planes and both senses of cylinder and cone axes,
/// without the forbidden ones. Samples in front of the part's faces say what each reaches; branch and
/// bound looks for the set that reaches most volume and finishes most faces, less what every further setup
/// must pay. Order: indexed axes last; after the first, those first whose seat is the stock's skin or
/// machined by then; of these the one that takes most of what is left; within a tenth of that the one that
/// rests on the larger flat face; then +z, -z, +x, -x, +y, -y. A part with nothing to remove gets one setup.
///
/// Reach decides number and order only; no area or volume of the plan comes from it. Deterministic.
/// \return  at least one setup
/// \throws Error(Usage) if the stock does not contain the part, with where it sticks out and by how much, or
///         if every axis is forbidden.
/// \note  A ray for every sample and candidate axis, in parallel. The search is exact where no axis is
///        indexed or `steps_finished` is set; else sets that an indexed axis could follow are given up
///        sooner. After 20000 sets it ends with the best so far, as it does on sculpted parts with dozens of
///        axes.
/// \see docs/algorithms/setups.md
std::vector<Setup> chooseSetups(const Part& part, const SetupRequest& request);

/// Directions of the part's faces, no box directions, that chooseSetups() has no room for: it takes those of
/// the largest faces.
std::size_t axesNotWeighed(const Part& part);

/// Sets of setups that sight does not tell from the chosen one, none on another stock.
struct OtherSetups {
    /// The chosen ones in the order that leaves the least steps on what later ones finish; empty where that
    /// is theirs.
    std::vector<Setup> least_steps;
    /// Those chosen where one of the axes is not to be had, as far as they take no longer to set up and see
    /// about as much of the part, the quickest to set up first; then the chosen ones in further orders:
    /// opposite axes the other way round, the second axis first.
    std::vector<std::vector<Setup>> further;
};

/// The sets beside the chosen one, for whole plans to be weighed.
///
/// \param chosen  what chooseSetups() gave for the request, which asks for no axes
/// \note  As long as chooseSetups().
OtherSetups otherSetups(const Part& part, const SetupRequest& request, const std::vector<Setup>& chosen);

/// Where something stays that no tool of a setup got to.
struct UnreachedPlace {
    Vec3 at;    ///< in part coordinates, as ...
    Vec3 axis;  ///< ... the setup's
    double volume_mm3 = 0;
};

/// Setups with one more behind them.
struct AddedSetup {
    std::vector<Setup> setups;
    double free_mm3 = 0;  ///< volume at the places that the last one may get to
};

/// The setups with one more: along each direction of the part's box that is not among theirs and from which
/// some of the places are free of the part and lie less deep in the raw stock.
///
/// \return  the most volume first; empty where there is no such direction
std::vector<AddedSetup> withOneMore(const Part& part, const SetupRequest& request,
                                    const std::vector<Setup>& setups,
                                    const std::vector<UnreachedPlace>& places);

/// The setup on another stock: work offset and box moved to it.
Setup onStock(const Setup& setup, const Stock& stock);

/// "+z" ... "-x", or "x,y,z" numbers of at most 1e6; nothing when the text is neither.
std::optional<Vec3> parseAxis(const std::string& text);
/// "+z" and so on for box directions, "x,y,z" with 4 decimals for others.
std::string axisName(const Vec3& axis);

}  // namespace stepmill
