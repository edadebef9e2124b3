#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/part/part.h"
#include "stepmill/setup/prism.h"

namespace stepmill {

/// Work of a setup that a later one could do instead, weighed by what it takes there and here.
struct WeighedWork {
    std::string feature;  ///< band of the earlier setup
    std::string setup;    ///< axis of the later one
    double volume_mm3 = 0;
    double early_s = 0;  ///< of its paths in the earlier setup, by its share of the band's volume
    double late_s = 0;   ///< the same in the later one
    bool left = false;   ///< for the later setup
};

/// Stock that a setup might leave for later ones.
struct ReserveProposal {
    CutPrisms reserve;
    double gain_s = 0;              ///< by estimate, without tool changes
    std::vector<WeighedWork> work;  ///< by feature, then setup
};

/// What became of a proposal that was planned, by the first that is so.
enum class Verdict {
    SavesTooLittle,  ///< or takes longer
    MoreSetups,
    HeldWorse,  ///< a setup or a piece of it
    MoreStays,
    Taken
};
std::string toString(Verdict verdict);
/// The reverse; nothing for another word.
std::optional<Verdict> verdictFrom(std::string_view word);

/// A proposal that was planned.
struct TriedReserve {
    std::string setup;  ///< that would leave stock
    ReserveProposal proposal;
    double before_s = 0;   ///< the whole plan without it, with setup times
    double with_s = 0;     ///< and with it
    double stays_mm3 = 0;  ///< more than without it
    Verdict verdict = Verdict::SavesTooLittle;
};

/// What became of a set of setups.
enum class SetupVerdict {
    Taken,
    LeavesMore,  ///< material than the one that was taken
    TakesLonger,
    HeldWorse,
    CannotTakeLess,  ///< not planned: setting up alone takes longer than the plan that was taken
    NoTime,          ///< not planned
    CannotBePlanned  ///< an error ended its planning
};
std::string toString(SetupVerdict verdict);
/// The reverse; nothing for another word.
std::optional<SetupVerdict> setupVerdictFrom(std::string_view word);

/// A set of setups that was considered.
struct SetupChoice {
    struct Planned {
        double time_s = 0;   ///< of the plan, a piece
        double setup_s = 0;  ///< to set up, shared among the pieces of the lot, and to load each
        double stays_mm3 = 0;
    };
    std::vector<Vec3> axes;  ///< in part coordinates, in machining order
    std::optional<Planned> planned;
    SetupVerdict verdict = SetupVerdict::Taken;
};

/// Which setup cuts what.
struct Assignment {
    /// The setups' axes in part coordinates, in machining order: asked for, or chosen by whole plans.
    std::vector<Vec3> axes;
    /// Those of the setups that sight asks for, or that were asked for; empty where a plan has no choice of
    /// what each leaves: of roughing, and in a frame with tabs.
    std::vector<Vec3> seen;
    std::vector<SetupChoice> choices;  ///< the one taken first; empty: there was one
    /// What each of the chosen setups leaves for later ones, by its place; without prisms: nothing.
    std::vector<CutPrisms> reserves;
    std::vector<TriedReserve> tried;  ///< in the order of the setups
};

}  // namespace stepmill
