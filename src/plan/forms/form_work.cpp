// One form cutter over the stairs of a setup.

#include "plan/forms/form_work.h"

#include <algorithm>
#include <cmath>

#include "plan/forms/form_levels.h"
#include "plan/forms/hole_sinks.h"
#include "stepmill/access/form_floor.h"
#include "stepmill/feature/heights.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/unsure_offset.h"
#include "stepmill/sequence/machine_limits.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill {
namespace {

/// What is thinner than so many scallops is the surface of an earlier pass.
constexpr double kPassSkinScallops = 3;
/// Passes along levels leave so much to the lines over shallow ground [mm].
constexpr double kLeftToLinesMm = 0.5;
/// Sine of the lean from upright from which ground may be shallow.
constexpr double kShallowLean = 0.96;
/// Stairs of one slope begin this far apart where each ends in nothing, or less [mm].
constexpr double kGapOfStairsMm = 0.5;

bool hasShallowGround(const FormSite& site, const Obstacle& stair) {
    for (std::size_t i = 0; i < site.leans.size(); ++i) {
        const Obstacle& band = site.ground.must_stand[i];
        const bool meets = band.bottom_z_mm < stair.top_z_mm && band.top_z_mm > stair.bottom_z_mm;
        if (meets && !site.leans[i].empty() && site.leans[i].back() >= kShallowLean) return true;
    }
    return false;
}

/// The ground of all stairs.
Region groundOf(const std::vector<Obstacle>& stairs, const Tolerances& tol) {
    std::vector<Region> sections;
    sections.reserve(stairs.size());
    for (const Obstacle& stair : stairs)
        sections.push_back(stair.section);
    return unite(sections, tol);
}

/// Those of heights at which some ground is shallow.
std::vector<Obstacle> shallowStairs(const FormSite& site) {
    std::vector<Obstacle> stairs = site.ground.stairs;
    std::erase_if(stairs, [&](const Obstacle& stair) { return !hasShallowGround(site, stair); });
    return stairs;
}

/// Stairs that are no farther apart than those of one slope joined; as they are where nothing sure is found.
Region joined(const Region& stairs, const Tolerances& tol) {
    try {
        return offset(offset(stairs, kGapOfStairsMm / 2, tol), -kGapOfStairsMm / 2, tol);
    } catch (const UnsureOffset&) {
        return stairs;
    }
}

}  // namespace

double widestFormCutterMm(const FormShop& shop) {
    double widest_mm = 0;
    for (const ToolAssembly& tool : shop.library.tools)
        if (tool.isForm() && tool.cuttingFor(shop.material) != nullptr)
            widest_mm = std::max(widest_mm, tool.radius_mm());
    return widest_mm;
}

std::vector<Prism> takenPrisms(const StandingStairs& before, const StandingStairs& after,
                               const Tolerances& tol) {
    std::vector<Prism> prisms;
    for (std::size_t i = 0; i < before.slices().size(); ++i) {
        const StandingStairs::Slice& slice = before.slices()[i];
        Region taken = subtract(slice.region, after.slices()[i].region, tol);
        if (area(taken) > tol.area_mm2) prisms.push_back({std::move(taken), slice.top_mm, slice.bottom_mm});
    }
    return prisms;
}

Operation formOperation(FormStep& step, const FormGround& ground, const FormShop& shop) {
    Operation operation;
    const CuttingData cutting = limitedBy(shop.machine, *step.tool->cuttingFor(shop.material));
    operation.setup_id = ground.setup_id;
    operation.feature_id = ground.id;
    operation.role = Role::Form;
    operation.tool_id = step.tool->id;
    operation.path = std::move(step.path);
    operation.z_top_mm = ground.stairs.back().top_z_mm;
    operation.z_floor_mm = std::min(operation.z_top_mm, lowestMm(operation));
    operation.speed_rpm = cutting.speed_rpm;
    operation.coolant = cutting.coolant;
    operation.holes = step.holes;
    if (step.holes > 0) operation.dwell_s = cutting.dwell_s;
    operation.ramp_angle_deg = toolpath::rampAngleDeg(cutting);
    operation.proof.least_clearance_mm = shop.tol.guard_mm;
    return operation;
}

/// Ground of one cutter, and how far down it may go there; nothing where no ground can be.
struct FormWork::Shallow {
    std::optional<FormFloor> floor;
    toolpath::ShallowGround ground;
};

