#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/record/plan_files.h"

namespace stepmill {

/// What became of something of a plan in the plan made after it.
enum class Change {
    Kept,     ///< the same, and the same lines of program
    Changed,  ///< still there, another
    New,
    Dropped
};
std::string toString(Change change);

/// Why a feature is another.
enum class ChangeCause {
    Ground,        ///< its target, at some depth
    Depth,         ///< its top or floor
    Kind,          ///< its class
    Surroundings,  ///< what must stay, or what shanks and holders keep clear of
    Tools,         ///< other tools, or in another order
    Path           ///< the same tools on other moves, or at other feeds
};
std::string toString(ChangeCause cause);

/// An operation as one of the two plans has it.
struct OperationThen {
    int place = 0;  ///< in the order of its setup, from 1
    std::string tool;
    int number = 0;  ///< its T word
    double time_s = 0;
    std::vector<std::string> lines;  ///< of the program, without block numbers
};

struct OperationChange {
    std::string id;
    std::string setup_id;
    std::string feature_id;  ///< of the whole feature
    Role role = Role::Rough;
    Change change = Change::Kept;
    std::optional<OperationThen> before;  ///< nothing for a new one
    std::optional<OperationThen> after;   ///< nothing for one that is dropped
    int lines_kept = 0;                   ///< at its beginning and end
};

/// A whole feature as one of the two plans has it.
struct FeatureThen {
    FeatureClass feature_class = FeatureClass::ClosedPocket;
    double top_z_mm = 0;
    double floor_z_mm = 0;
    double volume_mm3 = 0;
    Region target;                   ///< of all bands, from above
    std::vector<std::string> tools;  ///< in the order of its operations
    double time_s = 0;               ///< of its operations, without tool changes
};

struct FeatureChange {
    std::string id;
    std::string setup_id;
    Change change = Change::Kept;
    std::vector<ChangeCause> causes;  ///< of one that changed
    std::optional<FeatureThen> before;
    std::optional<FeatureThen> after;
    double more_mm2 = 0;  ///< ground that it has and had not
    double less_mm2 = 0;
};

/// The programs of a setup.
struct ProgramChange {
    std::string setup_id;
    Change change = Change::Kept;  ///< kept: the same operations in the same order, with the same lines
    int lines_before = 0;
    int lines_after = 0;
    int lines_kept = 0;       ///< those of its operations
    bool same_bytes = false;  ///< heads too, which name the part file
};

/// Something else that was planned with and is another.
struct InputChange {
    std::string what;  ///< "tool library", "machine /hourly_rate", "material"
    std::string before;
    std::string after;
};

/// A plan beside the one it was made after.
struct PlanChange {
    RecordedFile part_before;
    RecordedFile part_after;
    std::vector<InputChange> inputs;
    std::string currency;
    PlanTotals before;
    PlanTotals after;
    CycleTimes cycle;  ///< of the new plan
    std::vector<ProgramChange> programs;
    std::vector<FeatureChange> features;      ///< in the order of the new plan, dropped ones after
    std::vector<OperationChange> operations;  ///< the same

    /// Every program is kept.
    bool sameMachining() const;
};

/// Compares two plans by what they were written with: features, operations and programs, by ids.
/// \throws what readPrograms does
PlanChange comparePlans(const RecordedPlan& before, const RecordedPlan& after, const Tolerances& tol);

}  // namespace stepmill
