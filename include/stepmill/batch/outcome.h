#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stepmill {

/// What came of a part of a batch.
enum class Outcome {
    Waiting,      ///< its turn has not come, or was cut short
    Complete,     ///< planned and proven, nothing stays
    Gaps,         ///< planned and proven; something stays or is in doubt, as the reason says
    Refused,      ///< no plan: the file or the options are not what a plan can be made of
    TimedOut,     ///< its limit of time ended it
    OutOfMemory,  ///< its limit of memory ended it
    KernelCrash,  ///< the geometry kernel crashed on the file
    Bug,          ///< a bug in Stepmill: a crash, or a plan that is not proven
    Killed,       ///< a signal from outside ended it
    Unwritable,   ///< its results could not be written: a full disk, say
    Missing,      ///< the file could not be read when the batch began
    Changed       ///< the file was no longer the one the batch had read
};

std::string toString(Outcome outcome);
/// The reverse; nothing for another word.
std::optional<Outcome> outcomeFrom(std::string_view word);

/// All in the order of reports.
const std::vector<Outcome>& allOutcomes();

/// Is there a plan?
bool hasPlan(Outcome outcome);

/// Does a batch that goes on plan the part again? What is not the part's own doing is done again; with
/// `retry` also what limits and crashes ended.
bool isDoneAgain(Outcome outcome, bool retry);

/// Of all parts, as every command's: 0 all complete, 1 a plan of some with gaps or none, 3 a bug in any.
int exitCodeOf(const std::vector<Outcome>& outcomes);

}  // namespace stepmill
