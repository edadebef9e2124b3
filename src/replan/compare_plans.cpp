// Two plans side by side, by what plan.json and programs say.

#include <algorithm>
#include <set>

#include "replan/compare_inputs.h"
#include "replan/operation_lines.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/replan/plan_change.h"

namespace stepmill {
namespace {

/// Whole features of a setup with their bands from above, in the plan's order.
struct NamedBands {
    std::string id;
    std::vector<const Feature*> bands;
};

std::vector<NamedBands> namedBands(const PlanRecord& record, const RecordedSetup& setup) {
    std::vector<NamedBands> features;
    for (const std::string& id : setup.feature_ids) {
        const Feature& band = record.features.at(id).feature;
        const auto known = std::find_if(features.begin(), features.end(),
                                        [&](const NamedBands& one) { return one.id == wholeOf(band); });
        if (known == features.end())
            features.push_back({wholeOf(band), {&band}});
        else
            known->bands.push_back(&band);
    }
    return features;
}

/// One of the plans, setup by setup.
struct SetupThen {
    const PlanRecord* record = nullptr;
    const RecordedSetup* setup = nullptr;
    std::vector<NamedBands> features;
    std::vector<std::pair<std::string, OperationThen>> operations;  ///< by id, in machining order

    const NamedBands* feature(const std::string& id) const {
        const auto found = std::find_if(features.begin(), features.end(),
                                        [&](const NamedBands& one) { return one.id == id; });
        return found == features.end() ? nullptr : &*found;
    }
    const OperationThen* operation(const std::string& id) const {
        const auto found = std::find_if(operations.begin(), operations.end(),
                                        [&](const auto& one) { return one.first == id; });
        return found == operations.end() ? nullptr : &found->second;
    }
    /// Of a form operation: of the setup's form ground, which is no feature.
    std::string featureOf(const std::string& operation_id) const {
        const std::string& id = record->operations.at(operation_id).feature_id;
        const auto band = record->features.find(id);
        return band == record->features.end() ? id : wholeOf(band->second.feature);
    }
};

SetupThen setupThen(const RecordedPlan& plan, const RecordedSetup& setup) {
    SetupThen then{&plan.record, &setup, namedBands(plan.record, setup), {}};
    replan::LinesById lines = replan::operationLines(plan.files, setup);
    for (const std::string& id : setup.operation_ids) {
        const RecordedOperation& operation = plan.record.operations.at(id);
        then.operations.emplace_back(
            id, OperationThen{static_cast<int>(then.operations.size()) + 1, operation.tool.id,
                              operation.tool.number, plan.record.operation_s.at(id), std::move(lines[id])});
    }
    return then;
}

FeatureThen featureThen(const SetupThen& setup, const NamedBands& feature, const Tolerances& tol) {
    FeatureThen then;
    then.feature_class = classOfWhole(*feature.bands.front(), *feature.bands.back());
    then.top_z_mm = feature.bands.front()->top_z_mm;
    then.floor_z_mm = feature.bands.back()->floor_z_mm;
    std::vector<Region> targets;
    for (const Feature* band : feature.bands) {
        then.volume_mm3 += band->volume_mm3;
        targets.push_back(band->target);
    }
    then.target = unite(targets, tol);
    for (const auto& [id, operation] : setup.operations)
        if (setup.featureOf(id) == feature.id) {
            then.tools.push_back(operation.tool);
            then.time_s += operation.time_s;
        }
    return then;
}

OperationChange operationChange(const std::string& id, const SetupThen& named_by, const OperationThen* before,
                                const OperationThen* after) {
    OperationChange change;
    change.id = id;
    change.setup_id = named_by.setup->id;
    change.feature_id = named_by.featureOf(id);
    change.role = named_by.record->operations.at(id).role;
    if (before != nullptr) change.before = *before;
    if (after != nullptr) change.after = *after;
    if (before == nullptr || after == nullptr) {
        change.change = before == nullptr ? Change::New : Change::Dropped;
        return change;
    }
    change.lines_kept = replan::linesKept(before->lines, after->lines);
    const bool kept =
        before->lines == after->lines && before->tool == after->tool && before->number == after->number;
    change.change = kept ? Change::Kept : Change::Changed;
    return change;
}

bool sameObstacles(const Feature& one, const Feature& other, const Tolerances& tol) {
    return std::equal(one.obstacles.begin(), one.obstacles.end(), other.obstacles.begin(),
                      other.obstacles.end(), [&](const Obstacle& a, const Obstacle& b) {
                          return a.bottom_z_mm == b.bottom_z_mm && a.top_z_mm == b.top_z_mm &&
                                 feature::sameRegion(a.section, b.section, tol);
                      });
}

/// Is that of every band the same in both?
template <typename Same>
bool sameBands(const NamedBands& before, const NamedBands& after, Same same) {
    return std::equal(before.bands.begin(), before.bands.end(), after.bands.begin(), after.bands.end(),
                      [&](const Feature* a, const Feature* b) { return same(*a, *b); });
}

/// \param operations  of the whole plan
std::vector<ChangeCause> causesOf(const NamedBands& before, const NamedBands& after,
                                  const FeatureChange& change, const std::vector<OperationChange>& operations,
                                  const Tolerances& tol) {
    std::vector<ChangeCause> causes;
    const auto add = [&](bool same, ChangeCause cause) {
        if (!same) causes.push_back(cause);
    };
    const bool same_ground = sameBands(before, after, [&](const Feature& a, const Feature& b) {
        return feature::sameRegion(a.target, b.target, tol);
    });
    add(same_ground, ChangeCause::Ground);
    add(change.before->top_z_mm == change.after->top_z_mm &&
            change.before->floor_z_mm == change.after->floor_z_mm,
        ChangeCause::Depth);
    add(change.before->feature_class == change.after->feature_class, ChangeCause::Kind);
    const bool same_tools = change.before->tools == change.after->tools;
    add(same_tools, ChangeCause::Tools);
    const bool same_lines =
        std::all_of(operations.begin(), operations.end(), [&](const OperationChange& operation) {
            return operation.feature_id != change.id || operation.change == Change::Kept;
        });
    // What stands around a feature matters where its operations are others for it; around other ground
    // always something else does.
    if (same_ground && (!same_tools || !same_lines))
        add(sameBands(before, after,
                      [&](const Feature& a, const Feature& b) {
                          return feature::sameRegion(a.obstruction, b.obstruction, tol) &&
                                 sameObstacles(a, b, tol);
                      }),
            ChangeCause::Surroundings);
    if (same_tools) add(same_lines, ChangeCause::Path);
    return causes;
}

/// Compares the setups of both plans and collects what became of all.
class PlanComparison {
  public:
    PlanComparison(PlanChange& change, const Tolerances& tol) : change_(change), tol_(tol) {}

