#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/sequence/sequence.h"
#include "stepmill/toolpath/cutting_model.h"

// Plans that are to take a given time [Tripathi2005].

namespace stepmill {

/// Operations are driven no slower than this times their cutting data: a cutter that turns still slower
/// rather tears than cuts.
inline constexpr double kSlowestPace = 0.5;
/// ... and no faster than this: the chip of a thin cut at its fastest.
inline constexpr double kFastestPace = kMostChipThinning;
/// A time is kept by one that is at most this share of it longer or shorter.
inline constexpr double kCycleTimeShare = 0.01;
/// Longer ones are slips of the pen [s].
inline constexpr double kLongestCycleTimeS = 100.0 * 3600;

/// A time that the part, one of its setups or one of its features is to take.
struct CycleTarget {
    std::string of;     ///< "S1", "S1.F3"; empty: the part
    double time_s = 0;  ///< with the machine's acceleration where that is given; tool changes count but in
                        ///< features
};

/// What time goes to.
enum class TimeUse {
    Cut,          ///< clearing, at feeds by what is cut: CutSummary::limit tells by what they are held
    LibraryFeed,  ///< clearing at the library's feeds, as there is no cutting model
    Holes,        ///< tools for holes
    Finishing,    ///< passes whose feed is that of the finish
    Forms,        ///< form cutters, the same
    Rapids,
    Acceleration,
    ToolChanges
};
std::string toString(TimeUse use);
/// The reverse; nothing for another word.
std::optional<TimeUse> timeUseFrom(std::string_view word);

struct UsedTime {
    TimeUse use = TimeUse::Cut;
    std::optional<FeedLimit> limit;  ///< of cuts: what holds them for most of their time
    double time_s = 0;
};

/// What became of a time that was asked for.
struct CycleOutcome {
    CycleTarget target;
    double planned_s = 0;  ///< by the cutting data
    double pace = 1;       ///< of all operations that no narrower target is for
    double time_s = 0;     ///< at that pace
    /// What the same tools take at least, where it is to be shorter, or at most, where it is to be longer.
    double bound_s = 0;
    std::vector<UsedTime> uses;  ///< the longest first

    bool isMet() const;
    /// Of one that is not met: is it too long, not too short?
    bool isTooLong() const { return time_s > target.time_s; }
};

/// Of one that is not met: "takes 33.3 s at the least, 20.0 s were asked for".
std::string missedWords(const CycleOutcome& outcome);

/// Ways to a shorter time, in the order in which they are tried.
enum class CycleWay {
    Feeds,      ///< the pace, of all operations
    Diameter,   ///< a wider tool begins a feature
    Objective,  ///< tools are chosen by time, not by money
    Sequence    ///< a feature does without one of its tools
};
std::string toString(CycleWay way);
/// The reverse; nothing for another word.
std::optional<CycleWay> cycleWayFrom(std::string_view word);

/// One that was tried.
struct CycleStep {
    CycleWay way = CycleWay::Feeds;
    std::string of;          ///< CycleTarget::of
    double before_s = 0;     ///< what that took
    double after_s = 0;      ///< and takes with it, at the pace that suits it then
    double pace = 1;         ///< of Feeds
    std::string feature;     ///< of Diameter: the band
    std::string tool;        ///< of Diameter: that began it; of Sequence: that is done without
    double wanted_mm = 0;    ///< of Diameter: by area / (time x feed)
    double diameter_mm = 0;  ///< of Diameter: what is to begin is at least as wide
    int passes = 0;  ///< of Diameter: by width / (diameter - overlap), rounded; 0: none is as wide as wanted
    bool leaves_more = false;  ///< material would stay that does not now
    bool taken = false;
};

/// What a plan did for the times that were asked for; of a plan that none was asked of nothing.
struct CycleTimes {
    std::vector<CycleOutcome> outcomes;  ///< in the order of the targets
    std::vector<CycleStep> steps;

    bool areMet() const;
};

/// What a feature's sequence is asked for beyond being the cheapest.
struct SequenceWish {
    double first_at_least_mm = 0;         ///< SequenceOptions::first_at_least_mm
    std::set<std::string> without_tools;  ///< ids
};

// The rule of [Tripathi2005, 'Finding New Tool Diameter'] --------------------------------------------------

/// What it takes to find a wider tool for a cut.
struct WiderCut {
    double area_mm2 = 0;  ///< of all its depths
    double time_s = 0;    ///< that it may take
    double feed_mm_per_min = 0;
    double width_mm = 0;  ///< of the ground across its passes
};

/// A cutter that there is.
struct AvailableCutter {
    double diameter_mm = 0;
    double step_over_mm = 0;  ///< diameter less the overlap of two passes
};

struct WiderChoice {
    double wanted_mm = 0;  ///< area / (time x feed)
    double diameter_mm = 0;
    int passes = 0;
};

/// The first cutter at least as wide as `area / (time x feed)` whose passes, `width / step-over`, are more
/// than half a pass over a whole number: these are rounded up. Where they are less over it the next wider one
/// has one pass less and is looked at. Of none that fits the rule the narrowest that is wide enough, with its
/// passes rounded up: the paper does not say. Nothing where none is as wide.
/// \param cutters  in any order
/// \pre all of the cut is positive
std::optional<WiderChoice> widerCutter(const WiderCut& cut, std::vector<AvailableCutter> cutters);

/// What the rule wants [mm].
double wantedDiameterMm(const WiderCut& cut);

}  // namespace stepmill
