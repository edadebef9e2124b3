#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "sequence/dag/evaluate_dag.h"
#include "sequence/holder/holder_limits.h"
#include "sequence/surrogates/surrogates.h"

namespace stepmill {

/// A feature's evaluated tool DAG with all it was made from, to take other ways through it later.
class SequenceChoices {
  public:
    /// \param machine, library  must outlive this
    SequenceChoices(FeatureGround ground, const SequenceOptions& options, const Machine& machine,
                    const ToolLibrary& library, double retract_z_mm);

    // What the DAG is made from, filled in step by step.
    const FeatureGround ground;
    const SequenceOptions options;
    const Machine& machine;
    const ToolLibrary& library;
    const double retract_z_mm;
    std::vector<AccessibleArea> areas;
    std::unique_ptr<SurrogateFinder> finder;  ///< points into areas
    std::vector<Candidate> tools;             ///< point into areas
    std::vector<bool> ends;
    std::optional<Withheld> withheld;
    DagResult dag;

    DagTask task() const { return {ground, tools, ends, options, machine, retract_z_mm, finder.get()}; }

    /// The ways to choose from, listed when first asked for; the first is the DAG's cheapest. \pre the DAG is
    /// evaluated and has a path
    const std::vector<SequenceChoice>& choices() const;

    /// Fills in steps, edges, times and costs of the sequence for that one of choices(). \throws
    /// Error(Internal) if a path gouges
    void take(std::size_t index, ToolSequence& sequence) const;
    /// What stays after the cheapest way, and so after each of choices().
    const std::vector<Residual>& left() const;

  private:
    std::vector<SequenceStep> stepsOn(const std::vector<int>& path) const;
    std::vector<const Candidate*> usedOn(const std::vector<int>& path) const;
    const WeighedEdge* edgeBetween(int from, int to) const;
    std::vector<std::string> visitsOn(const std::vector<int>& path) const;
    bool leavesTheSame(const std::vector<int>& path) const;
    void list() const;
    void addWays(std::vector<int>& path, double weight) const;
    void addChoice(const std::vector<int>& path, double weight) const;

    mutable std::once_flag left_once_;
    mutable std::vector<Residual> left_;
    mutable std::once_flag listed_;
    mutable std::vector<SequenceChoice> choices_;
    mutable std::vector<std::vector<int>> paths_;  ///< of choices_
    mutable int seen_ = 0;
};

}  // namespace stepmill
