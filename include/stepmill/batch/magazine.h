#pragma once

#include <string>
#include <vector>

namespace stepmill {

/// One way to machine a feature.
struct ToolWay {
    std::vector<std::string> tools;  ///< ids, each once
    double cost = 0;                 ///< seconds or money of a piece, its tool changes included
};

/// A feature that is to be machined, in one of several ways that leave the same material.
struct ToolTask {
    std::vector<ToolWay> ways;
    double pieces = 1;
};

struct MagazineTerms {
    int places = 0;        ///< 0: as many as there are tools
    double load_cost = 0;  ///< seconds or money to put a tool in, once
    /// Sets of tools that are looked at before the search ends without proof.
    long most_sets = 200000;
};

/// What one tool is worth beside those in the magazine.
struct ToolValue {
    std::string tool;
    bool inside = false;
    int serves = 0;    ///< tasks that only it serves, beside the others inside
    double saves = 0;  ///< cost of the other tasks without it, less with it; of loading it nothing
};

/// The tools that serve all tasks best together.
struct Magazine {
    std::vector<std::string> tools;  ///< ids, sorted
    int unserved = 0;                ///< tasks with no way by these tools; as few as there can be
    double cost = 0;                 ///< of all served tasks' cheapest ways, and of loading
    double all_tools_cost = 0;       ///< the same with every tool in the magazine, places or not
    double bound = 0;                ///< no magazine that serves as many tasks costs less
    bool proven = false;             ///< it is the best: `bound` is `cost`
    std::vector<ToolValue> values;   ///< of every tool, by id
};

/// The best set of tools for one magazine: first the one that leaves the fewest tasks unserved, then the one
/// that costs least. Branch and bound over the tools, those that matter most first: with a tool undecided
/// every task may use it for nothing, which no decision can make cheaper. Where `most_sets` does not suffice,
/// it is the best set found, and `bound` says how far from the best it may be.
/// \note  each set costs one look at every way
Magazine bestMagazine(const std::vector<ToolTask>& tasks, const MagazineTerms& terms);

}  // namespace stepmill
