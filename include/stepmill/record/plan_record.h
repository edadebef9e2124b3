#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// An operation as plan.json has it: all but its moves, which stand in the program.
using RecordedOperation = OperationSheet;

/// A feature, or one band of it, as plan.json has it: all but how its tools were chosen.
struct RecordedFeature {
    Feature feature;  ///< without boundary pieces and faces, which follow from the part
    std::vector<Residual> residual;
};

struct RecordedSetup {
    std::string id;
    Vec3 axis = Vec3::UnitZ();  ///< in part coordinates
    Eigen::Isometry3d part_to_setup = Eigen::Isometry3d::Identity();
    std::string axis_name;
    std::string program;  ///< file name
    Vec3 stock_size_mm = Vec3::Zero();
    std::vector<Fixture> fixtures;
    std::vector<Prism> reserve;  ///< stands for later setups; in setup coordinates
    Clamping clamping;           ///< without jaws, which are fixtures; of plans of older versions none
    double time_s = 0;
    std::optional<double> leaning_mm3;       ///< PlannedSetup::leaning_mm3
    std::vector<std::string> feature_ids;    ///< of all bands, parents before children
    FeatureNames names;                      ///< PlannedSetup::names
    std::vector<std::string> operation_ids;  ///< in machining order
    /// The machine travels as far as the programs go: all but those the plan warns of, which it has not got.
    bool within_travel = true;
    bool hasProgram() const { return within_travel && !operation_ids.empty(); }
};

/// A file the plan was made from; empty: none.
struct RecordedFile {
    std::string file;
    std::string sha256;
};

/// What was asked for that neither the part's file nor the library says.
struct RecordedRequest {
    int solid = 0;
    std::string unit;  ///< ReadOptions::unit
    StockMargin margin;
    RecordedFile stock;
    RecordedFile fixtures;
    RecordedFile holes;  ///< the hole table
    FinishAllowance finish;
    std::optional<FinishAllowance> roughing;  ///< PlanRequest::roughing
    std::vector<Vec3> axes;                   ///< SetupRequest::axes
    std::vector<Vec3> forbidden;              ///< SetupRequest::forbidden
    Objective objective = Objective::Time;
    SurrogateRule surrogates = SurrogateRule::Sequence;
    int quantity = 1;  ///< PlanRequest::quantity
    double scallop_mm = kUsualScallopMm;
    double break_edges_mm = 0;
    bool reserve = true;                 ///< PlanRequest::assign
    std::vector<double> stock_sizes_mm;  ///< SetupRequest::stock_sizes_mm
    std::optional<Vise> vise;            ///< of plans of older versions none
    double plate_mm = kPlateThicknessMm;
    std::optional<HoldKind> hold;  ///< PlanRequest::hold
    std::vector<CycleTarget> cycle_times;
};

/// What plan.json says that programs are proven against.
struct PlanRecord {
    std::optional<RecordedRequest> request;  ///< none in plans of older versions
    RecordedFile library;
    double part_volume_mm3 = 0;
    double stock_volume_mm3 = 0;
    Stock stock;                                ///< kind, raw box and tolerance alone
    std::map<std::string, ToolAssembly> tools;  ///< by id; without cutting data
    std::string part_file;
    std::string part_sha256;
    std::string part_name;
    std::string material;
    CostModel cost_model = CostModel::Path;
    std::optional<Material> cut_material;  ///< what its cuts ask for; nothing: not known
    Machine machine;
    std::vector<RecordedSetup> setups;
    std::map<std::string, RecordedFeature> features;  ///< by id; every band is one
    std::map<std::string, FormGround> forms;          ///< by id; at most two a setup: leaning walls, edges
    std::map<std::string, RecordedOperation> operations;
    std::map<std::string, double> operation_s;  ///< the time of each, without the change to its tool
    PlanTotals totals;
    CycleTimes cycle;
    /// Axes and what came of choosing; `reserves` stand with the setups. Of plans of older versions no axes.
    Assignment assignment;
    VolumeBalance books;      ///< of the part
    int threads_missing = 0;  ///< Plan::threads_missing
    /// How much of what stays of stock minus part at the end is rounding [mm3].
    double rounding_mm3 = 0;
};

/// Reads a plan.json.
/// \throws Error(InvalidCatalog) with "plan.json#/json/pointer" as subject when it breaks
/// its schema or names an operation, feature or tool it does not have.
PlanRecord planRecordFromText(std::string_view text, const Tolerances& tol);

/// What a plan that is made after this one keeps of it.
std::vector<EarlierSetup> earlierSetups(const PlanRecord& record);

/// The same of which setup cuts what; nothing where the plan had no choice there, had no time to look at all
/// sets of setups, or does not tell.
std::optional<EarlierAssignment> earlierAssignment(const PlanRecord& record);

}  // namespace stepmill
