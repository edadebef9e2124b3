#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "sequence/dag/evaluate_dag.h"
#include "sequence/dag/lower_bound.h"
#include "sequence/dag/ways.h"
#include "sequence/surrogates/admission.h"
#include "sequence/surrogates/shelf.h"

namespace stepmill {

/// A feature's evaluated tool DAG with all it was made from, to take other ways through it later. Owns or
/// shares all it points to; safe to share between threads.
class SequenceChoices {
  public:
    /// Evaluates the DAG.
    /// \param withheld  what the cutter that reaches most is kept off, for the residuals' reasons
    SequenceChoices(std::shared_ptr<const SequenceJob> job, Admission admission,
                    std::optional<Withheld> withheld);

    /// No tool can machine anything: there is nothing to choose from.
    bool empty() const { return dag_.path.empty(); }
    /// The DAG's nodes, by falling diameter.
    const std::vector<Candidate>& tools() const { return tools_; }
    const DagResult& dag() const { return dag_; }
    TimeBounds bounds() const;
    /// What stays after the cheapest way, and so after each of choices().
    const std::vector<Residual>& residuals() const { return residuals_; }

    /// The ways to choose from, listed when first asked for; the first is the DAG's cheapest.
    /// \pre !empty()
    std::vector<SequenceChoice> choices() const;
    /// Fills in steps, edges, times and costs of the sequence for that one of choices().
    /// \throws Error(Internal) if a path gouges
    void take(std::size_t index, ToolSequence& sequence) const;

  private:
    DagTask task() const;
    const std::vector<Way>& ways() const;
    std::vector<const Candidate*> usedOn(const std::vector<int>& path) const;
    bool lastReachesAll(const std::vector<int>& path) const;
    bool leavesTheSame(const std::vector<int>& path) const;
    std::vector<SequenceStep> stepsOn(const std::vector<int>& path) const;

    const std::shared_ptr<const SequenceJob> job_;
    const Admission admission_;
    const std::optional<Withheld> withheld_;
    const std::vector<Candidate> tools_;  ///< point into job_ and admission_
    const std::vector<bool> ends_;
    const DagResult dag_;
    const std::vector<Residual> residuals_;
    Shelf<std::pair<int, int>, bool> within_;  ///< does the second node reach all that the first clears?
    mutable std::once_flag listed_;
    mutable std::vector<Way> ways_;
};

}  // namespace stepmill
