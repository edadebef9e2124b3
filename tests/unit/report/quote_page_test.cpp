#include "stepmill/report/quote.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/page_check.h"
#include "support/told.h"

namespace stepmill {
namespace {

const char* const kHostile = "=<script>alert(1)</script>\", & \x1b \xff";

Quote sample() {
    Quote quote;
    quote.part_file = "bracket.step";
    quote.material = "steel";
    quote.currency = "EUR";
    quote.hourly_rate = 80;
    quote.setups = 2;
    quote.complete = true;
    quote.acceleration = true;
    quote.machining_s = {100, 120};
    quote.lots = {{10, {60, 65}, {120, 130}, {12, 13}}};
    quote.pays_off_at = 7;
    CostlyFeature costly;
    costly.id = "S1.F2";
    costly.changes = {{CheaperChange::Kind::LargerCorners, 2, 4, 12.3, 0.31, {"EM10", "EM8"}}};
    costly.break_evens = {{Parameter::ToolChange, 5, std::nullopt, 9.0}};
    quote.costly = {costly};
    return quote;
}

TEST(QuoteReport, AllFormsTellTheLotAndTheChange) {
    EXPECT_TRUE(
        test::tells(quoteText(sample()), {"10", "60.0 to 65.0", "120.00 to 130.00", "12.00 to 13.00"}));
    EXPECT_TRUE(test::tells(quoteText(sample()), {"4.00 mm instead of 2.00 mm", "12.3 s", "EM10 > EM8"}));
    EXPECT_TRUE(test::tells(quoteText(sample()), {"tool change 5 s", "above 9.00 s"}));
    const nlohmann::json json = nlohmann::json::parse(quoteJson(sample()));
    EXPECT_EQ(json.at("lots")[0].at("price").at("high"), 130);
    EXPECT_EQ(json.at("costly")[0].at("cheaper")[0].at("to_mm"), 4);
    EXPECT_EQ(quoteCsvLines(sample()),
              "bracket.step,steel,10,2,yes,60.000,65.000,120.00,130.00,12.00,13.00,EUR\n");
    test::expectSoundPage(quoteHtml(sample()), "quote.html");
}

TEST(QuoteReport, GapsAndAnUnknownAccelerationAreTold) {
    Quote quote = sample();
    quote.complete = false;
    quote.acceleration = false;
    EXPECT_TRUE(test::tells(quoteText(quote), {"not in it", "gaps"}));
    EXPECT_TRUE(test::tells(quoteText(quote), {"acceleration is not known"}));
}

TEST(QuoteReport, HostileNamesAreText) {
    Quote quote = sample();
    quote.part_file = quote.material = quote.currency = quote.costly.front().id = kHostile;
    test::expectSoundPage(quoteHtml(quote), "quote.html");
    EXPECT_EQ(quoteCsvLines(quote).substr(0, 4), "\"'=<");
    EXPECT_NO_THROW(quoteJson(quote));
}

}  // namespace
}  // namespace stepmill
