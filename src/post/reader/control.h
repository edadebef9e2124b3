#pragma once

#include <optional>
#include <string>

#include "post/dialect.h"
#include "post/reader/action.h"
#include "post/reader/block.h"
#include "post/reader/where.h"

namespace stepmill::reader {

/// What a cycle keeps from block to block. Lengths are numbers as the program has them: a change of units
/// does not change these.
struct CycleWords {
    double z = 0;
    double r = 0;
    double q = 0;
    double dwell_s = 0;
};

/// A machine's controller: what it is set to, where the tool is, and what has been done. What the words of a
/// block change in it stands in modes.h, moves.h and cycles.h.
struct Control {
    explicit Control(const DialectRules& of_dialect) : rules(of_dialect) { run.states.emplace_back(); }

    const DialectRules& rules;
    const Where* where = nullptr;  ///< the line in hand
    Run run;
    MachineState state;
    Place at;
    double mm_per_unit = 0;  ///< 0: not yet said
    bool arc_centre_absolute = false;
    std::optional<int> motion_in_force;  ///< nothing after G80 and at first
    std::optional<bool> back_to_start;   ///< G98: cycles return to the height they came from; else to R
    CycleWords cycle;
    bool rigid_tapping = false;         ///< M29: the next G84 couples the feed to the spindle
    std::optional<double> cycles_from;  ///< height at which the first of the cycles in a row began [mm]
    double feed = 0;                    ///< F in force, mm/min or mm/rev
    std::optional<int> prepared_tool;

    /// Millimetres of the program's unit.
    double unit() const;
    double length(double number) const;
    /// The word as a length; nothing where the block has none.
    std::optional<double> lengthOf(const Block& block, char letter) const;
    double dwellSeconds(const Word& word) const;
    bool changesUnits(const Block& block) const;
    /// The feed of a motion, in mm/min whatever the mode.
    double feedFor(const Block& block, double length_mm) const;
    [[noreturn]] void refuse(const std::string& what) const { where->refuse(what); }

    void act(Doing doing);
    /// To a place of the work offset's.
    void goTo(Motion motion, const Place& to);
    void goToHeight(MotionKind kind, double z_mm);
    /// To a place of the machine's own.
    /// \param across  X or Y move
    void toMachinePlace(const Place& to, bool across);
    /// Where the tool is in the work offset's coordinates is not known any more; at the top it stays.
    void losePlace();

  private:
    void go(Motion motion, const Place& to);
};

}  // namespace stepmill::reader
