#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sequence/surrogates/surrogate_tools.h"
#include "sequence/surrogates/surrogates.h"

namespace stepmill {

/// Finds the ways to clear a lump: every tool that reaches all of it and, as the options allow, the cheapest
/// sequence of tools; where no tool reaches all, two or three that do together. First from areas alone
/// whether there is a way, and, when asked, the ways with their paths.
class LumpSolver {
  public:
    /// Finds out whether there is a way.
    /// \param standing  what around the lump is not cleared when its turn comes
    /// \param held_off_id  the tool in whose place others are sought
    LumpSolver(std::shared_ptr<const SurrogateTools> tools, Region lump, std::vector<Region> standing,
               std::string held_off_id);

    bool servable() const { return servable_; }
    const Region& unserved() const { return unserved_; }
    double area_mm2() const { return ground_.feature().area_mm2; }
    const ToolAssembly& toolOf(int surrogate) const { return *surrogates_->all()[surrogate].tool; }

    /// Fills in ways() and totals().
    void weigh();
    const std::vector<LumpWay>& ways() const { return ways_; }
    const std::vector<std::vector<PathTotals>>& totals() const { return totals_; }
    /// \pre weigh() was called
    SequenceStep step(int way, std::size_t place) const;

  private:
    const SequenceJob& job() const { return surrogates_->job(); }
    const Surrogate& surrogate(int number) const { return surrogates_->all()[number]; }
    bool sequencesCount() const { return job().options.surrogates == SurrogateRule::Sequence; }
    DagTask task() const {
        return {ground_, tools_, ends_, job().options, job().machine, job().retract_z_mm};
    }
    ToolReach reachIn(int surrogate) const;
    void sortSurrogates();
    bool anyReachesAll();
    void offer(const std::vector<int>& surrogates);
    void listTools();
    int surrogateOf(const Candidate& tool) const { return numbers_[tool.reach - reaches_.data()]; }
    std::size_t nodeOf(int surrogate) const;
    void keepWholeSurrogates();
    std::vector<int> partialSurrogates() const;
    Region residualOfTheBest() const;
    template <typename Visit>
    void visitSets(const Visit& visit) const;
    bool reachAllTogether(const std::vector<int>& nodes) const;

    double weight(const EdgeCost& cost) const;
    double changeWeight() const;
    double rateOf(const Surrogate& surrogate) const;
    void addWay(const std::vector<int>& nodes, std::vector<PathTotals> totals);
    std::optional<PathTotals> totalsOf(int before, int node) const;
    void makeRingsOf(const std::vector<int>& nodes);
    void weighSingles();
    bool mayPayTwo() const;
    void weighSequences();
    bool weighInARow(const std::vector<int>& nodes);
    void weighSets();

    std::shared_ptr<const SurrogateTools> surrogates_;
    const Tolerances& tol_;
    Region lump_;
    std::vector<Region> standing_;
    std::string held_off_id_;
    FeatureGround ground_;
    std::vector<int> whole_;    ///< surrogates that reach all of the lump in the whole feature
    std::vector<int> partial_;  ///< the others
    std::size_t offered_ = 0;   ///< how many of whole_ have their reaches
    bool servable_ = false;
    Region unserved_;
    std::vector<ToolReach> reaches_;  ///< in the lump
    std::vector<int> numbers_;        ///< surrogate of each of reaches_
    std::vector<Candidate> tools_;    ///< point into reaches_
    std::vector<int> surrogate_of_;   ///< surrogate of each of tools_
    std::vector<bool> ends_;          ///< which of tools_ clear the whole lump
    std::vector<SharedRings> rings_;
    std::vector<LumpWay> ways_;
    std::vector<std::vector<PathTotals>> totals_;
};

}  // namespace stepmill
