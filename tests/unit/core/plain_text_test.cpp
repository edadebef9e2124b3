#include <gtest/gtest.h>

#include "stepmill/core/plain_text.h"

namespace stepmill {
namespace {

const std::string kReplaced = "\xEF\xBF\xBD";

TEST(PlainText, KeepsWhatIsFit) {
    const std::string text = "Ø 12 mm × 3\n\tBohrung „Æ“ 例 \U0001F529";
    EXPECT_EQ(plainText(text), text);
}

TEST(PlainText, ReplacesControlCharacters) {
    EXPECT_EQ(plainText("a\x1b[2J\x07"
                        "b\r\x7f"),
              "a" + kReplaced + "[2J" + kReplaced + "b" + kReplaced + kReplaced);
    EXPECT_EQ(plainText(std::string_view("a\0b", 3)), "a" + kReplaced + "b");
    EXPECT_EQ(plainText("\xc2\x9b"
                        "31m"),
              kReplaced + "31m");
}

TEST(PlainText, ReplacesBytesThatAreNoUtf8) {
    EXPECT_EQ(plainText("\xff"), kReplaced);
    EXPECT_EQ(plainText("\xe2\x82"), kReplaced + kReplaced);                  // cut off
    EXPECT_EQ(plainText("\xc0\xaf"), kReplaced + kReplaced);                  // "/" in two bytes
    EXPECT_EQ(plainText("\xed\xa0\x80"), kReplaced + kReplaced + kReplaced);  // half of a pair
    EXPECT_EQ(plainText("\xf4\x90\x80\x80").size(), 4 * kReplaced.size());    // beyond the last code
}

TEST(PlainText, ReplacesMarksThatTurnTheDirection) {
    EXPECT_EQ(plainText("a\xe2\x80\xae"
                        "b\xe2\x81\xa6"),
              "a" + kReplaced + "b" + kReplaced);
}

TEST(PlainLine, IsOneLine) {
    EXPECT_EQ(plainLine("a\nb\tc"), "a b c");
}

}  // namespace
}  // namespace stepmill