    /// \param before, after  null where the plan has no such setup
    void compare(const SetupThen* before, const SetupThen* after) {
        compareOperations(before, after);
        compareFeatures(before, after);
    }

  private:
    void compareOperations(const SetupThen* before, const SetupThen* after) {
        if (after != nullptr)
            for (const auto& [id, operation] : after->operations)
                change_.operations.push_back(operationChange(
                    id, *after, before == nullptr ? nullptr : before->operation(id), &operation));
        if (before != nullptr)
            for (const auto& [id, operation] : before->operations)
                if (after == nullptr || after->operation(id) == nullptr)
                    change_.operations.push_back(operationChange(id, *before, &operation, nullptr));
    }

    void compareFeatures(const SetupThen* before, const SetupThen* after) {
        if (after != nullptr)
            for (const NamedBands& feature : after->features)
                compareFeature(feature.id, before, after);
        if (before != nullptr)
            for (const NamedBands& feature : before->features)
                if (after == nullptr || after->feature(feature.id) == nullptr)
                    compareFeature(feature.id, before, nullptr);
    }

    void compareFeature(const std::string& id, const SetupThen* before, const SetupThen* after) {
        const NamedBands* was = before == nullptr ? nullptr : before->feature(id);
        const NamedBands* is = after == nullptr ? nullptr : after->feature(id);
        FeatureChange change;
        change.id = id;
        change.setup_id = (after != nullptr ? after : before)->setup->id;
        if (was != nullptr) change.before = featureThen(*before, *was, tol_);
        if (is != nullptr) change.after = featureThen(*after, *is, tol_);
        const Region none;
        const Region& ground_before = was != nullptr ? change.before->target : none;
        const Region& ground_after = is != nullptr ? change.after->target : none;
        change.more_mm2 = area(subtract(ground_after, ground_before, tol_));
        change.less_mm2 = area(subtract(ground_before, ground_after, tol_));
        if (was == nullptr || is == nullptr) {
            change.change = was == nullptr ? Change::New : Change::Dropped;
        } else {
            change.causes = causesOf(*was, *is, change, change_.operations, tol_);
            change.change = change.causes.empty() ? Change::Kept : Change::Changed;
        }
        change_.features.push_back(std::move(change));
    }

