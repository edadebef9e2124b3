#include "stepmill/catalog/access_table.h"

#include <gtest/gtest.h>

#include "stepmill/core/error.h"

namespace stepmill {
namespace {

const std::string kHeader = "diameter_mm,volume_cm3,mrr_cm3_per_min\n";

/// The message of the error a text is refused with.
std::string refusal(const std::string& text) {
    try {
        accessTableFromText(text, "cutters.csv");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
        EXPECT_TRUE(isInputError(error.code()));
        return error.what();
    }
    return "taken";
}

TEST(AccessTable, ReadsRowsInTheFilesOrder) {
    const auto rows =
        accessTableFromText(kHeader + "12,525.174,84.7152\n10,525.176,46.744858\n", "cutters.csv");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].diameter_mm, 12);
    EXPECT_EQ(rows[0].volume_cm3, 525.174);
    EXPECT_EQ(rows[1].mrr_cm3_per_min, 46.744858);
    EXPECT_EQ(rows[0].tool, "");
}

TEST(AccessTable, TakesBlanksBlankLinesCarriageReturnsAndAByteOrderMark) {
    const auto rows = accessTableFromText(
        "\xEF\xBB\xBF"
        "diameter_mm, volume_cm3, mrr_cm3_per_min\r\n\r\n 6 ,\t0 , 1e1\r\n",
        "cutters.csv");
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].diameter_mm, 6);
    EXPECT_EQ(rows[0].volume_cm3, 0);
    EXPECT_EQ(rows[0].mrr_cm3_per_min, 10);
}

TEST(AccessTable, NamesFileLineAndWhatWasExpected) {
    EXPECT_EQ(refusal(""),
              "cutters.csv, line 1: expected the header diameter_mm,volume_cm3,mrr_cm3_per_min, found ''");
    EXPECT_EQ(refusal(kHeader), "cutters.csv, line 2: expected a cutter, found the end of the file");
    EXPECT_EQ(
        refusal(kHeader + "10,5,3\n\n12,5\n"),
        "cutters.csv, line 4: expected three numbers diameter_mm,volume_cm3,mrr_cm3_per_min, found '12,5'");
    EXPECT_EQ(refusal(kHeader + "ten,5,3\n"),
              "cutters.csv, line 2: expected a diameter_mm above 0, found 'ten'");
    EXPECT_EQ(refusal(kHeader + "10,-5,3\n"),
              "cutters.csv, line 2: expected a volume_cm3 of 0 or more, found '-5'");
    EXPECT_EQ(refusal(kHeader + "10,5,0\n"),
              "cutters.csv, line 2: expected an mrr_cm3_per_min above 0, found '0'");
}

TEST(AccessTable, RefusesNumbersThatAreNone) {
    for (const char* cell : {"nan", "inf", "1e400", "1e-400", "", "1.5mm", "0x10", "1,5"})
        EXPECT_NE(refusal(kHeader + cell + ",5,3\n"), "taken") << cell;
    EXPECT_NE(refusal("diameter_mm;volume_cm3;mrr_cm3_per_min\n1;2;3\n"), "taken");
}

TEST(AccessTable, TakesAThousandCuttersAndNoMore) {
    std::string text = kHeader;
    for (int i = 0; i < 1000; ++i)
        text += "10,5,3\n";
    EXPECT_EQ(accessTableFromText(text, "cutters.csv").size(), 1000u);
    EXPECT_EQ(refusal(text + "10,5,3\n"), "cutters.csv, line 1002: expected no more than 1000 cutters");
}

TEST(AccessTable, CutsLongFindingsShort) {
    EXPECT_LT(refusal(std::string(100000, 'x')).size(), 200u);
}

TEST(AccessTable, WhatIsWrittenReadsBackBitForBit) {
    const std::vector<AccessRow> rows{{"EM12", 12, 1.0 / 3, 84.7152}, {"EM10", 0.1 + 0.2, 0, 1e-7}};
    const auto back = accessTableFromText(accessTableCsv(rows), "cutters.csv");
    ASSERT_EQ(back.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(back[i].diameter_mm, rows[i].diameter_mm);
        EXPECT_EQ(back[i].volume_cm3, rows[i].volume_cm3);
        EXPECT_EQ(back[i].mrr_cm3_per_min, rows[i].mrr_cm3_per_min);
    }
}

}  // namespace
}  // namespace stepmill
