#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sequence/surrogates/surrogates.h"

namespace stepmill {

/// A tool that can work in lumps.
struct Helper {
    const ToolAssembly* tool = nullptr;
    const AccessibleArea* reach = nullptr;  ///< A'_x in the whole feature
};

/// What is the same for all lumps of a feature.
struct LumpSettings {
    const FeatureGround& ground;
    const ToolLibrary& library;
    const SequenceOptions& options;
    const Machine& machine;
    double retract_z_mm = 0;
    std::vector<Helper> helpers;  ///< by falling diameter
    /// obstructionWithHolder() of a helper.
    std::function<const Region&(int helper)> obstruction;
};

/// Finds the ways to clear a lump: every tool that reaches all of it and, as the options allow, the cheapest
/// sequence of tools; where no tool reaches all, two or three that do together. First from areas alone
/// whether there is a way, and, when asked, the ways with their paths.
class LumpSolver {
  public:
    /// Finds out whether there is a way.
    /// \param settings  must outlive this
    /// \param standing  what around the lump is not cleared when its turn comes
    /// \param held_off_id  the tool in whose place others are sought
    LumpSolver(const LumpSettings& settings, Region lump, std::vector<Region> standing,
               std::string held_off_id);

    bool servable() const { return servable_; }
    const Region& unserved() const { return unserved_; }
    double area_mm2() const { return ground_.feature().area_mm2; }
    const ToolAssembly& toolOf(int helper) const { return *settings_.helpers[helper].tool; }

    /// Fills in ways() and totals().
    void weigh();
    const std::vector<LumpWay>& ways() const { return ways_; }
    const std::vector<std::vector<PathTotals>>& totals() const { return totals_; }
    /// \pre weigh() was called
    SequenceStep step(int way, std::size_t place) const;

  private:
    bool sequencesCount() const { return settings_.options.surrogates == SurrogateRule::Sequence; }
    DagTask task() const {
        return {ground_, tools_, ends_, settings_.options, settings_.machine, settings_.retract_z_mm};
    }
    AccessibleArea areaIn(int helper) const;
    void sortHelpers();
    bool anyReachesAll();
    void offer(const std::vector<int>& helpers);
    void listTools();
    int helperOf(const Candidate& tool) const { return numbers_[tool.area - areas_.data()]; }
    std::size_t nodeOf(int helper) const;
    void keepThoseWhoReachAll();
    std::vector<int> thoseWhoReachSome() const;
    Region leftByTheBest() const;
    template <typename Visit>
    void visitSets(const Visit& visit) const;
    bool reachAllTogether(const std::vector<int>& nodes) const;

    double weight(const EdgeCost& cost) const;
    double changeWeight() const;
    double helperRate(const Helper& helper) const;
    void addWay(const std::vector<int>& nodes, std::vector<PathTotals> totals);
    std::optional<PathTotals> totalsOf(int before, int node) const;
    void makeRingsOf(const std::vector<int>& nodes);
    void weighSingles();
    bool mayPayTwo() const;
    void weighSequences();
    bool weighInARow(const std::vector<int>& nodes);
    void weighSets();

    const LumpSettings& settings_;
    const Tolerances& tol_;
    Region lump_;
    std::vector<Region> standing_;
    std::string held_off_id_;
    FeatureGround ground_;
    std::vector<int> whole_;    ///< helpers that reach all of the lump in the whole feature
    std::vector<int> partial_;  ///< the others
    std::size_t offered_ = 0;   ///< how many of whole_ have their areas
    bool servable_ = false;
    Region unserved_;
    std::vector<AccessibleArea> areas_;
    std::vector<int> numbers_;      ///< helper of each of areas_
    std::vector<Candidate> tools_;  ///< point into areas_
    std::vector<int> helpers_;      ///< helper of each of tools_
    std::vector<bool> ends_;        ///< which of tools_ clear the whole lump
    std::vector<SharedRings> rings_;
    std::vector<LumpWay> ways_;
    std::vector<std::vector<PathTotals>> totals_;
};

}  // namespace stepmill
