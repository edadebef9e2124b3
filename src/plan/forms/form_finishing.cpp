// Which form cutters finish a setup, and what they take.

#include "plan/forms/form_finishing.h"

#include <algorithm>
#include <map>

#include "plan/forms/form_work.h"
#include "stepmill/feature/reason.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Sequences that take this share of what the best takes take as much, ...
constexpr double kAsMuchShare = 0.99;
/// ... or this one with as many cutters: by so much ridges of one may differ from those of another, all
/// within the scallop. One cutter more takes what the others do not get at.
constexpr double kAsMuchByOthersShare = 0.98;
/// ... and so much is enough where the rest takes longer than this share of all the time.
constexpr double kMostTimeForTheRest = 0.5;

using FormSteps = std::vector<FormStep>;

double takenOf(const FormSteps& steps) {
    double sum = 0;
    for (const FormStep& step : steps)
        sum += step.taken_mm3;
    return sum;
}

double timeOf(const FormSteps& steps) {
    double sum = 0;
    for (const FormStep& step : steps)
        sum += step.time_s;
    return sum;
}

class FormChooser {
  public:
    FormChooser(const FormSite& site, const FormShop& shop)
        : work_(site, shop), all_(site.ground, shop.tol), least_mm3_(leastFormGainMm3(all_.volumeMm3())) {}

    const StandingStairs& all() const { return all_; }

    /// Those cutters in that order, as far as they take anything there.
    FormSteps inOrder(const std::vector<std::string>& ids) {
        FormSteps steps;
        for (const std::string& id : ids)
            for (const ToolAssembly* tool : work_.cutters())
                if (tool->id == id) goOnWith(*tool, steps);
        return steps;
    }

    FormSteps choose() {
        std::vector<FormSteps> beginnings;
        if (FormSteps sunk = countersinks(); !sunk.empty())
            beginnings.push_back(withChamfers(std::move(sunk)));
        beginnings.push_back(withChamfers({}));
        FormSteps begun = cheapest(beginnings);
        const StandingStairs& left = begun.empty() ? all_ : begun.back().left;
        const FormSteps first = promising(steps(left, begun));
        std::vector<FormSteps> ways{begun};
        for (const FormStep& step : first) {
            FormSteps way = begun;
            way.push_back(step);
            ways.push_back(way);
            // A cutter that alone takes longer than all that is known to do it is no beginning.
            while (timeOf(way) < timeOf(cheapest(ways)) || takenOf(way) >= takenOf(cheapest(ways))) {
                if (!goOn(way)) break;
                ways.push_back(way);
            }
        }
        return cheapest(ways);
    }

  private:
    /// Each countersink, the narrowest first.
    FormSteps countersinks() {
        std::vector<const ToolAssembly*> tools = work_.cutters();
        std::erase_if(tools, [](const ToolAssembly* tool) { return !tool->isCountersink(); });
        std::stable_sort(tools.begin(), tools.end(), [](const ToolAssembly* a, const ToolAssembly* b) {
            return a->diameter_mm < b->diameter_mm;
        });
        FormSteps steps;
        for (const ToolAssembly* tool : tools)
            goOnWith(*tool, steps);
        return steps;
    }

    /// And then each chamfer mill, one after the other.
    FormSteps withChamfers(FormSteps steps) {
        for (const ToolAssembly* tool : work_.cutters())
            if (tool->type == ToolType::Chamfer) goOnWith(*tool, steps);
        return steps;
    }

    void goOnWith(const ToolAssembly& tool, FormSteps& steps) {
        const StandingStairs& left = steps.empty() ? all_ : steps.back().left;
        FormSteps more;
        if (tool.isCountersink())
            more = work_.sinks(tool, left, kLeastFormGainMm3);
        else
            more.push_back(work_.step(tool, left));
        const double least_mm3 = tool.hasFlanks() ? kLeastFormGainMm3 : least_mm3_;
        for (FormStep& step : more)
            if (step.taken_mm3 >= least_mm3) steps.push_back(std::move(step));
    }

    /// Every cutter that gains something there.
    FormSteps steps(const StandingStairs& stairs, const FormSteps& before) {
        FormSteps found;
        for (const ToolAssembly* tool : work_.cutters()) {
            const bool used = std::any_of(before.begin(), before.end(),
                                          [&](const FormStep& step) { return step.tool == tool; });
            if (used || tool->hasFlanks()) continue;
            FormStep step = work_.step(*tool, stairs);
            if (step.taken_mm3 >= least_mm3_) found.push_back(std::move(step));
        }
        return found;
    }

    /// Those that take most and that take most in a minute.
    static FormSteps promising(const FormSteps& steps) {
        if (steps.size() < 2) return steps;
        const auto most =
            std::max_element(steps.begin(), steps.end(),
                             [](const FormStep& a, const FormStep& b) { return a.taken_mm3 < b.taken_mm3; });
        const auto quickest =
            std::max_element(steps.begin(), steps.end(), [](const FormStep& a, const FormStep& b) {
                return a.taken_mm3 * b.time_s < b.taken_mm3 * a.time_s;
            });
        FormSteps found{*quickest};
        if (most != quickest) found.push_back(*most);
        return found;
    }

    /// One more cutter: the one that takes most.
    bool goOn(FormSteps& way) {
        FormSteps next = steps(way.back().left, way);
        if (next.empty()) return false;
        way.push_back(*std::max_element(next.begin(), next.end(), [](const FormStep& a, const FormStep& b) {
            return a.taken_mm3 < b.taken_mm3;
        }));
        return true;
    }

