#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/feature/hole.h"
#include "stepmill/feature/measure.h"
#include "stepmill/feature/part_form.h"
#include "stepmill/plan/stages.h"

namespace stepmill {

/// A feature with what an estimator asks of it.
struct InspectedFeature {
    Feature feature;
    /// Nothing where the target could not be measured; a warning says why.
    std::optional<FeatureMeasures> measures;
    std::vector<std::string> holes;  ///< ids of the holes that it is a step of
};

/// One clamping with what is cut in it.
struct InspectedSetup {
    Setup setup;
    Clamping clamping;
    std::vector<InspectedFeature> features;  ///< parents before children
    /// What of arriving stock - part no feature of the setup owns; later setups may.
    std::vector<Unplanned> unplanned;
    StockStep stock;
    double gap_mm3 = 0;  ///< arriving stock - part less features and unplanned
};

/// One face of the part.
struct FaceRow {
    int index = 0;
    std::string step_name;
    std::string feature;  ///< id of the feature that makes most of it; empty: none does
    std::string form;     ///< id of its form; empty on the stock's skin
    /// "stock"; the name of a hole, chamfer, fillet or free form; else the feature's class; else "not
    /// machined".
    std::string face_class;
    std::optional<std::string> mfcad_class;
};

/// stock - part = what the features take + what stays, by name.
struct InspectedBooks {
    double stock_minus_part_mm3 = 0;
    double features_mm3 = 0;
    std::vector<ReasonVolume> left;  ///< after all setups
    /// Of stock - part, what no entry accounts for; 0 where that is rounding.
    double gapShare() const;
};

/// A part by what it takes to mill it, without tools.
struct Inspection {
    Part part;
    Stock stock;
    std::vector<InspectedSetup> setups;
    std::vector<Hole> holes;
    std::vector<PartForm> forms;
    std::vector<FaceRow> faces;  ///< one a part face, by index
    InspectedBooks books;
    std::vector<std::string> warnings;
};

struct InspectRequest {
    SetupRequest setup;
    SliceOptions slicing;
    /// Narrower pockets and slots are engravings [mm].
    double smallest_cutter_mm = 0;
};

/// Setups, features, forms, holes, faces and books of a part.
/// \param progress  told of each stage
/// \throws what chooseSetups and SetupWalk::next do
Inspection inspectPart(const Part& part, const InspectRequest& request, const Tolerances& tol,
                       const std::function<void(const std::string& stage, double share)>& progress = {});

}  // namespace stepmill
