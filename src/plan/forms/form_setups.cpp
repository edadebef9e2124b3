// Form operations, setup by setup.

#include "plan/forms/form_setups.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "plan/forms/edge_breaking.h"
#include "plan/forms/form_finishing.h"
#include "plan/forms/form_stairs.h"
#include "plan/operations/earlier_operations.h"
#include "plan/operations/make_operations.h"
#include "plan/operations/retract.h"
#include "stepmill/core/error.h"
#include "stepmill/feature/heights.h"
#include "stepmill/setup/stock_growth.h"

namespace stepmill {
namespace {

using Finish = std::function<std::optional<FormFinishing>(const FormSources&, const FormShop&)>;

/// Faces so near to the blank's are flush with it [mm].
constexpr double kFlushMm = 0.01;

/// One kind of form operations.
struct FormKind {
    std::string (*ground_id)(const std::string& setup_id);
    std::optional<FormGround> PlannedSetup::*ground;
    const char* stage;      ///< for the progress bar
    const char* otherwise;  ///< what is so where their planning fails
    Finish finish;
};

class FormSetups {
  public:
    FormSetups(const FormKind& kind, const PlanningShop& shop, std::vector<Warning>& warnings)
        : kind_(kind), shop_(shop), warnings_(warnings) {}

    void addTo(std::vector<PlannedSetup>& setups, const std::vector<PlannedStage>& stages,
               const Progress& progress) {
        Stock at_end = stages.back().left;
        for (std::size_t i = 0; i < setups.size(); ++i) {
            PlannedSetup& setup = setups[i];
            if (progress) progress(kind_.stage + setup.setup.id, 1);
            auto finishing =
                finish({setup.setup, stages[i].layers, stages[i].left, at_end, drilledPoints(setup)});
            if (!finishing) continue;
            at_end.cuts.push_back({setup.setup.part_to_setup, std::move(finishing->removed)});
            setup.*kind_.ground = std::move(finishing->ground);
            addOperations(finishing->operations, setup);
        }
    }

  private:
    static std::vector<Prism> drilledPoints(const PlannedSetup& setup) {
        std::vector<Prism> points;
        for (const PlannedFeature& planned : setup.features) {
            const Feature& hole = planned.feature;
            const std::vector<SequenceStep>& steps = planned.sequence.steps;
            const bool drilled = std::any_of(steps.begin(), steps.end(), [](const SequenceStep& step) {
                return step.role == Role::Drill && !step.takes.empty();
            });
            if (drilled) points.push_back({hole.target, hole.floor_z_mm, hole.floor_z_mm - hole.point_mm});
        }
        return points;
    }

    /// What keeps form cutters from a setup must not lose the plan.
    std::optional<FormFinishing> finish(const FormSources& sources) {
        const PlanRequest& request = shop_.request;
        const std::string id = kind_.ground_id(sources.setup.id);
        const FormShop forms{shop_.library,
                             shop_.machine,
                             request.sequence.material,
                             request.scallop_mm,
                             retractMm(sources.setup, request.sequence.retract_mm, shop_.machine),
                             shop_.cautionOf(id),
                             {},
                             request.patience.few_tools,
                             shop_.tol};
        try {
            return kind_.finish(sources, forms);
        } catch (const Error& error) {
            warnings_.push_back(
                {"planning-failed", id, fmt::format("{}: {}", kind_.otherwise, error.what())});
            return std::nullopt;
        }
    }

    void addOperations(std::vector<Operation>& operations, PlannedSetup& setup) {
        EarlierOperations before(setup, shop_.request.earlier);
        for (Operation& operation : operations) {
            operation.id = before.idOf(operation);
            setup.operations.push_back(std::move(operation));
        }
        linkOperations(setup.operations, shop_.machine);
    }