FormWork::FormWork(const FormSite& site, const FormShop& shop)
    : site_(site),
      shop_(shop),
      bands_(site.ground, shop.tol),
      shallow_stairs_(groundOf(shallowStairs(site), shop.tol)) {
    if (shallow_stairs_.empty()) return;
    shallow_slopes_ = joined(shallow_stairs_, shop.tol);
    slopes_ = joined(groundOf(site.ground.stairs, shop.tol), shop.tol);
}

FormWork::~FormWork() = default;

std::vector<const ToolAssembly*> FormWork::cutters() const {
    std::vector<const ToolAssembly*> found;
    for (const ToolAssembly& tool : shop_.library.tools)
        if (tool.isForm() && tool.cuttingFor(shop_.material) != nullptr &&
            shop_.caution.without_tools.count(tool.id) == 0)
            found.push_back(&tool);
    return found;
}

/// Nothing where the cutter has no pass, or where no sure region of free centres is found: what other levels
/// leave there stays. Any other trouble is not this level's alone.
std::optional<toolpath::FormLevel> FormWork::levelAt(toolpath::FormPasses& passes,
                                                     const StandingStairs& stairs,
                                                     const std::vector<double>& heights,
                                                     std::size_t index) const {
    try {
        toolpath::FormLevel level = passes.at(heights[index], stairs, mayWaitFor(heights, index));
        if (!level.passes.empty()) return level;
    } catch (const UnsureOffset&) {
    }
    return std::nullopt;
}

/// The levels that have passes among some heights, in their order: halves of them where no passes can be are
/// left out together.
void FormWork::addLevels(toolpath::FormPasses& passes, const CutterForm& form,
                         const std::vector<double>& heights, std::size_t first, std::size_t last,
                         FormStep& step, std::vector<toolpath::FormLevel>& levels) const {
    shop_.deadline.check(site_.ground.id);
    if (last - first > 1) {
        const auto [lowest, highest] =
            std::minmax_element(heights.begin() + static_cast<std::ptrdiff_t>(first),
                                heights.begin() + static_cast<std::ptrdiff_t>(last));
        if (!passes.mayPass(*highest, *lowest, step.left)) return;
        const std::size_t middle = (first + last) / 2;
        addLevels(passes, form, heights, first, middle, step, levels);
        addLevels(passes, form, heights, middle, last, step, levels);
        return;
    }
    std::optional<toolpath::FormLevel> level = levelAt(passes, step.left, heights, first);
    if (!level) return;
    step.left.cut({heights[first], level->passes}, form);
    levels.push_back(std::move(*level));
}

/// The level below; nothing at the foot of stairs, where the fillet is made.
std::optional<double> FormWork::mayWaitFor(const std::vector<double>& heights, std::size_t index) const {
    const bool is_foot = std::any_of(site_.feet_mm.begin(), site_.feet_mm.end(), [&](double foot_mm) {
        return std::abs(foot_mm - heights[index]) < kSameHeightMm;
    });
    if (is_foot || index + 1 == heights.size() || heights[index + 1] > heights[index]) return std::nullopt;
    return heights[index + 1];
}

const FormCentres& FormWork::centresOf(const ToolAssembly& tool) {
    std::unique_ptr<FormCentres>& centres = centres_[tool.id];
    if (!centres) centres = std::make_unique<FormCentres>(bands_, tool);
    return *centres;
}

const FormWork::Shallow& FormWork::shallowFor(const ToolAssembly& tool) {
    std::unique_ptr<Shallow>& shallow = shallow_[tool.id];
    if (shallow) return *shallow;
    shallow = std::make_unique<Shallow>();
    if (shallow_stairs_.empty() || tool.hasFlanks()) return *shallow;
    shallow->floor.emplace(site_.ground, tool, shop_.tol, shop_.deadline);
    const CutterForm form(tool);
    const toolpath::LineSpacing spacing = spacingOf(tool);
    // Without sure ground levels do it.
    const auto over = [&](const Region& stairs) -> toolpath::ShallowGround {
        try {
            return {*shallow->floor, form, stairs, slopes_, centresOf(tool).withinWindow(), shop_.tol};
        } catch (const UnsureOffset&) {
            return {};
        }
    };
    // Lines over a whole slope where they are shorter than levels on what is too narrow for them by itself.
    shallow->ground = over(shallow_slopes_);
    if (shallow->ground.patches().empty()) return *shallow;
    toolpath::ShallowGround apart = over(shallow_stairs_);
    const double levels_mm = shallow->ground.levelsMm(kLeastLevelStepMm) - apart.levelsMm(kLeastLevelStepMm);
    if (surfacePassesMm(shallow->ground, form, spacing) > surfacePassesMm(apart, form, spacing) + levels_mm)
        shallow->ground = std::move(apart);
    return *shallow;
}

