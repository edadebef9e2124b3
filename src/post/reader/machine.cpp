#include "post/reader/machine.h"

#include "post/reader/block_rules.h"
#include "post/reader/modes.h"
#include "post/reader/moves.h"

namespace stepmill::reader {

bool Machine::obey(const Block& block, const Where& where) {
    control_.where = &where;
    const std::optional<int> motion = motionOf(control_, block);
    checkBlock(control_, block, motion);
    setModes(control_, block);
    goHome(control_, block);
    if (motion) move(control_, block, *motion);
    if (block.has(ModalGroup::Motion, code(80))) {
        control_.motion_in_force.reset();
        control_.cycles_from.reset();
        control_.rigid_tapping = false;
    }
    return stop(block);
}

void Machine::note(const std::string& comment, const Where& where) {
    control_.where = &where;
    control_.act(Comment{comment});
}

bool Machine::stop(const Block& block) {
    const auto code_of_stop = block.codeOf(ModalGroup::Stop);
    // Where the operator changes tools, he does it while the program waits.
    const bool waits = code_of_stop == code(0) || code_of_stop == code(1);
    if (waits && !control_.rules.tool_changer && control_.prepared_tool &&
        control_.state.tool != control_.prepared_tool) {
        if (code_of_stop == code(1))
            control_.refuse("M1 stops by a switch, the tool has to be changed at M0");
        control_.state.tool = control_.prepared_tool;
        control_.act(ToolChange{});
        control_.at = {};
    }
    if (!code_of_stop || waits) return true;
    control_.state.spin = Spin::Off;
    control_.state.mist = control_.state.flood = false;
    control_.act(ProgramEnd{});
    return false;
}

}  // namespace stepmill::reader
