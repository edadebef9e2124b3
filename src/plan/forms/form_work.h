#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plan/forms/form_finishing.h"
#include "stepmill/access/form_centres.h"
#include "stepmill/toolpath/form_passes.h"
#include "stepmill/toolpath/standing_stairs.h"

namespace stepmill {

/// What one cutter does on a form ground.
struct FormStep {
    const ToolAssembly* tool = nullptr;
    Toolpath path;  ///< without moves where the cutter meets nothing
    double taken_mm3 = 0;
    double time_s = 0;    ///< with its tool change
    StandingStairs left;  ///< after it
    int holes = 0;        ///< into so many it goes straight down; 0: it goes along walls
};

/// Tries cutters on one form ground. Free centres are made once for each cutter and height.
class FormWork {
  public:
    /// Keeps both.
    FormWork(const FormSite& site, const FormShop& shop);
    ~FormWork();

    /// The cutter's passes over those stairs.
    FormStep step(const ToolAssembly& tool, const StandingStairs& stairs);
    /// What a countersink does, a step for each height that its tip goes down to.
    /// \param least_mm3  steps that take less are left out
    /// \pre tool.isCountersink()
    std::vector<FormStep> sinks(const ToolAssembly& tool, const StandingStairs& stairs, double least_mm3);
    /// Cutters that may come: with cutting data, flutes and a form.
    std::vector<const ToolAssembly*> cutters() const;

  private:
    struct Shallow;
    const FormCentres& centresOf(const ToolAssembly& tool);
    /// Finished by lines over the surface; of cutters with flanks there is none.
    const Shallow& shallowFor(const ToolAssembly& tool);
    toolpath::LineSpacing spacingOf(const ToolAssembly& tool) const;
    toolpath::FormPath pathOf(const ToolAssembly& tool, const std::vector<toolpath::FormLevel>& levels,
                              const std::vector<SurfaceWay>& lines) const;
    std::optional<toolpath::FormLevel> levelAt(toolpath::FormPasses& passes, const StandingStairs& stairs,
                                               const std::vector<double>& heights, std::size_t index) const;
    void addLevels(toolpath::FormPasses& passes, const CutterForm& form, const std::vector<double>& heights,
                   std::size_t first, std::size_t last, FormStep& step,
                   std::vector<toolpath::FormLevel>& levels) const;
    std::optional<double> mayWaitFor(const std::vector<double>& heights, std::size_t index) const;

    const FormSite& site_;
    const FormShop& shop_;
    FormBands bands_;
    Region shallow_stairs_;  ///< over ground that leans so much that it is shallow
    Region shallow_slopes_;  ///< the same, those of one slope joined
    Region slopes_;          ///< all stairs so, where some are shallow
    std::map<std::string, std::unique_ptr<FormCentres>> centres_;
    std::map<std::string, std::unique_ptr<Shallow>> shallow_;
};

/// Radius of the widest form cutter that may come.
double widestFormCutterMm(const FormShop& shop);

/// The step as an operation on its ground, without id; its path moves.
Operation formOperation(FormStep& step, const FormGround& ground, const FormShop& shop);

/// Slice by slice what stood before and does not after.
std::vector<Prism> takenPrisms(const StandingStairs& before, const StandingStairs& after,
                               const Tolerances& tol);

}  // namespace stepmill
