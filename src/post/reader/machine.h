#pragma once

#include "post/dialect.h"
#include "post/reader/action.h"
#include "post/reader/block.h"

namespace stepmill::reader {

/// What a cycle keeps from block to block. Lengths are numbers as the program has them: a change of units
/// does not change these.
struct CycleWords {
    double z = 0;
    double r = 0;
    double q = 0;
    double dwell_s = 0;
};

/// A machine with its controller: obeys one block after another and notes what it does.
///
/// The order within a block is RS274/NGC's [3.8]: feed mode, feed, speed, tool preparation, tool change,
/// spindle, coolant, dwell, plane, units, cutter compensation, length offset, work offset, path control,
/// distance mode, retract mode, home, motion, stop.
class Machine {
  public:
    explicit Machine(const DialectRules& rules) : rules_(rules) { run_.states.emplace_back(); }

    /// False when the program ends with the block.
    bool obey(const Block& block, const Where& where);
    void note(const std::string& comment, const Where& where);
    Run run() { return std::move(run_); }

  private:
    /// The motion code that a block's words are for: its own, or the one in force; nothing without motion.
    std::optional<int> motionOf(const Block& block) const;
    void checkWords(const Block& block, std::optional<int> motion) const;
    void checkModes(const Block& block, std::optional<int> motion) const;

    void setFeed(const Block& block);
    void setSpindle(const Block& block);
    void prepareTool(const Block& block);
    void changeTool(const Block& block);
    void setCoolant(const Block& block);
    void dwellIn(const Block& block);
    void setModes(const Block& block);
    void setLengthOffset(const Block& block);
    void setWorkOffset(const Block& block);
    void setPathControl(const Block& block);
    void goHome(const Block& block);
    void move(const Block& block, int motion);
    bool stop(const Block& block);

    void moveInMachine(const Block& block);
    void straight(const Block& block, int motion);
    void arc(const Block& block, bool ccw);
    void drill(const Block& block, int cycle);
    CycleWords cycleWords(const Block& block, int cycle) const;
    void feedDown(int cycle, const CycleWords& words, double r, double bottom, double clear_mm);

    Place target(const Block& block) const;
    std::optional<double> axisTarget(const Block& block, char letter, const std::optional<double>& at) const;
    double unit() const;
    double length(double number) const;
    std::optional<double> lengthOf(const Block& block, char letter) const;
    double dwellSeconds(const Word& word) const;
    double feedFor(const Block& block, double length_mm) const;
    bool changesUnits(const Block& block) const;
    void goTo(Motion motion, const Place& to);
    void goToHeight(MotionKind kind, double z_mm);
    void toMachinePlace(const Place& to, bool across);
    void go(Motion motion, const Place& to);
    void losePlace();
    void act(Doing doing);
    [[noreturn]] void refuse(const std::string& what) const { where_->refuse(what); }

    const DialectRules& rules_;
    const Where* where_ = nullptr;
    Run run_;
    MachineState state_;
    Place at_;
    double mm_per_unit_ = 0;
    bool arc_centre_absolute_ = false;
    std::optional<int> motion_;          ///< in force; nothing after G80 and at first
    std::optional<bool> back_to_start_;  ///< G98: cycles return to the height they came from; else to R
    CycleWords cycle_;
    std::optional<double> cycles_from_;  ///< height at which the first of the cycles in a row began [mm]
    double feed_ = 0;                    ///< F in force, mm/min or mm/rev
    std::optional<int> prepared_tool_;
};

}  // namespace stepmill::reader
