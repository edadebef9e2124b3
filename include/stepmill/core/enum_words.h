#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "stepmill/core/error.h"

namespace stepmill {

/// A value of an enum and the word for it in files, options and reports. An enum with words has one table of
/// all its values, which toString() and its reverse read, so that they cannot differ:
///
///     constexpr EnumWord<Coolant> kCoolants[] = {{Coolant::Off, "off"}, {Coolant::Mist, "mist"}};
template <typename Enum>
struct EnumWord {
    Enum value;
    std::string_view word;
};

/// \throws Error(Internal) for a value that the table lacks
template <typename Enum, std::size_t kCount>
std::string wordOf(const EnumWord<Enum> (&words)[kCount], Enum value) {
    for (const EnumWord<Enum>& entry : words)
        if (entry.value == value) return std::string(entry.word);
    throw Error(ErrorCode::Internal, std::string("enum beside ") + std::string(words[0].word),
                "a value has no word");
}

/// Nothing where no value has the word.
template <typename Enum, std::size_t kCount>
std::optional<Enum> valueOf(const EnumWord<Enum> (&words)[kCount], std::string_view word) {
    for (const EnumWord<Enum>& entry : words)
        if (entry.word == word) return entry.value;
    return std::nullopt;
}

/// "off, mist": what may be written, in the table's order.
template <typename Enum, std::size_t kCount>
std::string allWords(const EnumWord<Enum> (&words)[kCount]) {
    std::string all;
    for (const EnumWord<Enum>& entry : words)
        all += (all.empty() ? "" : ", ") + std::string(entry.word);
    return all;
}

}  // namespace stepmill
