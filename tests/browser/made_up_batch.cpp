// Writes the page of a batch of made-up parts, as many as wanted: made_up_batch PARTS FILE

#include <iostream>
#include <random>
#include <string>

#include <fmt/format.h>

#include "stepmill/core/file.h"
#include "stepmill/report/batch_page.h"

namespace stepmill {
namespace {

/// As long as those of MFCAD parts are.
std::string madeUpPicture(std::mt19937& random) {
    constexpr int kLines = 60;
    std::string lines;
    for (int i = 0; i < kLines; ++i)
        lines += fmt::format("M{} {} {} {}", random() % 96, random() % 72, random() % 96, random() % 72);
    return lines;
}

PartFigures madeUpFigures(std::mt19937& random) {
    PartFigures figures;
    figures.solids = 1;
    figures.size_mm = Vec3(0.1 * (random() % 2000), 0.1 * (random() % 2000), 0.1 * (random() % 900));
    figures.material = random() % 3 == 0 ? "steel" : "aluminium";
    figures.setups = static_cast<int>(1 + random() % 6);
    figures.features = static_cast<int>(random() % 60);
    figures.time_s = 0.1 * (random() % 90000);
    figures.cost = 0.01 * (random() % 40000);
    figures.lower_bound_s = 0.05 * (1 + random() % 90000);
    figures.stays_mm3 = random() % 2 == 0 ? 0 : 0.1 * (random() % 90000);
    figures.reports = {"report.html"};
    figures.picture = madeUpPicture(random);
    return figures;
}

/// Every seventh part is refused; every fourth has a date.
BatchRow madeUpRow(int number, std::mt19937& random) {
    BatchRow row;
    row.part.name = fmt::format("folder {}/bracket-{}-{:x}.step", number % 40, number, random());
    row.part.quantity = static_cast<int>(1 + random() % 20);
    if (number % 4 == 0) row.part.due = fmt::format("2026-{:02}-{:02}", 1 + random() % 12, 1 + random() % 28);
    row.folder = fmt::format("bracket-{}", number);
    row.outcome = number % 7 == 0 ? Outcome::Refused : number % 3 == 0 ? Outcome::Gaps : Outcome::Complete;
    if (row.outcome == Outcome::Refused) {
        row.reason = fmt::format("bracket-{}: holds no solid", number);
        return row;
    }
    row.figures = madeUpFigures(random);
    if (row.outcome == Outcome::Gaps) row.reason = fmt::format("{} cm3 stay: undercut", random() % 900);
    return row;
}

void writeMadeUpBatch(int parts, const std::string& file) {
    std::mt19937 random(17);
    std::vector<BatchRow> rows;
    for (int number = 0; number < parts; ++number)
        rows.push_back(madeUpRow(number, random));
    writeFile(file, batchHtml(rows));
}

}  // namespace
}  // namespace stepmill

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "made_up_batch PARTS FILE\n";
        return 2;
    }
    stepmill::writeMadeUpBatch(std::stoi(argv[1]), argv[2]);
    return 0;
}
