#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sequence/dag/evaluate_dag.h"
#include "sequence/surrogates/surrogate_tools.h"

namespace stepmill {

/// The tools offered to one lump, with what each reaches there. They are the nodes of the lump's own tool
/// DAG.
class LumpTools {
  public:
    /// \param standing  what is still not cleared around the lump when its turn comes
    LumpTools(std::shared_ptr<const SurrogateTools> surrogates, Region lump, std::vector<Region> standing);
    LumpTools(const LumpTools&) = delete;
    LumpTools& operator=(const LumpTools&) = delete;

    const SequenceJob& job() const { return surrogates_->job(); }
    const std::vector<Surrogate>& surrogates() const { return surrogates_->all(); }
    const Region& lump() const { return lump_; }
    /// The lump as a feature.
    const FeatureGround& ground() const { return ground_; }

    /// Adds these surrogates, by number. A surrogate that can do nothing in the lump becomes no node.
    void offer(const std::vector<int>& surrogates);
    void clear();
    /// Drops all nodes but those that clear the whole lump.
    void keepEnds();

    const std::vector<Candidate>& nodes() const { return nodes_; }
    /// Does the node clear the whole lump?
    bool ends(int node) const { return ends_[node]; }
    bool anyEnds() const;
    int surrogateOf(int node) const { return surrogate_of_[node]; }
    /// \pre the surrogate is a node
    int nodeOf(int surrogate) const;

    /// The task of evaluating the lump's own DAG. Refers to this object.
    DagTask task() const;
    /// Makes the rings that these nodes' paths share.
    void makeRings(const std::vector<int>& nodes);
    /// The rings of each node, where others made them.
    /// \pre one for each node, some null
    void useRings(std::vector<SharedRings> rings) { rings_ = std::move(rings); }
    /// Rings take most of what a lump takes of memory, and are not needed once its ways are weighed.
    void dropRings() { rings_.assign(nodes_.size(), nullptr); }
    /// The path of a node after another (kSource: nothing cut yet); nothing where it has nothing new to
    /// clear.
    /// \pre makeRings() was called for the node
    std::optional<PathTotals> totalsOf(int before, int node) const;

  private:
    ToolReach reachIn(int surrogate) const;
    void makeNodes();

    std::shared_ptr<const SurrogateTools> surrogates_;
    const Tolerances& tol_;
    Region lump_;
    std::vector<Region> standing_;
    FeatureGround ground_;
    Surroundings around_;             ///< what stands near the lump, of the feature's
    std::vector<ToolReach> reaches_;  ///< in the lump
    std::vector<int> numbers_;        ///< surrogate of each of reaches_, rising
    std::vector<Candidate> nodes_;    ///< point into reaches_
    std::vector<int> surrogate_of_;   ///< surrogate of each node
    std::vector<bool> ends_;          ///< of each node
    std::vector<SharedRings> rings_;  ///< of each node; null until made
};

}  // namespace stepmill
