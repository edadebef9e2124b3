#include "sequence/dag/sequence_choices.h"
#include "sequence/steps/residuals.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {
namespace {

using SharedJob = std::shared_ptr<const SequenceJob>;

ToolSequence sequenceTo(const SharedJob& job, bool may_end_higher);

/// The steps down to where tools reach, and the rest as residual.
ToolSequence sequenceAbove(const SequenceJob& job, const Shallower& reached) {
    const auto above =
        std::make_shared<const SequenceJob>(withFloor(job.feature(), reached.floor_z_mm), job.library,
                                            job.machine, job.options, job.tolerances());
    ToolSequence sequence = sequenceTo(above, false);
    Residual below = belowReach(job.feature(), reached);
    // What makes the whole depth has its point below it.
    for (Residual& left : sequence.residual)
        if (left.reason == Reason::DrillPoint) left.advice = below.advice;
    sequence.residual.push_back(std::move(below));
    return sequence;
}

ToolSequence sequenceTo(const SharedJob& job, bool may_end_higher) {
    const Feature& feature = job->feature();
    const std::vector<ToolReach> alone = reachesOfAllTools(*job);
    Admission admission = admitTools(job, alone);
    const double most_mm2 = mostUsableMm2(*job, admission.reaches);
    if (may_end_higher) {
        const double known_mm3 = most_mm2 * feature.depth_mm();
        if (const auto reached = shallower(job->ground, job->library, alone, known_mm3)) {
            ToolSequence above = sequenceAbove(*job, *reached);
            if (!above.steps.empty()) return above;
        }
    }
    ToolSequence sequence;
    sequence.feature_id = feature.id;
    sequence.floor_z_mm = feature.floor_z_mm;
    sequence.tools = admission.reaches;
    const auto choices = std::make_shared<const SequenceChoices>(
        job, std::move(admission), withheldFrom(job->ground, job->library, most_mm2, alone));
    sequence.pruned_edges = choices->dag().pruned;
    if (choices->empty()) {
        sequence.residual.push_back(wholeFeature(job->ground, sequence.tools, job->library));
        return sequence;
    }
    choices->take(0, sequence);
    TimeBounds bounds = choices->bounds();
    sequence.lower_bound_s = bounds.with_changes_s;
    sequence.least = std::move(bounds.as_cut);
    sequence.residual = choices->residuals();
    sequence.choices = choices;
    return sequence;
}

}  // namespace

ToolSequence sequenceTools(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                           const SequenceOptions& options, const Tolerances& tol) {
    return sequenceTo(std::make_shared<const SequenceJob>(feature, library, machine, options, tol), true);
}

}  // namespace stepmill
