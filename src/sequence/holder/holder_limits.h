#pragma once

#include <optional>
#include <vector>

#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// Was the tool turned down because its shank or holder is in the way?
bool isHeldOff(const ToolReach& reach);

/// What the cutter that reaches most of a feature could clear, were it not too short or its holder in the
/// way, and what would let it. Of cutters that reach nearly as much, the one that needs the least longer
/// stick-out.
struct Withheld {
    Region coverable;
    bool too_short = false;  ///< everywhere; else its holder is in the way somewhere
    double diameter_mm = 0;
    double stick_out_mm = 0;        ///< with which it would
    double has_stick_out_mm = 0;    ///< now
    double holder_diameter_mm = 0;  ///< with no more than which it would; 0 where none is slim enough
};

/// A smaller depth that one tool reaches with nothing lost to its holder.
struct Shallower {
    double floor_z_mm = 0;
    double volume_mm3 = 0;  ///< that the tool clears down to there
    double diameter_mm = 0;
    double stick_out_mm = 0;      ///< that would do for the whole depth
    double has_stick_out_mm = 0;  ///< now
    bool by_flutes = false;       ///< a drill's flutes end before its stick-out does
};

/// What the cutter that reaches most of a feature is kept off or too short for; nothing when tools that take
/// part clear as much.
/// \param reaches  as the cutters and holders have them, before anything was admitted
/// \param most_mm2  most that a tool that takes part covers
std::optional<Withheld> withheldFrom(const FeatureGround& ground, const ToolLibrary& library, double most_mm2,
                                     const std::vector<ToolReach>& reaches);

/// The depth at which some tool of `reaches` that was turned down for its reach clears most; nothing when
/// none clears noticeably more than `known_mm3`.
std::optional<Shallower> shallower(const FeatureGround& ground, const ToolLibrary& library,
                                   const std::vector<ToolReach>& reaches, double known_mm3);

/// The feature down to a higher floor only; target, obstruction and obstacles stay, which is on the safe
/// side since what stands shrinks upwards.
Feature withFloor(Feature feature, double floor_z_mm);

}  // namespace stepmill
