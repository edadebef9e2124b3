// Setup sheets as a browser shows and prints them: nothing outside its box, no page too many, nothing on the
// console.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "support/page_check.h"
#include "support/planned_parts.h"
#include "support/text_file.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

const std::string kSource = STEPMILL_SOURCE_DIR;

bool hasBrowser() {
    std::istringstream folders(std::getenv("PATH") == nullptr ? "" : std::getenv("PATH"));
    for (std::string folder; std::getline(folders, folder, ':');)
        if (fs::exists(fs::path(folder) / "chromium")) return true;
    return false;
}

/// Every CI sets CI: there the browser must be installed. Elsewhere its tests are skipped without it.
#define STEPMILL_NEEDS_BROWSER()                                                        \
    if (!hasBrowser()) {                                                                \
        if (std::getenv("CI") != nullptr) FAIL() << "chromium must be installed in CI"; \
        GTEST_SKIP() << "Chromium is not installed (package chromium)";                 \
    }

/// Writes what stands outside its box, and tables wider than theirs, at the end of the page.
const char* const kMeasure = R"(
const bad = [];
const width = document.documentElement.clientWidth;
const slack = 1.5;
if (document.documentElement.scrollWidth > width + slack)
  bad.push('page of ' + width + ' is ' + document.documentElement.scrollWidth + ' wide');
for (const table of document.querySelectorAll('table')) {
  const room = table.parentElement.clientWidth;
  if (table.getBoundingClientRect().width > room + slack)
    bad.push('table of ' + table.getBoundingClientRect().width + ' in ' + room + ': ' + table.innerText.slice(0, 40));
}
const walk = document.createTreeWalker(document.querySelector('main'), NodeFilter.SHOW_TEXT);
for (let node = walk.nextNode(); node; node = walk.nextNode()) {
  if (!node.textContent.trim()) continue;
  const box = node.parentElement.closest('td,th,p,.field,.head,figcaption,h1,h2,svg');
  if (!box) continue;
  const room = box.getBoundingClientRect();
  const range = document.createRange();
  range.selectNodeContents(node);
  for (const rect of range.getClientRects())
    if (rect.left < room.left - slack || rect.right > room.right + slack || rect.top < room.top - 3 * slack ||
        rect.bottom > room.bottom + 3 * slack) {
      bad.push('outside its ' + box.tagName + ': ' + node.textContent.trim().slice(0, 60));
      break;
    }
}
document.body.innerHTML = '';
const told = document.createElement('pre');
told.textContent = 'MEASURED\n' + bad.join('\n') + '\nEND';
document.body.append(told);
)";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

ProgramRun browse(const fs::path& page, int width_px, const std::vector<std::string>& more) {
    const TemporaryFolder profile;
    std::vector<std::string> command{"/usr/bin/env",
                                     "chromium",
                                     "--headless",
                                     "--no-sandbox",
                                     "--disable-gpu",
                                     "--hide-scrollbars",
                                     "--user-data-dir=" + profile.path(),
                                     "--window-size=" + std::to_string(width_px) + ",2000"};
    command.insert(command.end(), more.begin(), more.end());
    command.push_back("file://" + page.string());
    return runProgram(command);
}

/// What a browser finds wrong with the page's layout at that width; "" is good.
/// \param on_paper  with the style of paper, not of the screen
std::string faultsAt(const std::string& page, int width_px, bool on_paper) {
    std::string measured =
        std::regex_replace(page, std::regex("<meta http-equiv=\"Content-Security-Policy\"[^>]*>"), "");
    if (on_paper)
        measured =
            replaced(replaced(measured, "@media screen", "@media speech"), "@media print", "@media all");
    measured = replaced(measured, "</body>", "<script>" + std::string(kMeasure) + "</script></body>");
    const TemporaryFolder folder;
    const fs::path file = fs::path(folder.path()) / "page.html";
    std::ofstream(file, std::ios::binary) << measured;
    const ProgramRun run = browse(file, width_px, {"--dump-dom"});
    const std::size_t from = run.out.find("MEASURED\n");
    const std::size_t to = run.out.find("\nEND", from);
    if (from == std::string::npos || to == std::string::npos) return "not measured: " + run.err;
    return to <= from + 9 ? "" : run.out.substr(from + 9, to - from - 9);
}

/// Pages of a PDF as Chromium writes them.
int pagesOf(const std::string& pdf) {
    const std::regex page("/Type /Page[^s]");
    return static_cast<int>(std::distance(std::sregex_iterator(pdf.begin(), pdf.end(), page), {}));
}

struct SheetCase {
    const char* part;
    int most_pages = 0;
};

void PrintTo(const SheetCase& sheet, std::ostream* out) {
    *out << sheet.part;
}

class SheetsInABrowser : public testing::TestWithParam<SheetCase> {
  protected:
    void SetUp() override {
        STEPMILL_NEEDS_BROWSER();
        part_ = kSource + "/" + GetParam().part;
        if (!fs::exists(part_)) GTEST_SKIP() << part_ << " is not here";
        options_ = {"--pdf", "--job", kSource + "/samples/job.json"};
        planned_ = plannedPart(part_, options_);
        ASSERT_LE(planned_.run.exit_code, 1) << planned_.run.err;
        page_ = slurp(planned_.folder / "sheets.html");
    }

