#include <gtest/gtest.h>

#include "stepmill/core/enum_words.h"

namespace stepmill {
namespace {

enum class Colour { Red, Green, Unnamed };

constexpr EnumWord<Colour> kColours[] = {{Colour::Red, "red"}, {Colour::Green, "green"}};

TEST(EnumWords, AreReadBothWays) {
    EXPECT_EQ(wordOf(kColours, Colour::Green), "green");
    EXPECT_EQ(valueOf(kColours, "green"), Colour::Green);
    EXPECT_EQ(valueOf(kColours, "grey"), std::nullopt);
    EXPECT_EQ(allWords(kColours), "red, green");
}

TEST(EnumWords, ThatAreMissingAreAFaultOfOurs) {
    try {
        wordOf(kColours, Colour::Unnamed);
        FAIL() << "the value has no word";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Internal);
    }
}

}  // namespace
}  // namespace stepmill
