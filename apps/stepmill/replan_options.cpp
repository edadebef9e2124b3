#include "replan_options.h"

#include <set>

#include <fmt/core.h>

#include "cycle_time_option.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/feature/whole_feature.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

/// Looks for the files that a job was made from: it names them without their folders.
class JobFiles {
  public:
    explicit JobFiles(const ReplanOptions& options)
        : job_(options.job), max_bytes_(options.plan.limits.maxFileBytes()) {
        const fs::path job = fs::absolute(job_).lexically_normal();
        folders_ = {fs::path("."), job, (job / "..").lexically_normal()};
        if (!options.plan.part_file.empty())
            folders_.push_back(fs::absolute(options.plan.part_file).parent_path());
    }

    /// \throws Error(Usage) where it is in none of the folders
    std::string find(const char* option, const RecordedFile& recorded) const {
        for (const fs::path& folder : folders_) {
            const fs::path path = folder / fs::path(recorded.file).filename();
            std::error_code none;
            if (fs::is_regular_file(path, none) && sha256(readFile(path, max_bytes_)) == recorded.sha256)
                return path.string();
        }
        throw Error(ErrorCode::Usage, option,
                    fmt::format("{} was planned with {}, which is neither here nor beside the job with the "
                                "contents it had: give it or another",
                                job_, recorded.file));
    }

    /// The same where nothing is given anew and the plan was made with such a file.
    void fill(const char* option, std::string& given, const RecordedFile& recorded) const {
        if (given.empty() && !recorded.sha256.empty()) given = find(option, recorded);
    }

  private:
    std::string job_;
    std::uintmax_t max_bytes_;
    std::vector<fs::path> folders_;
};

/// Words that the option's reader takes back to the same axes.
std::vector<std::string> axisWords(const std::vector<Vec3>& axes) {
    std::vector<std::string> words;
    for (const Vec3& axis : axes)
        words.push_back(fmt::format("{},{},{}", axis.x(), axis.y(), axis.z()));
    return words;
}

void fillRequest(PlanOptions& plan, const RecordedRequest& request) {
    plan.unit = request.unit;
    plan.stock_margin =
        fmt::format("{},{},{}", request.margin.side_mm, request.margin.top_mm, request.margin.bottom_mm);
    if (!request.stock_sizes_mm.empty()) plan.stock = "auto";
    if (request.hold) plan.hold = toString(*request.hold);
    plan.setups = axisWords(request.axes);
    plan.no_setups = axisWords(request.forbidden);
    plan.objective = toString(request.objective);
    plan.surrogates = toString(request.surrogates);
    plan.finish_walls_mm = request.finish.walls_mm;
    plan.finish_floors_mm = request.finish.floors_mm;
    plan.quantity = request.quantity;
    plan.scallop_mm = request.scallop_mm;
    plan.break_edges_mm = request.break_edges_mm;
    plan.reserve = request.reserve;
    if (!request.roughing) return;
    plan.rough = true;
    plan.allowance_mm = request.roughing->walls_mm;
    plan.floor_allowance_mm = request.roughing->floors_mm;
}

bool isBuiltIn(const RecordedFile& library) {
    return library.sha256 == defaultToolLibrary().sha256;
}

}  // namespace

void fillFromJob(ReplanOptions& options, const PlanRecord& before) {
    if (!before.request)
        throw Error(ErrorCode::InvalidCatalog, options.job + "/plan.json#",
                    "expected a request: the plan was made by an older version of stepmill; plan it again");
    PlanOptions& plan = options.plan;
    const RecordedRequest& request = *before.request;
    const JobFiles files(options);
    options.same_part = plan.part_file.empty();
    options.same_shop = plan.tools_file.empty() && plan.machine_file.empty() && plan.fixtures_file.empty() &&
                        plan.holes_file.empty() && plan.material.empty();
    files.fill("--part", plan.part_file, {before.part_file, before.part_sha256});
    if (options.same_part && !isDrawn(plan.part_file, plan.drawing))
        plan.solid = std::to_string(request.solid);
    fillRequest(plan, request);
    std::string stock;
    files.fill("--stock", stock, request.stock);
    if (!stock.empty()) {
        plan.stock = stock;
        plan.stock_margin.reset();
    }
    plan.stock_tolerance_mm = before.stock.tolerance_mm;
    files.fill("--fixtures", plan.fixtures_file, request.fixtures);
    files.fill("--holes", plan.holes_file, request.holes);
    if (!isBuiltIn(before.library)) files.fill("--tools", plan.tools_file, before.library);
    plan.library_feeds = plan.material.empty() && !before.cut_material;
    if (plan.material.empty()) plan.material = before.material;
    plan.cost_model = toString(before.cost_model);
}

Shop shopOf(const ReplanOptions& options, const PlanRecord& before) {
    Shop shop = loadShop(options.plan);
    if (options.plan.machine_file.empty()) shop.machine = before.machine;
    return shop;
}

namespace {

/// A job that is planned again has its setups and features as a rule: a slip of the pen costs no plan.
void requireKnown(const std::vector<CycleTarget>& targets, const PlanRecord& before) {
    std::set<std::string> known{""};
    for (const RecordedSetup& setup : before.setups)
        known.insert(setup.id);
    for (const auto& [id, feature] : before.features)
        known.insert(wholeOf(feature.feature));
    for (const CycleTarget& target : targets)
        if (known.count(target.of) == 0)
            throw Error(ErrorCode::Usage, "--cycle-time " + target.of,
                        "expected a setup or a feature of the job, such as " + *std::next(known.begin()));
}

std::vector<CycleTarget> cycleTimesOf(const ReplanOptions& options, const PlanRecord& before) {
    if (options.cycle_times.empty()) return before.request->cycle_times;
    std::vector<CycleTarget> targets = cycleTargets(options.cycle_times);
    if (options.same_part) requireKnown(targets, before);
    return targets;
}

}  // namespace

PlanRequest requestOf(const ReplanOptions& options, const PlanRecord& before, const Shop& shop) {
    PlanRequest request = planRequest(options.plan, shop);
    // Materials may come from a file that the plan does not name; what it took of it stands in it.
    if (options.plan.material == before.material) request.sequence.cut_material = before.cut_material;
    request.earlier = earlierSetups(before);
    if (options.same_shop) request.as_before = earlierAssignment(before);
    request.cycle_times = cycleTimesOf(options, before);
    return request;
}

}  // namespace stepmill
