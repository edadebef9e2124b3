#include <gtest/gtest.h>

#include "report/page/element.h"
#include "report/page/table.h"

namespace stepmill::report {
namespace {

TEST(Element, EscapesWhateverIsAddedAsText) {
    const std::string hostile = "</p><script>\"1\" & 2";
    EXPECT_EQ(Element("p", hostile).markup(), "<p>&lt;/p&gt;&lt;script&gt;&quot;1&quot; &amp; 2</p>\n");
    EXPECT_EQ(Element("b").with("class", "\"><i>").markup(), "<b class=\"&quot;&gt;&lt;i&gt;\"></b>");
}

TEST(Element, ShowsNoControlCharacters) {
    EXPECT_EQ(Element("b", "a\x1b[2J\xff").markup(), "<b>a\xEF\xBF\xBD[2J\xEF\xBF\xBD</b>");
}

TEST(Element, TakesTextElementsListsAndOptions) {
    std::vector<Element> list{Element("li", "one"), Element("li", "two")};
    const std::optional<Element> none;
    EXPECT_EQ(Element("div", "a", Element("b", "c"), none, std::move(list)).markup(),
              "<div>a<b>c</b><li>one</li>\n<li>two</li>\n</div>\n");
}

TEST(Element, TakesClassesFromItsTagAndFromAttributes) {
    EXPECT_EQ(Element("td.n.bad").with("class", "late").markup(), "<td class=\"n bad late\"></td>");
}

TEST(Element, ClosesWhatMayStandEmptyAndNothingElse) {
    EXPECT_EQ(Element("meta").with("charset", "utf-8").markup(), "<meta charset=\"utf-8\"/>\n");
    EXPECT_EQ(Element("path").with("d", "M 0 0").markup(), "<path d=\"M 0 0\"/>\n");
    EXPECT_EQ(Element("td").markup(), "<td></td>");
}

TEST(Anchor, GivesEveryNameAnIdOfItsOwn) {
    EXPECT_EQ(Anchor("feature", "S1.F1").id(), "feature-S1.F1");
    EXPECT_EQ(Anchor("tool", "a b_\"").id(), "tool-a_20b_5f_22");
    EXPECT_NE(Anchor("tool", "a_20").id(), Anchor("tool", "a ").id());
    EXPECT_EQ(linkTo(Anchor("feature", "S1.F1"), "<S1>").markup(),
              "<a href=\"#feature-S1.F1\">&lt;S1&gt;</a>");
}

TEST(Table, RangesNumbersRight) {
    Table table({"tool", numbers("mm")});
    table.row("EM<4>", "4.0").set("class", "chosen");
    EXPECT_EQ(std::move(table).element().markup(),
              "<div class=\"scroll\"><table><thead><tr><th scope=\"col\">tool</th>"
              "<th class=\"n\" scope=\"col\">mm</th></tr>\n</thead>\n"
              "<tbody><tr class=\"chosen\"><td>EM&lt;4&gt;</td><td class=\"n\">4.0</td></tr>\n</tbody>\n"
              "</table>\n</div>\n");
}

TEST(Table, WithoutRowsIsNoElementWhereItNeedNotBe) {
    EXPECT_FALSE(Table({"tool"}).elementIfAny());
}

}  // namespace
}  // namespace stepmill::report
