#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stepmill/layers/face_trace.h"

namespace stepmill {

/// Smaller pieces that stay are listed, but not worth a warning [mm3].
inline constexpr double kWorthAWarningMm3 = 1;

/// Why material stays: of what no feature owns, and of what a feature's tools leave.
enum class Reason {
    // Behind walls that are not vertical, one a SlopeCause.
    LeaningWall,
    SlantedFace,
    Chamfer,
    EdgeFillet,
    FloorFillet,
    DrillPoint,  ///< of a hollow cone that closes to a point, and of what a drill's point leaves of a floor
    AcrossAxis,
    FreeForm,
    Overhang,
    // In no feature otherwise.
    Undercut,             ///< the part hides it from above
    LeftForLater,         ///< it stands for later setups, which cut it, or under what does
    Sliver,               ///< too thin for a region
    LeftByEarlierSetups,  ///< stands where no face of the part is finished from here
    // In a feature.
    CornerRadius,
    NoNarrowCutter,
    HolderCollision,
    TooDeep,
    NoWayIn,
    NoCuttingData,
    Fixture,            ///< a fixture stands there
    BelowStanding,      ///< below what the features above leave
    Allowance,          ///< roughing leaves it on walls and floors, as asked
    Holding,            ///< it is held in this setup
    AsAsked,            ///< the hole table leaves it
    LeftBetweenPasses,  ///< small places that the proof found
    NotProven,          ///< no program that cuts it was proven
    PlanningFailed,     ///< an error ended the planning of its feature
    TimeLimit,          ///< the time for planning was over
    Unknown,            ///< of a plan.json: words of another version
};

/// A reason, and what it says of this case.
struct StayReason {
    Reason kind = Reason::Unknown;
    std::string detail;  ///< features, lengths, a tool; of an unknown reason its words; mostly empty

    bool operator==(const StayReason&) const = default;
    bool operator==(Reason other) const { return kind == other; }
};

/// The words of plan.json and the reports: "corner radius", "too deep (the tools reach 20 of 30 mm)".
std::string toString(const StayReason& reason);
/// The reverse.
StayReason stayReasonFrom(std::string_view words);

/// The reason of what a wall hides that is not vertical.
Reason reasonOf(SlopeCause cause);

/// Is it what a setup leaves of what it reaches, without being any feature's residual: allowance and held
/// stock?
bool isLeftUncut(const StayReason& reason);

/// Does it lie on a wall that leans, or on a curved face, that looks up to the tool?
bool isOnLeaningWall(const StayReason& reason);

/// Is it what roughing leaves as it should: the allowance, and stairs on walls that lean and on curved faces?
bool isLeftByRoughing(const StayReason& reason);

/// The order of reports.
struct InOrderOfWords {
    bool operator()(const StayReason& a, const StayReason& b) const { return toString(a) < toString(b); }
};

/// Volume under one reason.
struct ReasonVolume {
    StayReason reason;
    double volume_mm3 = 0;
};

}  // namespace stepmill
