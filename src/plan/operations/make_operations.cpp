#include "plan/operations/make_operations.h"

#include <map>

#include <fmt/format.h>

#include "plan/operations/earlier_operations.h"
#include "plan/order/early_starts.h"
#include "plan/order/order_operations.h"
#include "stepmill/core/units.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/setup/stock_growth.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill {
namespace {

/// What the cutting data say beyond feeds and speeds.
void takeShopData(Operation& operation, const ToolLibrary& library, const std::string& material) {
    const CuttingData* cutting = library.tool(operation.tool_id).cuttingFor(material);
    if (cutting == nullptr) return;
    operation.coolant = cutting->coolant;
    if (isForHoles(operation.role) && operation.role != Role::Tap)
        operation.dwell_s = cutting->dwell_s;
    else if (operation.role != Role::Tap)
        operation.ramp_angle_deg = toolpath::rampAngleDeg(*cutting);
}

bool takesPlainWays(const std::string& feature_id, const Cautions& cautions) {
    const auto caution = cautions.find(feature_id);
    return caution != cautions.end() && caution->second.plain_ways;
}

/// The step's path moves to the operation.
/// \param stock_top_mm  how high the stock may stand in the setup
Operation operationOf(PlannedFeature& planned, SequenceStep& step, double stock_top_mm,
                      const OperationSettings& settings) {
    Operation operation;
    operation.setup_id = planned.feature.setup_id;
    operation.feature_id = planned.feature.id;
    operation.tool_id = step.tool_id;
    operation.role = step.role;
    operation.path = std::move(step.path);
    // Tools for holes come with cycles, whose rapids stay over or in the hole.
    if (!isForHoles(operation.role) && takesPlainWays(operation.feature_id, settings.cautions))
        operation.path = withPlainRapids(operation.path, stock_top_mm, settings.machine);
    operation.proof = step.proof;
    operation.leaves = step.leaves;
    operation.z_floor_mm = planned.sequence.floor_z_mm + step.leaves.floors_mm;
    if (step.thread) operation.z_floor_mm = step.thread->tip_z_mm;
    operation.z_top_mm = step.role == Role::Finish
                             ? operation.z_floor_mm + operation.path.depths * operation.path.step_down_mm
                             : planned.feature.top_z_mm;
    operation.speed_rpm = step.speed_rpm;
    operation.engagement_deg = radToDeg(operation.path.engagement_rad);
    operation.holes = step.holes;
    operation.thread = step.thread;
    operation.fit = step.fit;
    operation.takes = step.takes;
    takeShopData(operation, settings.library, settings.material);
    if (operation.path.step_over_mm > 0)
        operation.even_length_mm =
            step.area.new_area_mm2 / operation.path.step_over_mm * operation.path.depths;
    step.path = Toolpath{};
    return operation;
}

ToolAssembly setOutFor(const SequenceStep& step, const ToolLibrary& library) {
    const ToolAssembly& tool = library.tool(step.tool_id);
    return tool.stick_out_range ? setTo(tool, step.least_stick_out_mm) : tool;
}

/// The operations of a setup's feature, from `first` on.
FeatureOperations operationsOf(const PlannedFeature& planned, const Operation* first,
                               const StockGrowth& growth, const OperationSettings& settings) {
    FeatureOperations found;
    found.planned = &planned;
    found.target = targetOnGrownStock(planned.feature, growth, settings.tol);
    found.plain_ways = takesPlainWays(planned.feature.id, settings.cautions);
    for (const SequenceStep& step : planned.sequence.steps)
        found.operations.push_back({first++, setOutFor(step, settings.library), step.area.area});
    return found;
}

/// Operations on lower features need not wait until those above are wholly cut.
/// \param first  where the setup's operations begin
void letStartEarly(const PlannedSetup& setup, std::size_t first, const OperationSettings& settings,
                   std::vector<Operation>& operations) {
    const StockGrowth growth = growthOf(setup.setup.stock, setup.setup.part_to_setup);
    std::vector<FeatureOperations> features;
    std::size_t next = first;
    for (const PlannedFeature& planned : setup.features) {
        features.push_back(operationsOf(planned, operations.data() + next, growth, settings));
        next += planned.sequence.steps.size();
    }
    for (EarlyStarts& of_feature : earlyStarts(features, settings.tol))
        for (std::vector<Wait>& waits : of_feature)
            operations[first++].waits = std::move(waits);
}

/// Where the operations stood in the plan before; empty without one.
EarlierPlaces placesBefore(const std::vector<Operation>& operations, const std::vector<std::size_t>& setup_of,
                           const std::vector<PlannedSetup>& setups,
                           const std::vector<EarlierSetup>& earlier) {
    if (earlier.empty()) return {};
    std::vector<EarlierOperations> before;
    before.reserve(setups.size());
    for (const PlannedSetup& setup : setups)
        before.emplace_back(setup, earlier);
    EarlierPlaces places;
    for (std::size_t i = 0; i < operations.size(); ++i)
        places.push_back(before[setup_of[i]].find(operations[i]));
    return places;
}

}  // namespace

std::string operationId(const std::string& setup_id, std::size_t number) {
    return fmt::format("{}.O{}", setup_id, number);
}

std::vector<PlannedSetup> withOperations(std::vector<PlannedSetup> setups,
                                         const OperationSettings& settings) {
    std::vector<Operation> operations;
    std::vector<std::size_t> setup_of;
    std::vector<std::size_t> first_of_setup;
    for (std::size_t s = 0; s < setups.size(); ++s) {
        first_of_setup.push_back(operations.size());
        const Setup& setup = setups[s].setup;
        const double top_mm = growthOf(setup.stock, setup.part_to_setup).top_mm;
        for (PlannedFeature& planned : setups[s].features) {
            for (SequenceStep& step : planned.sequence.steps) {
                operations.push_back(operationOf(planned, step, top_mm, settings));
                setup_of.push_back(s);
            }
        }
    }
    for (std::size_t s = 0; s < setups.size(); ++s)
        letStartEarly(setups[s], first_of_setup[s], settings, operations);
    const ShortestOrder shortest = shortestOrder(
        operations, inSetupOrder(setups), placesBefore(operations, setup_of, setups, settings.earlier));
    std::vector<EarlierOperations> before;
    before.reserve(setups.size());
    for (const PlannedSetup& setup : setups)
        before.emplace_back(setup, settings.earlier);
    for (std::size_t s = 0; s < setups.size(); ++s)
        if (s < shortest.weighed.size()) setups[s].orders = shortest.weighed[s];
    for (const int index : shortest.order) {
        PlannedSetup& setup = setups[setup_of[index]];
        setup.operations.push_back(std::move(operations[index]));
        setup.operations.back().id = before[setup_of[index]].idOf(setup.operations.back());
    }
    for (PlannedSetup& setup : setups)
        linkOperations(setup.operations, settings.machine);
    return setups;
}

}  // namespace stepmill
