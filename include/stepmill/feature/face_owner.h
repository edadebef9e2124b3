#pragma once

#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/feature/feature.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/part/face_graph.h"

namespace stepmill {

/// How much of a part face a feature makes.
struct FaceShare {
    int face = 0;
    int feature = 0;       ///< place in FeatureSet::features
    double share = 0;      ///< of the face's samples (0..1]
    bool leaning = false;  ///< the feature lies above the face, whose slope it leaves standing
};

/// Faces in front of which a feature removes stock, as samples of the faces show it; fills Feature::faces.
/// A face of which every sample is someone else's, or still buried, is in no feature. A leaning face belongs
/// to the feature right above it, where the part is not between.
///
/// \param part_to_setup  of the setup the features were found in
/// \param layers         of that setup
/// \return  ordered by face, then feature
/// \note  O(samples x features) tests of points in boxes, few of them in regions.
std::vector<FaceShare> assignFaces(const FaceGraph& graph, const Eigen::Isometry3d& part_to_setup,
                                   const LayerStack& layers, FeatureSet& found);

/// Faces that lie on the skin of the setup's stock: nothing is to be removed in front of them.
/// \param layers  of the first setup, for the raw stock
std::vector<bool> facesOnStock(const FaceGraph& graph, const Eigen::Isometry3d& part_to_setup,
                               const LayerStack& layers);

}  // namespace stepmill
