#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// A tool the library lacks and what a feature would gain by it.
struct Purchase {
    ToolAssembly tool;
    std::string why;                 ///< "12 mm: the widest for the inside corners of 6 mm"
    std::vector<std::string> tools;  ///< the sequence with it
    double saved_s = 0;              ///< of the feature's time; negative where it machines more
    double saved_cost = 0;
    double more_mm3 = 0;  ///< volume it machines that stays without it; 0 where that is not worth naming
    int holes = 0;        ///< of the feature that it serves; 0: the feature is no hole
};

struct PurchaseAdvice {
    std::string feature_id;
    double time_s = 0;  ///< with the library as it is
    double cost = 0;
    double stays_mm3 = 0;          ///< residual with the library as it is
    int trials = 0;                ///< tools that were tried on real paths
    std::optional<Purchase> best;  ///< nothing when none of them helps noticeably
};

/// The one tool beyond the library that helps this feature most: first by what it machines that else stays
/// (from a hundredth of the feature's volume on), then by time or cost, as the objective asks.
///
/// Candidates are end mills of the diameters at which the access curve changes and of the usual series, with
/// cutting data interpolated from the library's neighbours; a drill of the diameter of a hole that goes
/// through or ends in a point; and cutters of the library, where the holder or their reach kept them off,
/// with the stick-out that would do. The area model of [Lim2000] sorts them; the most promising
/// kPurchaseTrials are sequenced on real paths with the whole library beside them. So what is reported is
/// really saved, but a better one may be missed.
/// \note  Costs an access curve and up to kPurchaseTrials times what sequencing the feature does.
/// \see docs/algorithms/ranking.md
PurchaseAdvice whatToBuy(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                         const SequenceOptions& options, const Tolerances& tol);

/// The tools among some that can be bought which help this feature, each alone beside the whole library; none
/// where the library has them all. As in whatToBuy() the area model sorts them and the most promising
/// kPurchaseTrials are sequenced on real paths: what is told is really saved, others may help too.
std::vector<Purchase> purchasesFrom(const std::vector<ToolAssembly>& offers, const Feature& feature,
                                    const ToolLibrary& library, const Machine& machine,
                                    const SequenceOptions& options, const Tolerances& tol);

/// Tools tried on real paths for one feature, each about as long as planning it.
inline constexpr int kPurchaseTrials = 4;

}  // namespace stepmill