    const FormKind& kind_;
    const PlanningShop& shop_;
    std::vector<Warning>& warnings_;
};

/// What stays sharp, cause by cause.
void warnOfSharpEdges(const FormGround& ground, std::vector<Warning>& warnings) {
    std::map<std::string, std::vector<const SharpStretch*>> by_cause;
    for (const SharpStretch& stretch : ground.sharp)
        by_cause[stretch.why].push_back(&stretch);
    for (const auto& [why, stretches] : by_cause) {
        double sum_mm = 0;
        for (const SharpStretch* stretch : stretches)
            sum_mm += stretch->length_mm;
        const Vec3& at = stretches.front()->at;
        warnings.push_back(
            {"sharp-edge", ground.id,
             fmt::format("{:.4g} mm of edges stay sharp here, the first at X{:.3f} Y{:.3f} Z{:.3f}: {}",
                         sum_mm, at.x(), at.y(), at.z(), why),
             static_cast<int>(stretches.size())});
    }
}

/// Do faces of the part lie where the blank's raw ones may stand out?
bool hasRawFaces(const FormGround& ground, const StockGrowth& growth) {
    return std::any_of(ground.must_stand.begin(), ground.must_stand.end(), [&](const Obstacle& band) {
        if (growth.top_mm > 0 && band.top_z_mm >= -kSameWrittenHeightMm) return true;
        if (!growth.raw_sides_mm || band.section.empty()) return false;
        const Box2 box = boundingBox(band.section);
        const Vec2 low = box.min() - growth.raw_sides_mm->min();
        const Vec2 high = growth.raw_sides_mm->max() - box.max();
        return std::min(low.minCoeff(), high.minCoeff()) <= kFlushMm;
    });
}

/// A break is measured from the faces as drawn.
void warnOfRawFaces(const PlannedSetup& setup, std::vector<Warning>& warnings) {
    const StockGrowth growth = growthOf(setup.setup.stock, setup.setup.part_to_setup);
    if (!hasRawFaces(*setup.edges, growth)) return;
    warnings.push_back(
        {"raw-edge", setup.edges->id,
         "sides or top may still be raw and stand out: an edge beside them comes out wider by as "
         "much, as a step; mill them before, or measure the blank (--stock-tolerance 0)"});
}

/// The form cutters of the setup in the plan that this one is made after, where as much leans as then;
/// nothing: they are chosen.
std::optional<std::vector<std::string>> cuttersBefore(const Setup& setup, double leans_mm3,
                                                      const FeatureCaution& caution,
                                                      const PlanRequest& request) {
    if (!request.as_before || !request.assignment || !caution.why.empty()) return std::nullopt;
    const EarlierSetup* earlier = earlierOf(setup, request.earlier);
    if (earlier == nullptr || !earlier->leaning_mm3) return std::nullopt;
    if (std::abs(leans_mm3 - *earlier->leaning_mm3) >= leastFormGainMm3(leans_mm3)) return std::nullopt;
    std::vector<std::string> ids;
    for (const EarlierOperation& operation : earlier->operations) {
        if (operation.feature_id != formGroundId(setup.id)) continue;
        if (ids.empty() || ids.back() != operation.tool_id) ids.push_back(operation.tool_id);
    }
    return ids;
}

}  // namespace

bool finishesForms(const PlanningShop& shop) {
    const PlanRequest& request = shop.request;
    return request.scallop_mm > 0 && !request.roughing &&
           hasFormCutters(shop.library, request.sequence.material);
}

std::vector<PlannedSetup> withForms(std::vector<PlannedSetup> setups, const std::vector<PlannedStage>& stages,
                                    const PlanningShop& shop, const Progress& progress,
                                    std::vector<Warning>& warnings) {
    if (!finishesForms(shop)) return setups;
    std::map<std::string, double> leaning_mm3;  // where no error ended the weighing of cutters
    const FormKind walls{
        formGroundId, &PlannedSetup::form, "leaning walls of ",
        "leaning walls stay as flat layers leave them", [&](const FormSources& sources, FormShop forms) {
            const double leans_mm3 = mostStairsMm3(sources.layers);
            forms.cutters = cuttersBefore(sources.setup, leans_mm3, forms.caution, shop.request);
            std::optional<FormFinishing> finishing = finishForms(sources, forms);
            leaning_mm3[sources.setup.id] = leans_mm3;
            return finishing;
        }};
    FormSetups(walls, shop, warnings).addTo(setups, stages, progress);
    for (PlannedSetup& setup : setups)
        if (const auto found = leaning_mm3.find(setup.setup.id); found != leaning_mm3.end())
            setup.leaning_mm3 = found->second;
    return setups;
}

std::vector<PlannedSetup> withBrokenEdges(std::vector<PlannedSetup> setups,
                                          const std::vector<PlannedStage>& stages, const PlanningShop& shop,
                                          const Progress& progress, std::vector<Warning>& warnings) {
    const double width_mm = shop.request.break_edges_mm;
    if (width_mm <= 0 || shop.request.roughing) return setups;
    const FormKind edges{edgeGroundId, &PlannedSetup::edges, "edges of ", "edges stay sharp",
                         [width_mm](const FormSources& sources, const FormShop& forms) {
                             return breakEdges(sources, width_mm, forms);
                         }};
    FormSetups(edges, shop, warnings).addTo(setups, stages, progress);
    for (const PlannedSetup& setup : setups) {
        if (!setup.edges) continue;
        warnOfSharpEdges(*setup.edges, warnings);
        warnOfRawFaces(setup, warnings);
    }
    return setups;
}

}  // namespace stepmill
