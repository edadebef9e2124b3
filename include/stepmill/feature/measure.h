#pragma once

#include <optional>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/feature/feature.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/part/face_graph.h"

namespace stepmill {

/// Two walls that come close: no wider cutter gets through.
struct Neck {
    double width_mm = 0;
    Vec2 at = Vec2::Zero();
};

/// Material between a feature and what is cut on its other side.
struct WallThickness {
    double thickness_mm = 0;  ///< where it is thinnest
    double height_mm = 0;     ///< how high it stands about as thin as that
    Vec2 at = Vec2::Zero();   ///< on the feature's side
    bool thin = false;        ///< by kThinWallMm or kSlenderWall
};

/// What makes a feature easy or hard to cut.
struct FeatureMeasures {
    double width_mm = 0;  ///< widest disc inside the target; of a face or profile without walls too
    double depth_to_width = 0;
    std::vector<Neck> necks;              ///< between walls, by rising width
    std::vector<double> corner_radii_mm;  ///< distinct radii of inner corners, ascending
    bool sharp_corner = false;            ///< two walls meet without a radius
    double draft_deg = 0;                 ///< greatest lean of a wall; 0: all stand upright
    double floor_fillet_mm = 0;           ///< largest round between wall and floor
    std::optional<WallThickness> wall;    ///< nothing where no wall has an other side
};

/// A wall thinner than this bends under any cutter [mm].
inline constexpr double kThinWallMm = 0.8;
/// A wall more than this many times as high as thick wants a strategy of its own.
inline constexpr double kSlenderWall = 10;
/// Walls that lean more are slopes, not drafted walls [deg].
inline constexpr double kMostDraftDeg = 20;

/// Measures a feature. Faces that lean or round its floor come from Feature::faces.
/// \param layers  the setup's, the part's regions in them
/// \note  One clearance diagram of the target; rays from its walls against the part's edges.
/// \see docs/algorithms/features.md
FeatureMeasures measureFeature(const Feature& feature, const LayerStack& layers, const FaceGraph& graph,
                               const Eigen::Isometry3d& part_to_setup, const Tolerances& tol);

}  // namespace stepmill
