#include "stepmill/batch/outcome.h"

#include "stepmill/core/enum_words.h"

namespace stepmill {
namespace {

constexpr EnumWord<Outcome> kOutcomes[] = {{Outcome::Complete, "complete"},
                                           {Outcome::Gaps, "gaps"},
                                           {Outcome::Refused, "refused"},
                                           {Outcome::TimedOut, "timed-out"},
                                           {Outcome::OutOfMemory, "memory"},
                                           {Outcome::KernelCrash, "kernel-crash"},
                                           {Outcome::Bug, "bug"},
                                           {Outcome::Killed, "killed"},
                                           {Outcome::Unwritable, "unwritable"},
                                           {Outcome::Missing, "missing"},
                                           {Outcome::Changed, "changed"},
                                           {Outcome::Waiting, "waiting"}};

}  // namespace

std::string toString(Outcome outcome) {
    return wordOf(kOutcomes, outcome);
}

std::optional<Outcome> outcomeFrom(std::string_view word) {
    return valueOf(kOutcomes, word);
}

const std::vector<Outcome>& allOutcomes() {
    static const std::vector<Outcome> all = [] {
        std::vector<Outcome> outcomes;
        for (const EnumWord<Outcome>& entry : kOutcomes)
            outcomes.push_back(entry.value);
        return outcomes;
    }();
    return all;
}

bool hasPlan(Outcome outcome) {
    return outcome == Outcome::Complete || outcome == Outcome::Gaps;
}

bool isDoneAgain(Outcome outcome, bool retry) {
    switch (outcome) {
        case Outcome::Complete:
        case Outcome::Gaps:
        case Outcome::Refused:
            return false;
        case Outcome::TimedOut:
        case Outcome::OutOfMemory:
        case Outcome::KernelCrash:
        case Outcome::Bug:
            return retry;
        case Outcome::Waiting:
        case Outcome::Killed:
        case Outcome::Unwritable:
        case Outcome::Missing:
        case Outcome::Changed:
            return true;
    }
    return true;
}

int exitCodeOf(const std::vector<Outcome>& outcomes) {
    constexpr int kComplete = 0;
    constexpr int kGaps = 1;
    constexpr int kBug = 3;
    int exit_code = kComplete;
    for (const Outcome outcome : outcomes) {
        if (outcome == Outcome::Bug) return kBug;
        if (outcome != Outcome::Complete) exit_code = kGaps;
    }
    return exit_code;
}

}  // namespace stepmill
