#include "post/reader/block.h"

#include <cmath>
#include <cstring>

#include <fmt/format.h>

namespace stepmill::reader {
namespace {

/// Which controllers have a code?
enum class Having { All, LinuxCncAlone, FanucAlone, AllButGrbl };

struct KnownCode {
    char letter;
    int code;
    ModalGroup group;
    Having having = Having::All;
};

constexpr KnownCode kKnownCodes[] = {
    {'G', code(4), ModalGroup::NonModal},
    {'G', code(28), ModalGroup::NonModal},
    {'G', code(30), ModalGroup::NonModal},
    {'G', code(53), ModalGroup::NonModal},
    {'G', code(0), ModalGroup::Motion},
    {'G', code(1), ModalGroup::Motion},
    {'G', code(2), ModalGroup::Motion},
    {'G', code(3), ModalGroup::Motion},
    {'G', code(80), ModalGroup::Motion},
    {'G', code(73), ModalGroup::Motion, Having::AllButGrbl},
    {'G', code(81), ModalGroup::Motion, Having::AllButGrbl},
    {'G', code(82), ModalGroup::Motion, Having::AllButGrbl},
    {'G', code(83), ModalGroup::Motion, Having::AllButGrbl},
    {'G', code(85), ModalGroup::Motion, Having::AllButGrbl},
    {'G', code(89), ModalGroup::Motion, Having::AllButGrbl},
    // On LinuxCNC it is for taps in a chuck that gives way: the feed is not coupled to the spindle.
    {'G', code(84), ModalGroup::Motion, Having::FanucAlone},
    {'G', code(33, 1), ModalGroup::Motion, Having::LinuxCncAlone},
    {'G', code(17), ModalGroup::Plane},
    {'G', code(18), ModalGroup::Plane},
    {'G', code(19), ModalGroup::Plane},
    {'G', code(90), ModalGroup::Distance},
    {'G', code(91), ModalGroup::Distance},
    {'G', code(90, 1), ModalGroup::ArcDistance, Having::LinuxCncAlone},
    {'G', code(91, 1), ModalGroup::ArcDistance, Having::LinuxCncAlone},
    {'G', code(93), ModalGroup::FeedMode},
    {'G', code(94), ModalGroup::FeedMode},
    {'G', code(95), ModalGroup::FeedMode, Having::AllButGrbl},
    {'G', code(20), ModalGroup::Units},
    {'G', code(21), ModalGroup::Units},
    {'G', code(40), ModalGroup::CutterCompensation},
    {'G', code(43), ModalGroup::LengthOffset, Having::AllButGrbl},
    {'G', code(49), ModalGroup::LengthOffset},
    {'G', code(54), ModalGroup::WorkOffset},
    {'G', code(55), ModalGroup::WorkOffset},
    {'G', code(56), ModalGroup::WorkOffset},
    {'G', code(57), ModalGroup::WorkOffset},
    {'G', code(58), ModalGroup::WorkOffset},
    {'G', code(59), ModalGroup::WorkOffset},
    {'G', code(59, 1), ModalGroup::WorkOffset, Having::LinuxCncAlone},
    {'G', code(59, 2), ModalGroup::WorkOffset, Having::LinuxCncAlone},
    {'G', code(59, 3), ModalGroup::WorkOffset, Having::LinuxCncAlone},
    {'G', code(61), ModalGroup::PathControl},
    {'G', code(61, 1), ModalGroup::PathControl, Having::LinuxCncAlone},
    {'G', code(64), ModalGroup::PathControl, Having::AllButGrbl},
    {'G', code(98), ModalGroup::Retract, Having::AllButGrbl},
    {'G', code(99), ModalGroup::Retract, Having::AllButGrbl},
    {'M', code(0), ModalGroup::Stop},
    {'M', code(1), ModalGroup::Stop},
    {'M', code(2), ModalGroup::Stop},
    {'M', code(30), ModalGroup::Stop},
    {'M', code(6), ModalGroup::ToolChange, Having::AllButGrbl},
    {'M', code(3), ModalGroup::Spindle},
    {'M', code(4), ModalGroup::Spindle},
    {'M', code(5), ModalGroup::Spindle},
    {'M', code(29), ModalGroup::RigidTapping, Having::FanucAlone},
    {'M', code(7), ModalGroup::Coolant},
    {'M', code(8), ModalGroup::Coolant},
    {'M', code(9), ModalGroup::Coolant},
};

/// Letters that some code of ours uses; that it does is looked at with the block's motion.
constexpr const char* kKnownLetters = "NXYZIJKRPQFSTH";

bool hasIt(Having having, const DialectRules& rules) {
    switch (having) {
        case Having::LinuxCncAlone:
            return rules.own_words;
        case Having::FanucAlone:
            return rules.tapping == Tapping::G84;
        case Having::AllButGrbl:
            return rules.cycles;
        case Having::All:
            break;
    }
    return true;
}

const KnownCode* find(char letter, int wanted, const DialectRules& rules) {
    for (const KnownCode& known : kKnownCodes)
        if (known.letter == letter && known.code == wanted && hasIt(known.having, rules)) return &known;
    return nullptr;
}

}  // namespace

std::string codeName(char letter, int code) {
    return code % 10 == 0 ? fmt::format("{}{}", letter, code / 10)
                          : fmt::format("{}{}.{}", letter, code / 10, code % 10);
}

Block::Block(const std::vector<Word>& words, const DialectRules& rules, const Where& where) {
    for (const Word& word : words) {
        if (word.letter == 'G' || word.letter == 'M') {
            addCode(word, rules, where);
        } else if (std::strchr(kKnownLetters, word.letter) == nullptr) {
            where.refuse(fmt::format("words {} are not read", word.letter));
        } else if (!words_.emplace(word.letter, word).second) {
            where.refuse(fmt::format("{} stands twice in a block", word.letter));
        }
    }
}

void Block::addCode(const Word& word, const DialectRules& rules, const Where& where) {
    const double tenths = 10 * word.value;
    const KnownCode* known = tenths >= 0 && tenths < code(100) && std::abs(tenths - std::round(tenths)) < 1e-6
                                 ? find(word.letter, static_cast<int>(std::round(tenths)), rules)
                                 : nullptr;
    if (known == nullptr) where.refuse(fmt::format("{}{:g} is not read", word.letter, word.value));
    const auto [there, is_new] = codes_.emplace(known->group, known->code);
    if (!is_new)
        where.refuse(fmt::format("{} and {} in one block exclude each other",
                                 codeName(word.letter, there->second), codeName(word.letter, known->code)));
}

std::optional<int> Block::codeOf(ModalGroup group) const {
    const auto found = codes_.find(group);
    return found == codes_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> Block::number(char letter) const {
    const auto found = words_.find(letter);
    return found == words_.end() ? std::nullopt : std::optional(found->second.value);
}

bool Block::hasAny(const char* letters) const {
    for (const char* letter = letters; *letter != 0; ++letter)
        if (has(*letter)) return true;
    return false;
}

}  // namespace stepmill::reader
