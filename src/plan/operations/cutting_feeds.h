#pragma once

#include <map>
#include <string>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// What feeds follow from beside the paths.
struct CuttingFeedSettings {
    const PlanRequest& request;
    const ToolLibrary& library;  ///< with the stick-outs that are set
    const Machine& machine;
    const Tolerances& tol;
};

/// Paces of what is cut, each by the narrowest of what it belongs to that has one.
class Paces {
  public:
    /// \param of  a feature, a setup, or empty: all
    void set(const std::string& of, double pace) { by_scope_[of] = pace; }
    /// \param feature  whole, or a form ground
    double of(const std::string& setup, const std::string& feature) const;

  private:
    std::map<std::string, double> by_scope_;
};

/// The setups with the feeds of their clearing operations by what each move cuts, and with what that asks of
/// spindle and tools. These are the library's where the request has no material to cut or the machine no
/// spindle. Drills, finishing passes and form cutters keep the library's feeds. At a pace below 1 speeds and
/// feeds of all are as many times lower, but of taps, reamers and boring heads; one over 1 is for cuts whose
/// feeds are by what they cut alone (Operation::pace).
std::vector<PlannedSetup> withCuttingFeeds(std::vector<PlannedSetup> setups,
                                           const CuttingFeedSettings& settings, const Paces& paces);

}  // namespace stepmill
