#include "report/viewer/viewer_data.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include "report/page/element.h"
#include "report/page/program_lines.h"
#include "report/page/words.h"
#include "report/viewer/packed_path.h"
#include "report/viewer/part_mesh.h"
#include "report/viewer/stock_field.h"
#include "stepmill/catalog/cutter_form.h"
#include "stepmill/catalog/json_values.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/sequence/drilling.h"

namespace stepmill::report {
namespace {

using json::Json;

/// Cells along the longer side of a stock.
constexpr int kCells = 400;
/// Straight moves become one where the way stays so near [mm], ...
constexpr double kFinestTolerance = 0.01;
/// ... or as much farther as keeps all paths of a plan below this; each try is so much coarser.
constexpr std::size_t kMostPathBytes = 5'000'000;
constexpr double kCoarser = 2;
constexpr int kMostTries = 7;
/// Chords of outlines as a share of the stock's diagonal.
constexpr double kChordShare = 2e-4;
/// Classes of load: of a quarter of the diameter in material, and of a tenth of the spindle's power.
constexpr int kWidthClasses = 4;
constexpr int kPowerClasses = 10;
/// Loads this little over the end of a class are still in it.
constexpr double kSameLoad = 1e-4;
/// Points of a cutter's outline between tip and full radius.
constexpr int kFormPoints = 10;

Json partJson(const FacetedPart& part) {
    const PartMesh mesh = partMesh(part);
    return {{"corners", mesh.corners},
            {"triangles", mesh.triangles},
            {"low", json::point(mesh.box_mm.min())},
            {"high", json::point(mesh.box_mm.max())},
            {"places", mesh.places.text()},
            {"sides", mesh.sides.text()}};
}

/// The cutter's outline from its tip up, as [radius, height].
Json formJson(const ToolAssembly& tool) {
    const double radius_mm = tool.radius_mm();
    if (tool.isDrill() || tool.isSpot())
        return Json::array(
            {Json::array({0, 0}), Json::array({json::number(radius_mm), json::number(pointLengthMm(tool))})});
    const CutterForm form(tool);
    Json outline = Json::array();
    for (int i = 0; form.heightMm() > 0 && i < kFormPoints; ++i) {
        // Closer together at the tip, where a ball turns most.
        const double share = static_cast<double>(i) / kFormPoints;
        const double height_mm = share * share * form.heightMm();
        outline.push_back({json::number(form.radiusAt(height_mm)), json::number(height_mm)});
    }
    outline.push_back({json::number(form.fullRadiusMm()), json::number(form.heightMm())});
    return outline;
}

Json cylinderJson(const HolderCylinder& cylinder) {
    return Json::array({json::number(cylinder.diameter_mm), json::number(cylinder.bottom_mm),
                        json::number(cylinder.top_mm)});
}

Json toolJson(const ToolAssembly& tool) {
    return {{"id", plainLine(tool.id)},
            {"number", tool.number},
            {"type", toString(tool.type)},
            {"words", plainLine(tool.description)},
            {"diameter", json::number(tool.diameter_mm)},
            {"form", formJson(tool)},
            {"flutes", json::number(tool.flute_length_mm)},
            {"shank", cylinderJson(tool.shank)},
            {"holder", json::listOf(tool.holder, cylinderJson)}};
}

/// Heights as runs: how many cells, and how much higher than the run before.
std::string packedHeights(const std::vector<double>& heights_mm) {
    PackedBytes bytes;
    std::int64_t before = 0;
    for (std::size_t i = 0; i < heights_mm.size();) {
        const std::int64_t height = packedSteps(heights_mm[i]);
        std::size_t end = i;
        while (end < heights_mm.size() && packedSteps(heights_mm[end]) == height)
            ++end;
        bytes.number(static_cast<std::int64_t>(end - i));
        bytes.number(height - before);
        before = height;
        i = end;
    }
    return bytes.text();
}

Json stockJson(const Setup& setup) {
    const StockField field = arrivingField(setup, kCells);
    return {{"low", json::point(setup.stock_bbox_mm.min())},
            {"high", json::point(setup.stock_bbox_mm.max())},
            {"columns", field.columns},
            {"rows", field.rows},
            {"cell", field.cell_mm},
            {"top", packedHeights(field.top_mm)},
            {"bottom", packedHeights(field.bottom_mm)}};
}

Json placementJson(const Eigen::Isometry3d& part_to_setup) {
    Json numbers = Json::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            numbers.push_back(part_to_setup.matrix()(row, column) + 0.0);  // of -0 makes 0
    return numbers;
}

Json bandJson(const PlannedFeature& planned, double chord_mm) {
    const Feature& feature = planned.feature;
    return {{"id", feature.id},
            {"top", json::number(feature.top_z_mm)},
            {"floor", json::number(feature.floor_z_mm)},
            {"loops", packed(feature.target, chord_mm).text()},
            {"stays", json::listOf(planned.sequence.residual, [&](const Residual& residual) {
                 return packed(residual.region, chord_mm).text();
             })}};
}

/// A move's class: how wide it cuts and how much of the spindle's power it takes, each rounded up; 0 in air.
std::uint8_t loadClass(const MoveLoad& load, double most_kw) {
    const auto upTo = [](double share, int classes) {
        return std::clamp(static_cast<int>(std::ceil(share * classes - kSameLoad)), 0, classes);
    };
    const int width = upTo(load.width_share, kWidthClasses);
    const int power = most_kw > 0 ? upTo(load.power_kw / most_kw, kPowerClasses) : 0;
    return static_cast<std::uint8_t>(width * (kPowerClasses + 1) + power);
}

std::vector<std::uint8_t> loadClasses(const Operation& operation, double most_kw) {
    std::vector<std::uint8_t> classes;
    for (const MoveLoad& load : operation.loads)
        classes.push_back(loadClass(load, most_kw));
    return classes;
}

double mostPowerKw(const Machine& machine) {
    double most_kw = 0;
    for (const SpindlePoint& point : machine.spindle_curve)
        most_kw = std::max(most_kw, point.power_kw);
    return most_kw;
}

/// What is made of a plan's setups, one after another.
class SetupsData {
  public:
    SetupsData(const ProvenPlan& proven, double tolerance_mm)
        : proven_(proven), tolerance_mm_(tolerance_mm) {}

