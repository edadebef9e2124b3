// What a block may hold.

#include "post/reader/block_rules.h"

#include <cmath>

#include <fmt/format.h>

namespace stepmill::reader {
namespace {

/// Where LinuxCNC takes a number for a whole one.
constexpr double kWholeNumber = 1e-4;

/// Every word is for something in the block.
void checkWords(const Control& control, const Block& block, std::optional<int> motion) {
    const bool arc = motion && isArc(*motion);
    const bool cycle = motion && isCycle(*motion);
    const bool dwells = block.has(ModalGroup::NonModal, code(4));
    const bool blends = block.has(ModalGroup::PathControl, code(64)) && control.rules.own_words;
    const auto need = [&](char letter, bool used, const char* for_what) {
        if (block.has(letter) && !used)
            control.refuse(fmt::format("{} without {} to use it", letter, for_what));
    };
    need('I', arc, "G2 or G3");
    need('J', arc, "G2 or G3");
    need('K', motion == code(33, 1), "G33.1");
    need('R', arc || cycle, "G2, G3 or a cycle");
    need('P',
         dwells || blends || (arc && control.rules.own_words) || motion == code(82) || motion == code(89),
         "G4, G64, G82, G89 or an arc");
    need('Q', blends || motion == code(73) || motion == code(83), "G73 or G83");
    need('H', block.has(ModalGroup::LengthOffset, code(43)), "G43");
    for (const char letter : {'P', 'Q', 'F', 'S'})
        if (block.number(letter).value_or(0) < 0) control.refuse(fmt::format("{} is negative", letter));
    for (const char letter : {'T', 'H'})
        if (const auto number = block.number(letter))
            if (*number < 0 || *number > 1e6 || std::abs(*number - std::round(*number)) > kWholeNumber)
                control.refuse(fmt::format("{}{:g} is no whole number", letter, *number));
    if (arc && block.has('P')) {
        const double turns = *block.number('P');
        if (std::abs(turns - std::round(turns)) > 1e-3 || std::round(turns) < 1 || turns > 1000)
            control.refuse("P in an arc is a whole number of turns");
    }
}

/// Codes of a block that do not go together.
void checkModes(const Control& control, const Block& block, std::optional<int> motion) {
    const bool dwells = block.has(ModalGroup::NonModal, code(4));
    if (dwells && !block.has('P')) control.refuse("G4 without P");
    if (dwells && motion && isArc(*motion)) control.refuse("G4 with an arc: both use P");
    if (dwells && control.rules.dwell_in_ms && block.hasAny("XYZ"))
        control.refuse("G4 with axis words, of which X is a time on this controller");
    if (motion == code(33, 1) && !(block.has('Z') && block.has('K'))) control.refuse("G33.1 without Z and K");
    if (block.has(ModalGroup::RigidTapping, code(29)) && block.hasAny("XYZ"))
        control.refuse("M29 with axis words");
    if (motion && isCycle(*motion) && !block.hasAny("XYZ"))
        control.refuse(codeName('G', *motion) + " without axis words");
    if (!block.has(ModalGroup::NonModal, code(53))) return;
    if (motion != code(0)) control.refuse("G53 without G0");
    const auto distance = block.codeOf(ModalGroup::Distance);
    if (distance ? *distance == code(91) : control.state.distance == DistanceMode::Incremental)
        control.refuse("G53 with G91: a place of the machine's is no distance");
}

}  // namespace

std::optional<int> motionOf(const Control& control, const Block& block) {
    const std::optional<int> own = block.codeOf(ModalGroup::Motion);
    const bool goes_home =
        block.has(ModalGroup::NonModal, code(28)) || block.has(ModalGroup::NonModal, code(30));
    if (own && *own != code(80)) {
        if (goes_home) control.refuse(codeName('G', *own) + " with G28 or G30: both use the axis words");
        return own;
    }
    const bool axes = block.hasAny("XYZ");
    if (goes_home) return std::nullopt;
    if (own && axes) control.refuse("axis words with G80, which ends motions");
    const bool arc_words = control.motion_in_force && isArc(*control.motion_in_force) && block.hasAny("IJ");
    if (!axes && !arc_words) return std::nullopt;
    if (!control.motion_in_force) control.refuse("axis words without a G code that uses them");
    return control.motion_in_force;
}

void checkBlock(const Control& control, const Block& block, std::optional<int> motion) {
    checkWords(control, block, motion);
    checkModes(control, block, motion);
}

}  // namespace stepmill::reader
