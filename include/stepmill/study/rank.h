#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/layers/layer_stack.h"
#include "stepmill/part/part.h"
#include "stepmill/sequence/advice/purchase.h"
#include "stepmill/sequence/advice/ranking.h"
#include "stepmill/sequence/advice/sensitivity.h"
#include "stepmill/setup/setup.h"
#include "stepmill/study/missing_tools.h"

namespace stepmill {

/// What to rank of a part, beside the table itself.
struct RankRequest {
    SetupRequest setup;
    SliceOptions slicing;
    SequenceOptions sequence;
    std::string feature;  ///< id; empty: all features of the part together
    HoleTable holes;      ///< what is to become of holes: purchases serve that too
    /// Seconds a tool change takes in the table; nothing: the machine's. The sensitivity and the purchases
    /// keep the machine's.
    std::optional<double> tool_change_s;
    std::optional<Parameter> sensitivity;
    bool purchases = false;
};

/// The cheapest sequences of a feature over all values of a parameter.
struct FeatureSensitivity {
    std::string feature_id;
    std::vector<BestSequence> ranges;
    std::string failure;  ///< why it could not be sequenced; empty when it could
};

/// What would help a feature.
struct FeaturePurchase {
    PurchaseAdvice advice;
    std::string failure;  ///< why it could not be sequenced; empty when it could
};

struct Sensitivity {
    Parameter parameter = Parameter::ToolChange;
    double now = 0;    ///< the machine's or the library's value
    std::string unit;  ///< "s", "EUR/h", "x library price"
    Objective objective = Objective::Time;
    std::string currency;
    std::vector<FeatureSensitivity> features;
};

/// The papers' views of a table or a part.
struct RankReport {
    bool is_part = false;
    std::string file;      ///< name without folder
    std::string feature;   ///< empty: all, or a table
    std::string material;  ///< empty for a table
    Ranking ranking;
    std::optional<Sensitivity> sensitivity;
    std::optional<std::vector<FeaturePurchase>> purchases;
    std::vector<DrillRow> drills;      ///< of a part: what each does in its holes
    std::vector<MissingTool> missing;  ///< with the purchases: what else the part asks for
};

/// Ranks the cutters of a library for a part. Features are those a plan would start with, each setup on the
/// stock the ones before it leave when all their features are cut whole. A feature that cannot be sequenced
/// does not end the run: its entry says why.
/// \param progress  told of each stage
/// \throws Error(Usage) if there is no such feature, naming those there are; what chooseSetups and
///         SetupWalk::next throw
RankReport rankPart(const Part& part, const RankRequest& request, const ToolLibrary& library,
                    const Machine& machine, const Tolerances& tol,
                    const std::function<void(const std::string& stage, double share)>& progress = {});

}  // namespace stepmill
