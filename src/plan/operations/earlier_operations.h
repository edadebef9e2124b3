#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// Finds the operations of a setup in the plan that it is made after, and numbers those that are new.
class EarlierOperations {
  public:
    /// \param setup    with the operations that have ids already
    /// \param earlier  outlives this object
    EarlierOperations(const PlannedSetup& setup, const std::vector<EarlierSetup>& earlier);

    /// Its place in the order of that plan: the first there of its feature, tool and role that was not found
    /// yet. Nothing for a new one.
    std::optional<std::size_t> find(const Operation& operation);
    /// The id it had there or, where it is new, one with a number over all of that plan.
    std::string idOf(const Operation& operation);

  private:
    std::string setup_id_;
    const EarlierSetup* earlier_;
    std::vector<bool> found_;
    int last_number_ = 0;
};

}  // namespace stepmill