    static FormSteps cheapest(const std::vector<FormSteps>& ways) {
        const FormSteps& most =
            *std::max_element(ways.begin(), ways.end(),
                              [](const FormSteps& a, const FormSteps& b) { return takenOf(a) < takenOf(b); });
        const FormSteps* best = nullptr;
        for (const FormSteps& way : ways) {
            const bool much_quicker = timeOf(way) < (1 - kMostTimeForTheRest) * timeOf(most);
            const bool by_others = way.size() >= most.size() || much_quicker;
            const double share = by_others ? kAsMuchByOthersShare : kAsMuchShare;
            if (takenOf(way) >= share * takenOf(most) && (best == nullptr || timeOf(way) < timeOf(*best)))
                best = &way;
        }
        return *best;
    }

    FormWork work_;
    StandingStairs all_;
    double least_mm3_;
};

bool spans(const Layer& layer, double z_mm) {
    return layer.bottom_z_mm < z_mm && z_mm < layer.top_z_mm;
}

/// Shares out what an operation took among what hid it from flat cutters, layer by layer: by the ground that
/// each cause's faces cover, and no more than each hid and earlier operations left of it.
class TakenByReason {
  public:
    TakenByReason(const LayerStack& layers, const Tolerances& tol) : layers_(layers), tol_(tol) {
        for (const Layer& layer : layers.layers) {
            std::vector<double>& left = left_.emplace_back();
            for (const HiddenVolume& hidden : layer.hidden)
                left.push_back(hidden.volume_mm3);
        }
    }

    std::vector<ReasonVolume> of(const StandingStairs& before, const StandingStairs& after) {
        std::map<StayReason, double, InOrderOfWords> by_reason;
        for (std::size_t i = 0; i < layers_.layers.size(); ++i)
            addLayer(i, before, after, by_reason);
        std::vector<ReasonVolume> list;
        for (const auto& [reason, volume_mm3] : by_reason)
            if (volume_mm3 > 0) list.push_back({reason, volume_mm3});
        return list;
    }

  private:
    void addLayer(std::size_t index, const StandingStairs& before, const StandingStairs& after,
                  std::map<StayReason, double, InOrderOfWords>& by_reason) {
        const Layer& layer = layers_.layers[index];
        std::vector<double> weights(layer.hidden.size(), 0.0);
        double taken_mm3 = 0;
        for (std::size_t i = 0; i < before.slices().size(); ++i) {
            const StandingStairs::Slice& slice = before.slices()[i];
            if (!spans(layer, slice.z_mm)) continue;
            const double mm2 = area(slice.region) - area(after.slices()[i].region);
            if (mm2 <= 0) continue;
            taken_mm3 += mm2 * slice.height_mm();
            weigh(layer, subtract(slice.region, after.slices()[i].region, tol_), weights);
        }
        for (const bool others : {false, true})
            for (std::size_t k = 0; k < weights.size(); ++k) {
                double sum = 0;
                for (std::size_t n = k; n < weights.size(); ++n)
                    sum += others ? left_[index][n] : weights[n];
                const double weight = others ? left_[index][k] : weights[k];
                if (sum <= 0 || taken_mm3 <= 0) continue;
                const double share_mm3 = std::min(left_[index][k], taken_mm3 * weight / sum);
                left_[index][k] -= share_mm3;
                taken_mm3 -= share_mm3;
                by_reason[{reasonOf(layer.hidden[k].cause), {}}] += share_mm3;
            }
    }

    void weigh(const Layer& layer, const Region& taken, std::vector<double>& weights) const {
        for (std::size_t k = 0; k < weights.size(); ++k) {
            if (weights.size() == 1) weights[k] = 1;
            for (const int face : layer.hidden[k].faces)
                if (const Region& under = layers_.traces[static_cast<std::size_t>(face)].region;
                    !under.empty())
                    weights[k] += area(intersect(taken, under, tol_));
        }
    }

    const LayerStack& layers_;
    const Tolerances& tol_;
    std::vector<std::vector<double>> left_;  ///< by layer and cause
};

}  // namespace

bool hasFormCutters(const ToolLibrary& library, const std::string& material) {
    return std::any_of(library.tools.begin(), library.tools.end(), [&](const ToolAssembly& tool) {
        return tool.isForm() && tool.cuttingFor(material) != nullptr;
    });
}

std::optional<FormFinishing> finishForms(const FormSources& sources, const FormShop& shop) {
    if (shop.cutters && shop.cutters->empty()) return std::nullopt;
    shop.deadline.check(formGroundId(sources.setup.id));
    std::optional<FormSite> site = formSite(sources, kBandSkinScallops * shop.scallop_mm,
                                            widestFormCutterMm(shop), shop.tol, shop.deadline);
    if (!site || shop.caution.dropped) return std::nullopt;
    FormChooser chooser(*site, shop);
    FormSteps steps = shop.cutters ? chooser.inOrder(*shop.cutters) : chooser.choose();
    if (steps.empty()) return std::nullopt;
    FormFinishing finishing;
    TakenByReason taken(sources.layers, shop.tol);
    const StandingStairs* before = &chooser.all();
    for (FormStep& step : steps) {
        finishing.operations.push_back(formOperation(step, site->ground, shop));
        finishing.operations.back().takes = taken.of(*before, step.left);
        before = &step.left;
    }
    finishing.removed = takenPrisms(chooser.all(), steps.back().left, shop.tol);
    finishing.ground = std::move(site->ground);
    return finishing;
}

}  // namespace stepmill