    Json listed() {
        return json::listOf(proven_.plan.setups,
                            [this](const PlannedSetup& setup) { return setupJson(setup); });
    }

  private:
    /// Held stock is shown as stock.
    static Json fixturesJson(const Setup& setup, double chord_mm) {
        Json fixtures = Json::array();
        for (const Fixture& fixture : setup.fixtures)
            if (fixture.kind != FixtureKind::HeldStock)
                fixtures.push_back({{"name", plainLine(fixture.name)},
                                    {"bottom", json::number(fixture.bottom_z_mm)},
                                    {"top", json::number(fixture.top_z_mm)},
                                    {"loops", packed(fixture.section, chord_mm).text()}});
        return fixtures;
    }

    Json setupJson(const PlannedSetup& planned) const {
        const Setup& setup = planned.setup;
        const double chord_mm = kChordShare * setup.stock_bbox_mm.diagonal().norm();
        return {{"id", setup.id},
                {"placement", placementJson(setup.part_to_setup)},
                {"stock", stockJson(setup)},
                {"fixtures", fixturesJson(setup, chord_mm)},
                {"features", json::listOf(wholeFeatures(planned.features),
                                          [&](const WholeFeature<PlannedFeature>& whole) {
                                              return featureJson(whole, chord_mm);
                                          })},
                {"operations", operationsJson(planned)}};
    }

    static Json featureJson(const WholeFeature<PlannedFeature>& whole, double chord_mm) {
        return {{"id", whole.id()},
                {"class", toString(whole.featureClass())},
                {"anchor", Anchor("feature", whole.id()).id()},
                {"bands", json::listOf(whole.bands, [&](const PlannedFeature* band) {
                     return bandJson(*band, chord_mm);
                 })}};
    }

    Json operationsJson(const PlannedSetup& setup) const {
        const PostedProgram* program = programOf(proven_, setup);
        return json::listOf(setup.operations, [&](const Operation& operation) {
            return operationJson(operation, placeOf(program, operation.id));
        });
    }

    Json operationJson(const Operation& operation, const ProgramPlace& place) const {
        const Toolpath& path = operation.path;
        const PackedPath moves =
            packed(path, tolerance_mm_, loadClasses(operation, mostPowerKw(proven_.plan.machine)));
        Json feeds = Json::array();
        for (const MoveKind kind :
             {MoveKind::Rapid, MoveKind::Feed, MoveKind::Slot, MoveKind::Ramp, MoveKind::Plunge})
            feeds.push_back(json::number(kind == MoveKind::Rapid ? proven_.plan.machine.rapid_mm_per_min
                                                                 : path.feedOf(kind)));
        return {{"id", operation.id},
                {"feature", operation.feature_id},
                {"tool", plainLine(operation.tool_id)},
                {"role", toString(operation.role)},
                {"pattern", path.pattern},
                {"anchor", Anchor("operation", operation.id).id()},
                {"feeds", feeds},
                {"fastest", json::number(fastestFeed(path))},
                {"rpm", json::number(operation.speed_rpm)},
                {"moves", moves.moves},
                {"path", moves.bytes.text()},
                {"loads", moves.loads.text()},
                {"file", place.file},
                {"line", place.line},
                {"program", plainText(place.text)}};
    }

    const ProvenPlan& proven_;
    double tolerance_mm_;
};

/// The finest at which all paths of the plan fit a page.
double pathTolerance(const Plan& plan) {
    double tolerance_mm = kFinestTolerance;
    for (int tries = 0; tries < kMostTries; ++tries, tolerance_mm *= kCoarser) {
        std::size_t bytes = 0;
        for (const PlannedSetup& setup : plan.setups)
            for (const Operation& operation : setup.operations)
                bytes += packed(operation.path, tolerance_mm, {}).bytes.size();
        if (bytes <= kMostPathBytes) break;
    }
    return tolerance_mm;
}

Json toolsJson(const Plan& plan) {
    std::set<std::string> used;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations)
            used.insert(operation.tool_id);
    Json tools = Json::array();
    for (const ToolAssembly& tool : plan.library.tools)
        if (used.contains(tool.id)) tools.push_back(toolJson(tool));
    return tools;
}

}  // namespace

std::string viewerData(const ProvenPlan& proven, const FacetedPart& part, bool inch) {
    const Plan& plan = proven.plan;
    const Json data{{"step", kPackedStepMm},
                    {"inch", inch},
                    {"part", partJson(part)},
                    {"power_classes", kPowerClasses},
                    {"width_classes", kWidthClasses},
                    {"tools", toolsJson(plan)},
                    {"setups", SetupsData(proven, pathTolerance(plan)).listed()}};
    return data.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace stepmill::report
