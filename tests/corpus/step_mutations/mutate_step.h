#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stepmill::test {

enum class EditKind { Number, Reference, Flag };

std::string_view wordOf(EditKind kind);

/// A token of the DATA section that an edit may replace; `begin` and `end` are offsets into the text.
struct EditSpot {
    EditKind kind = EditKind::Number;
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Every number, reference and enumeration between DATA; and ENDSEC;, outside strings and comments. Reads the
/// text by itself, not with the reader under test. The id an entity is defined by is no spot.
std::vector<EditSpot> editSpots(std::string_view text);

/// The text with one spot replaced, and what was replaced in words.
struct EditedStep {
    EditKind kind = EditKind::Number;
    std::string text;
    std::string edit;  ///< "#168 = VECTOR('',#169,1.) : 1. -> 0."
};

/// One edit of a kind, chosen by the seed: same text and seed, same edit.
EditedStep editStep(const std::string& text, const std::vector<EditSpot>& spots, EditKind kind,
                    std::uint64_t seed);

}  // namespace stepmill::test