    PlanChange& change_;
    Tolerances tol_;
};

/// Programs that are not written since the machine does not travel so far have no lines to compare: their
/// operations are others where their features or times are.
void compareWithoutLines(PlanChange& change) {
    std::set<std::string> changed;
    for (const FeatureChange& feature : change.features)
        if (feature.change == Change::Changed) changed.insert(feature.id);
    for (OperationChange& operation : change.operations) {
        if (operation.change != Change::Kept || !operation.after->lines.empty()) continue;
        if (changed.count(operation.feature_id) > 0 || operation.before->time_s != operation.after->time_s)
            operation.change = Change::Changed;
    }
}

int countLines(const std::string& text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// The programs of a setup that are written; empty for none.
std::vector<PostedProgram> programsOf(const RecordedPlan& plan, const std::string& setup_id) {
    for (const RecordedSetup& setup : plan.record.setups)
        if (setup.id == setup_id && setup.hasProgram()) return plan.files.programs.at(setup_id);
    return {};
}

ProgramChange programChange(const std::string& setup_id, const RecordedPlan& before,
                            const RecordedPlan& after, const std::vector<OperationChange>& operations) {
    ProgramChange change;
    change.setup_id = setup_id;
    std::string texts[2];
    bool there[2]{};
    int lines[2]{};
    const RecordedPlan* plans[] = {&before, &after};
    for (int side = 0; side < 2; ++side) {
        const std::vector<PostedProgram> programs = programsOf(*plans[side], setup_id);
        there[side] = !programs.empty();
        for (const PostedProgram& program : programs) {
            texts[side] += program.file + "\n" + program.text;
            lines[side] += countLines(program.text);
        }
    }
    change.lines_before = lines[0];
    change.lines_after = lines[1];
    change.same_bytes = texts[0] == texts[1];
    bool all_kept = true;
    for (const OperationChange& operation : operations) {
        if (operation.setup_id != setup_id) continue;
        change.lines_kept += operation.lines_kept;
        const bool in_place =
            operation.change == Change::Kept && operation.before->place == operation.after->place;
        all_kept = all_kept && in_place;
    }
    if (there[0] != there[1])
        change.change = there[1] ? Change::New : Change::Dropped;
    else
        change.change = all_kept ? Change::Kept : Change::Changed;
    return change;
}

const SetupThen* setupOf(const std::vector<SetupThen>& setups, const std::string& id) {
    const auto found =
        std::find_if(setups.begin(), setups.end(), [&](const SetupThen& one) { return one.setup->id == id; });
    return found == setups.end() ? nullptr : &*found;
}

std::vector<SetupThen> setupsThen(const RecordedPlan& plan) {
    std::vector<SetupThen> setups;
    for (const RecordedSetup& setup : plan.record.setups)
        setups.push_back(setupThen(plan, setup));
    return setups;
}

}  // namespace

PlanChange comparePlans(const RecordedPlan& before, const RecordedPlan& after, const Tolerances& tol) {
    PlanChange change;
    change.part_before = {before.record.part_file, before.record.part_sha256};
    change.part_after = {after.record.part_file, after.record.part_sha256};
    change.inputs = replan::inputChanges(before, after);
    change.currency = after.record.machine.currency;
    change.before = before.record.totals;
    change.after = after.record.totals;
    change.cycle = after.record.cycle;
    const std::vector<SetupThen> setups_before = setupsThen(before);
    const std::vector<SetupThen> setups_after = setupsThen(after);
    PlanComparison comparison(change, tol);
    std::vector<std::string> ids;
    for (const SetupThen& setup : setups_after) {
        comparison.compare(setupOf(setups_before, setup.setup->id), &setup);
        ids.push_back(setup.setup->id);
    }
    for (const SetupThen& setup : setups_before) {
        if (setupOf(setups_after, setup.setup->id) != nullptr) continue;
        comparison.compare(&setup, nullptr);
        ids.push_back(setup.setup->id);
    }
    compareWithoutLines(change);
    for (const std::string& id : ids)
        change.programs.push_back(programChange(id, before, after, change.operations));
    return change;
}

}  // namespace stepmill
