#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sequence/surrogates/lump_tools.h"
#include "sequence/surrogates/surrogates.h"

namespace stepmill {

/// Finds the ways to clear a lump: every tool that reaches all of it and, where the options allow sequences,
/// the cheapest sequence of tools. Where no tool reaches all of it: two or three tools that do so together.
/// The constructor finds out from areas alone whether there is a way; weigh() makes the paths.
class LumpSolver {
  public:
    /// \param standing  what is still not cleared around the lump when its turn comes
    /// \param held_off_id  the tool that the surrogates stand in for
    LumpSolver(std::shared_ptr<const SurrogateTools> surrogates, Region lump, std::vector<Region> standing,
               const std::string& held_off_id);

    bool servable() const { return servable_; }
    const Region& unserved() const { return unserved_; }
    double area_mm2() const { return tools_.ground().feature().area_mm2; }
    const ToolAssembly& toolOf(int surrogate) const { return *tools_.surrogates()[surrogate].tool; }

    /// Fills in ways() and totals().
    void weigh();
    const std::vector<LumpWay>& ways() const { return ways_; }
    const std::vector<std::vector<PathTotals>>& totals() const { return totals_; }
    /// \pre weigh() was called
    SequenceStep step(int way, std::size_t place) const;

  private:
    const SequenceJob& job() const { return tools_.job(); }
    const Tolerances& tol() const { return job().tolerances(); }
    bool sequencesCount() const { return job().options.surrogates == SurrogateRule::Sequence; }
    void sortSurrogates(const std::string& held_off_id);
    bool anyReachesAll();
    std::vector<int> partialSurrogates() const;
    Region residualOfTheBest() const;
    template <typename Visit>
    void visitSets(const Visit& visit) const;
    bool anySetReachesAll();
    void findWitnesses();
    bool reachAllWitnesses(const std::vector<int>& nodes) const;
    bool reachAllTogether(const std::vector<int>& nodes) const;

    double weight(const EdgeCost& cost) const;
    double changeWeight() const;
    double rateOf(const Surrogate& surrogate) const;
    double cheapestWay() const;
    void addWay(const std::vector<int>& nodes, std::vector<PathTotals> totals);
    double leastWeight(double mm3_per_s) const;
    std::vector<int> othersThatMayPay() const;
    void weighOneByOne();
    void weighSingles();
    bool mayPayTwo() const;
    void weighSequences();
    bool weighInARow(const std::vector<int>& nodes);
    void weighSets();

    LumpTools tools_;
    std::vector<int> whole_;    ///< surrogates that reach all of the lump in the whole feature
    std::vector<int> partial_;  ///< the others
    std::size_t offered_ = 0;   ///< how many of whole_ were offered to the lump
    /// Of some places in the lump: which nodes reach it. Filled before sets of tools are looked at.
    std::vector<std::vector<bool>> witnesses_;
    bool servable_ = false;
    Region unserved_;
    std::vector<LumpWay> ways_;
    std::vector<std::vector<PathTotals>> totals_;
};

}  // namespace stepmill
