#pragma once

#include <random>
#include <string>
#include <vector>

namespace stepmill::test {

/// Kinds of slips in an edited program. The last is none.
enum class EditKind {
    NumberChanged,
    WordRemoved,
    WordAdded,
    CodeReplaced,
    LineRemoved,
    LineDoubled,
    LinesSwapped,
    LineMoved,
    LineAdded,
    Harmless
};
inline constexpr int kEditKinds = 10;
std::string toString(EditKind kind);

struct ProgramEdit {
    EditKind kind = EditKind::Harmless;
    std::string what;  ///< for people: line and how it reads now
    std::vector<std::string> lines;
};

/// One edit of a program, by chance.
ProgramEdit editProgram(const std::vector<std::string>& lines, std::mt19937& random);

}  // namespace stepmill::test
