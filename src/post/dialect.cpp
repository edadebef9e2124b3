#include "post/dialect.h"

#include "stepmill/core/enum_words.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

constexpr EnumWord<Dialect> kDialects[] = {
    {Dialect::LinuxCnc, "linuxcnc"}, {Dialect::Fanuc, "fanuc"}, {Dialect::Grbl, "grbl"}};

}  // namespace

std::string toString(Dialect dialect) {
    return wordOf(kDialects, dialect);
}

std::optional<Dialect> dialectFrom(std::string_view word) {
    return valueOf(kDialects, word);
}

Dialect dialectOf(const Machine& machine) {
    if (const auto dialect = dialectFrom(machine.dialect)) return *dialect;
    throw Error(ErrorCode::Usage, "machine " + machine.name,
                "there is no post for dialect '" + machine.dialect + "'; known: " + allWords(kDialects));
}

const DialectRules& rulesOf(Dialect dialect) {
    static const DialectRules kLinuxCnc{.tapping = Tapping::G331,
                                        .cycles = true,
                                        .tool_changer = true,
                                        .tool_lengths = true,
                                        .percent = false,
                                        .home_by = HomeBy::G53,
                                        .home_needs_axes = false,
                                        .dwell_in_ms = false,
                                        .any_program_name = true,
                                        .own_words = true,
                                        .blends_corners = true,
                                        .sticks_to_point = false,
                                        .semicolon_comments = true,
                                        .longest_block = 252,
                                        .safe_start = "G17 G40 G49 G80 G90 G94",
                                        .extension = ".ngc"};
    static const DialectRules kFanuc{.tapping = Tapping::G84,
                                     .cycles = true,
                                     .tool_changer = true,
                                     .tool_lengths = true,
                                     .percent = true,
                                     .home_by = HomeBy::G28,
                                     .home_needs_axes = true,
                                     .dwell_in_ms = true,
                                     .any_program_name = false,
                                     .own_words = false,
                                     .blends_corners = false,
                                     .sticks_to_point = true,
                                     .semicolon_comments = false,
                                     .longest_block = 252,
                                     .safe_start = "G17 G40 G49 G80 G90 G94",
                                     .extension = ".nc"};
    // GRBL 1.1 refuses H words and M6; G49 and G80 it takes.
    static const DialectRules kGrbl{.tapping = Tapping::None,
                                    .cycles = false,
                                    .tool_changer = false,
                                    .tool_lengths = false,
                                    .percent = false,
                                    .home_by = HomeBy::G28,
                                    .home_needs_axes = false,
                                    .dwell_in_ms = false,
                                    .any_program_name = true,
                                    .own_words = false,
                                    .blends_corners = true,
                                    .sticks_to_point = false,
                                    .semicolon_comments = true,
                                    .longest_block = 79,
                                    .safe_start = "G17 G40 G49 G80 G90 G94",
                                    .extension = ".gcode"};
    switch (dialect) {
        case Dialect::Fanuc:
            return kFanuc;
        case Dialect::Grbl:
            return kGrbl;
        case Dialect::LinuxCnc:
            break;
    }
    return kLinuxCnc;
}

std::string programName(const std::string& name, Dialect dialect) {
    return name + rulesOf(dialect).extension;
}

}  // namespace stepmill
