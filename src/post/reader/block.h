#pragma once

#include <map>
#include <optional>

#include "post/reader/lexer.h"

namespace stepmill::reader {

/// Of the codes in one group only one is in force [RS274/NGC, 3.4]. The last five hold M codes.
enum class ModalGroup {
    NonModal,  ///< G4, G28, G30, G53: for their block alone
    Motion,
    Plane,
    Distance,
    ArcDistance,
    FeedMode,
    Units,
    CutterCompensation,
    LengthOffset,
    WorkOffset,
    PathControl,
    Retract,
    Stop,
    ToolChange,
    Spindle,
    RigidTapping,
    Coolant
};

/// G or M codes in tenths: they may have one decimal.
constexpr int code(int whole, int tenths = 0) {
    return 10 * whole + tenths;
}

constexpr bool isCycle(int motion) {
    return motion == code(73) || (motion >= code(81) && motion <= code(85)) || motion == code(89);
}
constexpr bool isArc(int motion) {
    return motion == code(2) || motion == code(3);
}

/// "G59.1"
std::string codeName(char letter, int code);

/// A line sorted: at most one code a group, at most one word a letter.
class Block {
  public:
    /// Refuses codes the dialect does not have, two of a group, two words of a letter.
    Block(const std::vector<Word>& words, const DialectRules& rules, const Where& where);

    std::optional<int> codeOf(ModalGroup group) const;
    bool has(ModalGroup group, int code) const { return codeOf(group) == code; }
    std::optional<double> number(char letter) const;
    bool has(char letter) const { return words_.count(letter) > 0; }
    bool hasAny(const char* letters) const;
    const std::map<char, Word>& words() const { return words_; }

  private:
    void addCode(const Word& word, const DialectRules& rules, const Where& where);

    std::map<ModalGroup, int> codes_;
    std::map<char, Word> words_;  ///< but G, M
};

}  // namespace stepmill::reader
