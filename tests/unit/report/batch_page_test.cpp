#include "stepmill/report/batch_page.h"
#include "stepmill/report/offers.h"

#include <chrono>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "report/page/element.h"
#include "support/page_check.h"

namespace stepmill {
namespace {

using test::PageContent;

const char* const kHostile = "=</script><script>alert(1)</script>\"', & \n\x1b \xff";

BatchRow planned(const std::string& name, const std::string& tool) {
    BatchRow row;
    row.part.name = name;
    row.outcome = Outcome::Gaps;
    row.folder = "a-1";
    row.reason = name;
    PartFigures figures;
    figures.solids = 1;
    figures.size_mm = Vec3(10, 20, 30);
    figures.material = "aluminium";
    figures.time_s = 90;
    figures.lower_bound_s = 60;
    figures.cost = 1.5;
    figures.tools = {{tool, 6, 2, 1, 30, 0.25}};
    figures.tasks = {{{{{tool, "EM2"}, 12.5}, {{"EM2"}, 30}}, 1}};
    figures.currency = "EUR";
    figures.offers = {{"EM7", 7, 45, 2, 60, 1.25, 500}};
    figures.reports = {"report.html"};
    figures.picture = "M1 2 3 4";
    row.figures = figures;
    return row;
}

BatchRow refused(const std::string& name) {
    BatchRow row;
    row.part.name = name;
    row.outcome = Outcome::Refused;
    row.reason = "is no STEP file";
    return row;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

TEST(BatchPage, IsXmlWithItsOneScriptAndItsData) {
    const PageContent content = test::readPage(batchHtml({planned("a.step", "EM6"), refused("b.step")}));
    EXPECT_EQ(content.errors, std::vector<std::string>());
    EXPECT_EQ(content.tags.at("script"), 2);
    EXPECT_EQ(content.attributes.count("src"), 0U);
    EXPECT_EQ(content.attributes.count("onclick"), 0U);
}

TEST(BatchPage, HostileNamesAreData) {
    const std::string page = batchHtml({planned(kHostile, "EM6")});
    const PageContent content = test::readPage(page);
    EXPECT_EQ(content.errors, std::vector<std::string>());
    EXPECT_EQ(content.tags.at("script"), 2);
    EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
}

TEST(BatchPage, DataIsReadBackAsItWas) {
    const nlohmann::json data{{"name", "<a & b>\u00e9"}};
    const std::string markup = report::dataElement(report::Anchor("data", "x"), data.dump()).markup();
    const std::size_t from = markup.find('>') + 1;
    EXPECT_EQ(nlohmann::json::parse(markup.substr(from, markup.rfind("</") - from)), data);
}

TEST(BatchPage, TenThousandPartsAreWrittenInASecondOrTwo) {
    std::vector<BatchRow> rows;
    for (int i = 0; i < 10000; ++i)
        rows.push_back(planned("part" + std::to_string(i) + ".step", "EM6"));
    const auto start = std::chrono::steady_clock::now();
    const std::string page = batchHtml(rows);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 10);
    EXPECT_LT(page.size(), 10000U * 1000U);
}

TEST(BatchCsv, HasALineAPartWithAsManyCellsAsTheHead) {
    const auto lines = linesOf(partsCsv({planned("a.step", "EM6"), refused("b.step")}));
    ASSERT_EQ(lines.size(), 3U);
    const auto commas = std::count(lines[0].begin(), lines[0].end(), ',');
    for (const std::string& line : lines)
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
    EXPECT_EQ(lines[2].substr(0, 9), "b.step,1,");
    EXPECT_NE(lines[1].find(",1.500,0.000,1.50,"), std::string::npos) << lines[1];
}

TEST(BatchCsv, HostileNamesAreOneCellAndNoFormula) {
    const auto lines = linesOf(partsCsv({planned(kHostile, "EM6")}));
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[1].substr(0, 4), "\"'=<");
}

TEST(BatchCsv, ToolsAreSummedOverParts) {
    BatchRow many = planned("b", "EM6");
    many.part.quantity = 10;
    const auto lines = linesOf(toolsCsv({planned("a", "EM6"), many, planned("c", "EM10"), refused("d")}));
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[1], "EM10,6.000,1,2,1,0.500,0.2500,1");
    EXPECT_EQ(lines[2], "EM6,6.000,2,4,2,1.000,0.5000,3");
}

TEST(BatchCsv, OrderNamesPlannedPartsAndThoseThatDoNotFit) {
    const std::vector<BatchRow> rows{refused("r"), planned("a", "EM6"), planned("b", "EM6"),
                                     planned("c", "EM4")};
    const PlannedTools tools = plannedTools(rows);
    ASSERT_EQ(tools.rows, (std::vector<std::size_t>{1, 2, 3}));
    EXPECT_EQ(orderCsv(rows, tools, orderParts(tools.tools, 1)),
              "position,part,tools\n1,a,EM6\n2,b,EM6\n3,c,EM4\n");
    PartOrder none;
    none.too_many = {2};
    EXPECT_EQ(orderCsv(rows, tools, none), "position,part,tools\n,c,EM4\n");
}

TEST(Offers, AreSummedOverPiecesAndTheBestStandsFirst) {
    BatchRow many = planned("a", "EM6");
    many.part.quantity = 10;
    BatchRow other = planned("b", "EM6");
    other.figures->offers = {{"EM5", 5, 30, 1, 5000, 9, 0}, {"EM7", 7, 45, 1, 30, 0.5, 0}};
    const std::vector<OfferSum> offers = offersOf({many, other, refused("c")});
    ASSERT_EQ(offers.size(), 2U);
    EXPECT_EQ(offersCsv(offers),
              "tool,diameter_mm,price,parts,features,saves_min,saves_cost,currency,reaches_more_cm3\n"
              "EM5,5.000,30.00,1,1,83.333,9.00,EUR,0.000000\n"
              "EM7,7.000,45.00,2,3,10.500,13.00,EUR,5.000000\n");
}

TEST(Offers, OfSeveralCurrenciesAreNotAddedUp) {
    BatchRow dollars = planned("b", "EM6");
    dollars.figures->currency = "USD";
    EXPECT_EQ(offersOf({planned("a", "EM6"), dollars}).size(), 2U);
}

TEST(PartFiguresJson, IsReadBackAsItWas) {
    PartFigures figures = *planned("a", "EM6").figures;
    addFigures(figures, *planned("b", "EM4").figures);
    const std::string json = figuresJson(figures);
    EXPECT_EQ(figuresJson(figuresFromJson(json)), json);
    EXPECT_EQ(figuresFromJson(json).tools.size(), 2U);
    EXPECT_EQ(figuresFromJson(json).time_s, 180);
    ASSERT_EQ(figuresFromJson(json).offers.size(), 1U);
    EXPECT_EQ(figuresFromJson(json).offers[0].saves_s, 120);
    ASSERT_EQ(figuresFromJson(json).tasks.size(), 2U);
    EXPECT_EQ(figuresFromJson(json).tasks[1].ways[0].tools, (std::vector<std::string>{"EM4", "EM2"}));
    EXPECT_THROW(figuresFromJson("{}"), std::exception);
    EXPECT_THROW(figuresFromJson("{"), std::exception);
}

}  // namespace
}  // namespace stepmill