    std::string part_;
    std::vector<std::string> options_;
    PlannedPart planned_;
    std::string page_;
};

TEST_P(SheetsInABrowser, KeepAllInItsBoxOnScreenAndPaper) {
    EXPECT_EQ(faultsAt(page_, 1300, false), "");
    EXPECT_EQ(faultsAt(page_, 800, false), "");
    // Between the margins of @page: 188 mm of A4, 194 mm of Letter.
    EXPECT_EQ(faultsAt(page_, 710, true), "");
    EXPECT_EQ(faultsAt(page_, 733, true), "");
}

TEST_P(SheetsInABrowser, PrintOnAsFewPagesAsTheyShould) {
    const int a4 = pagesOf(slurp(planned_.folder / "sheets.pdf"));
    EXPECT_GE(a4, 1);
    EXPECT_LE(a4, GetParam().most_pages);
    std::vector<std::string> letter = options_;
    letter.insert(letter.end(), {"--display", "inch"});
    const PlannedPart in_inches = plannedPart(part_, letter);
    const int pages = pagesOf(slurp(in_inches.folder / "sheets.pdf"));
    EXPECT_GE(pages, 1);
    EXPECT_LE(pages, GetParam().most_pages);
    EXPECT_EQ(faultsAt(slurp(in_inches.folder / "sheets.html"), 733, true), "");
}

TEST_P(SheetsInABrowser, SayNothingOnTheConsole) {
    const ProgramRun run =
        browse(planned_.folder / "sheets.html", 1300, {"--enable-logging=stderr", "--dump-dom"});
    EXPECT_NE(run.out.find("class=\"sheet\""), std::string::npos);
    EXPECT_EQ(run.err.find("CONSOLE"), std::string::npos) << run.err;
}

std::string caseName(const testing::TestParamInfo<SheetCase>& row) {
    return fs::path(row.param.part).stem().string();
}

INSTANTIATE_TEST_SUITE_P(Parts, SheetsInABrowser,
                         testing::Values(SheetCase{"step_parts/rounded_pocket.step", 2},
                                         SheetCase{"step_parts/plate_with_holes.step", 2},
                                         SheetCase{"step_parts/four_setups.step", 5},
                                         SheetCase{"../shared/parts/machined/hole_model.stp", 5}),
                         caseName);

const char* const kLongPath = "../shared/parts/nist/nist_ctc_01_asme1_rd.stp";

INSTANTIATE_TEST_SUITE_P(Slow, SheetsInABrowser, testing::Values(SheetCase{kLongPath, 10}), caseName);

/// Parts whose tool paths are hours long.
class LongReport : public testing::TestWithParam<const char*> {};

TEST_P(LongReport, StaysBelowFifteenMegabytes) {
    const std::string part = kSource + "/" + GetParam();
    if (!fs::exists(part)) GTEST_SKIP() << part << " is not here";
    const PlannedPart planned = plannedPart(part, {});
    EXPECT_LE(fs::file_size(planned.folder / "report.html"), 15'000'000u);
}

INSTANTIATE_TEST_SUITE_P(Slow, LongReport, testing::Values(kLongPath));

/// Rows of the table of fields: what, and here.
std::vector<std::pair<std::string, std::string>> fieldsOf(const std::string& doc) {
    std::vector<std::pair<std::string, std::string>> fields;
    std::istringstream lines(doc.substr(doc.find("| field | known from | here |")));
    const std::regex row(R"(\| (.*) \| (.*) \| (.*) \|)");
    std::smatch found;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_match(line, found, row) && found[1] != "field")
            fields.emplace_back(found[1], found[3]);
    return fields;
}

TEST(SheetFields, AreThereOrLeftOutWithAReason) {
    const PlannedPart planned =
        plannedPart(kSource + "/step_parts/plate_with_holes.step", {"--job", kSource + "/samples/job.json"});
    const std::string page = slurp(planned.folder / "sheets.html");
    const std::string text = readPage(page).text;
    const auto fields = fieldsOf(slurp(fs::path(kSource) / "docs" / "setup-sheets.md"));
    ASSERT_GT(fields.size(), 60u);
    for (const auto& [field, here] : fields) {
        if (here.starts_with("left out: ")) {
            EXPECT_GT(here.size(), std::string("left out: ").size()) << field;
            continue;
        }
        ASSERT_TRUE(here.size() > 2 && here.front() == '"' && here.back() == '"') << field << ": " << here;
        // A short word would be found anywhere: it must be all that an element says.
        const std::string words = here.substr(1, here.size() - 2);
        const bool there = words.size() < 5 ? page.find(">" + words + "<") != std::string::npos
                                            : text.find(words) != std::string::npos;
        EXPECT_TRUE(there) << field << ": " << here;
    }
}

}  // namespace
}  // namespace stepmill::test
