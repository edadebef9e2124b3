#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/catalog/fixture.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/feature/feature.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// Down to here the steps of a hole make it in its whole width; nothing where they do not make it [mm].
std::optional<double> boredToZ(const Feature& hole, const ToolSequence& made, const ToolLibrary& library);

/// The hole as that tap finds it: a through hole with a fixture or the part below, as far down as the tap
/// would go out of it, is none to a tap. Taps go out farther than drills, for whom Feature::through tells of
/// both.
Feature asTapFinds(Feature hole, const ToolAssembly& tap, const std::vector<Fixture>& fixtures,
                   const Tolerances& tol);

/// The tip of a tap goes no deeper: in a blind hole a pitch over the end of its whole width, so that chips
/// have room and an overrun of the spindle breaks nothing; through a hole by its lead and a pitch, where
/// nothing stands below.
double deepestTapTipZ(const Feature& hole, const ToolAssembly& tap, double bored_to_z_mm);

/// Shank or holder of the tap would come into the hole, or meet what stands beside it, with its tip that
/// deep: which, in words; empty where they do not.
std::string tapShankTrouble(const Feature& hole, const ToolAssembly& tap, double tip_z_mm);

/// As fast as the cutting data say, and as the machine's spindle and axes let it: whole turns a minute, so
/// that the feed is pitch x speed to the last decimal. 0: the machine is too slow.
double tapSpeedRpm(const ToolAssembly& tap, const CuttingData& cutting, const Machine& machine);

/// What is to be tapped.
struct TapTask {
    const Feature& hole;  ///< as its tap finds it, its raw top as high as it may be
    double bored_to_z_mm = 0;
    double top_z_mm = 0;         ///< the hole's own
    double thread_depth_mm = 0;  ///< of full thread from there on; 0: as deep as the hole allows
    std::vector<Vec2> places;    ///< of the hole's axes those to be tapped
    double retract_z_mm = 0;
};

/// How deep a tap goes for the depth that is asked for; with trouble where the hole ends before that, or is
/// too shallow for a full turn.
struct TapDepth {
    double tip_z_mm = 0;
    double full_z_mm = 0;  ///< the whole thread goes down to here
    std::string trouble;
};

TapDepth tapDepth(const TapTask& task, const ToolAssembly& tap);

/// A tap's step, or why there is none.
struct TapStep {
    std::optional<SequenceStep> step;
    std::string trouble;
};

/// The step of one tap. It does not fit where the hole is no core of its thread, is too shallow for the depth
/// asked for (or, without one, for a single full turn), or where tapShankTrouble() says so.
/// \pre tap.isTap(), places not empty
TapStep tapStep(const TapTask& task, const ToolAssembly& tap, const CuttingData& cutting,
                const Machine& machine);

}  // namespace stepmill