toolpath::LineSpacing FormWork::spacingOf(const ToolAssembly& tool) const {
    const CuttingData cutting = limitedBy(shop_.machine, *tool.cuttingFor(shop_.material));
    return {shop_.scallop_mm, toolpath::usedStepOver(cutting, CutterForm(tool).fullRadiusMm())};
}

toolpath::FormPath FormWork::pathOf(const ToolAssembly& tool, const std::vector<toolpath::FormLevel>& levels,
                                    const std::vector<SurfaceWay>& lines) const {
    const CuttingData cutting = limitedBy(shop_.machine, *tool.cuttingFor(shop_.material));
    return toolpath::formPath({site_.ground, shop_.retract_mm, shop_.caution.plain_ways}, levels, lines, tool,
                              cutting, shop_.machine, shop_.tol);
}

std::vector<FormStep> FormWork::sinks(const ToolAssembly& tool, const StandingStairs& stairs,
                                      double least_mm3) {
    const CutterForm form(tool);
    const double dwell_s = tool.cuttingFor(shop_.material)->dwell_s;
    std::vector<FormStep> steps;
    for (const toolpath::FormLevel& level : sinkLevels(site_, tool, centresOf(tool), shop_.tol)) {
        shop_.deadline.check(site_.ground.id);
        const StandingStairs& before = steps.empty() ? stairs : steps.back().left;
        FormStep step{&tool,  pathOf(tool, {level}, {}).path,       0, 0,
                      before, static_cast<int>(level.passes.size())};
        step.left.cut({level.tip_z_mm, level.passes}, form);
        step.taken_mm3 = before.volumeMm3() - step.left.volumeMm3();
        if (step.taken_mm3 < least_mm3) continue;
        step.time_s = step.path.totals.motion_time_s + step.holes * dwell_s +
                      (steps.empty() ? shop_.machine.tool_change_s : 0);
        steps.push_back(std::move(step));
    }
    return steps;
}

FormStep FormWork::step(const ToolAssembly& tool, const StandingStairs& stairs) {
    const CuttingData cutting = limitedBy(shop_.machine, *tool.cuttingFor(shop_.material));
    const CutterForm form(tool);
    const toolpath::LineSpacing apart = spacingOf(tool);
    const toolpath::PassSpacing spacing{
        apart.step_over_mm, kPassSkinScallops * shop_.scallop_mm,
        tool.hasFlanks() ? 0 : alongWallMm(tool.corner_radius_mm, shop_.scallop_mm), kLeftToLinesMm};
    const Shallow& shallow = shallowFor(tool);
    toolpath::FormPasses passes(centresOf(tool), form, spacing, shallow.ground, shop_.tol);
    FormStep step{&tool, {}, 0, 0, stairs};
    const std::vector<double> heights = formLevels(site_, tool, cutting.step_down_mm, shop_.scallop_mm);
    std::vector<toolpath::FormLevel> levels;
    if (!heights.empty()) addLevels(passes, form, heights, 0, heights.size(), step, levels);
    std::stable_sort(levels.begin(), levels.end(),
                     [](const auto& a, const auto& b) { return a.tip_z_mm > b.tip_z_mm; });
    std::vector<SurfaceWay> lines;
    if (shallow.floor)
        lines = toolpath::surfacePasses(shallow.ground, *shallow.floor, form, apart, shop_.tol);
    toolpath::FormPath written = pathOf(tool, levels, lines);
    for (const LevelWays& ways : written.between) {
        shop_.deadline.check(site_.ground.id);
        step.left.cut(ways, form);
    }
    shop_.deadline.check(site_.ground.id);
    step.left.cut(lines, form);
    step.path = std::move(written.path);
    step.taken_mm3 = stairs.volumeMm3() - step.left.volumeMm3();
    step.time_s = step.path.totals.motion_time_s + shop_.machine.tool_change_s;
    return step;
}

}  // namespace stepmill
