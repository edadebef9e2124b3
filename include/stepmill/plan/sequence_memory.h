#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "stepmill/feature/feature.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// Sequences of features as the plans before made them, so that a part that is planned again, with more
/// caution or with stock left for later setups, takes time for what changed alone. No plan is another by it,
/// but where time was short: what took too long is not tried again in as little time.
///
/// Of one part, one machine and one set of tolerances, and of libraries that are parts of one. Asked by any
/// number of threads.
class SequenceMemory {
  public:
    using Make = std::function<ToolSequence()>;

    /// What `make` gives, or gave for a feature with the same geometry, the same tools and options; the names
    /// of features and the deadline may differ.
    /// \throws what `make` does; Error(TimedOut) where it did so before with no less time to the deadline
    ToolSequence sequence(const Feature& feature, const ToolLibrary& library, const SequenceOptions& options,
                          const Make& make);

    /// Forgets what none of the last few plans asked for: sequences hold all that was weighed for them,
    /// megabytes each.
    void beginPlan();

  private:
    struct Known {
        ToolSequence sequence;
        int asked_in = 0;  ///< number of the last plan that asked
    };

    std::mutex mutex_;
    std::map<std::string, Known> known_;  ///< by what a sequence follows from, hashed
    /// Likewise, of what was not ready in time: the longest it was given [s].
    std::map<std::string, double> in_vain_;
    int plan_ = 0;
};

}  // namespace stepmill
