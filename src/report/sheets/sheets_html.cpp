// sheets.html: a sheet or two for each setup.

#include <optional>
#include <vector>

#include <fmt/format.h>

#include "report/page/document.h"
#include "report/page/page_style.h"
#include "report/page/program_lines.h"
#include "report/page/words.h"
#include "report/sheets/setup_pictures.h"
#include "report/sheets/sheet_sections.h"
#include "report/sheets/sheets_page.h"
#include "stepmill/core/parallel.h"

namespace stepmill::report {

Element titled(const char* title, Element content) {
    return Element("section", Element("h2", title), std::move(content));
}

namespace {

Element sheetHead(const SheetSubject& subject, const PlannedSetup& setup) {
    const Plan& plan = subject.plan();
    const PostedProgram* program = programOf(subject.proven, setup);
    const std::string name = subject.job.part.empty() ? plan.part.name : subject.job.part;
    return Element("div.head",
                   Element("h1", fmt::format("Setup {} of {}", setup.setup.id, plan.setups.size())),
                   Element("b.part-name", name),
                   Element("b.program", program == nullptr ? "no program" : program->file));
}

/// What tells a later sheet's job, should it come loose from the first.
Element jobLine(const SheetSubject& subject) {
    const Plan& plan = subject.plan();
    std::vector<std::string> words{plan.part.file, "sha256 " + plan.part.sha256.substr(0, 12), plan.material,
                                   plan.machine.name};
    for (const std::string* more : {&subject.job.document, &subject.job.revision, &subject.job.order})
        if (!more->empty()) words.push_back(*more);
    return Element("p.soft", listed(words));
}

Element picturesOf(const SheetSubject& subject, const PlannedSetup& setup, const Setup* before) {
    SetupPictures pictures =
        setupPictures(setup, before, subject.plan().request.fixtures.plate_mm, subject.tol);
    return Element("div.pictures",
                   Element("figure", std::move(pictures.arriving),
                           Element("figcaption", "As it arrives; shaded: is cut here")),
                   Element("figure", std::move(pictures.leaving),
                           Element("figcaption", "When all is cut; shaded: was cut here")));
}

Element setupSheet(const SheetSubject& subject, std::size_t index) {
    const PlannedSetup& setup = *subject.setups[index];
    const Setup* before = index > 0 ? &subject.setups[index - 1]->setup : nullptr;
    const std::vector<HoleGroup> holes = holeGroups(subject, setup);
    Element sheet("section.sheet", sheetHead(subject, setup));
    sheet.mark(Anchor("sheet", setup.setup.id));
    if (index == 0)
        sheet.add(jobBlock(subject));
    else
        sheet.add(jobLine(subject));
    sheet.add(squawks(subject, setup, index == 0), picturesOf(subject, setup, before),
              setupWords(subject, setup, before), toolSections(subject, setup),
              operationTable(subject, setup), holeTable(subject, holes),
              checkTable(subject, setup, holes, index + 1 == subject.setups.size()));
    if (index == 0) sheet.add(runTable(subject));
    return sheet;
}

std::vector<const PlannedSetup*> setupsOnSheets(const Plan& plan) {
    std::vector<const PlannedSetup*> all, cutting;
    for (const PlannedSetup& setup : plan.setups) {
        all.push_back(&setup);
        if (!setup.operations.empty()) cutting.push_back(&setup);
    }
    return cutting.empty() ? all : cutting;
}

std::string paperStyle(Paper paper) {
    switch (paper) {
        case Paper::A4:
            return "@page { size:A4; }\n";
        case Paper::Letter:
            return "@page { size:letter; }\n";
        case Paper::AsPrinter:
            break;
    }
    return {};
}

}  // namespace

Element sheetsOf(const ProvenPlan& proven, const SheetOptions& options, const Tolerances& tol) {
    const SheetSubject subject{proven, options.job, Measures(options.inch), tol, setupsOnSheets(proven.plan)};
    std::vector<std::optional<Element>> sheets(subject.setups.size());
    parallelFor(sheets.size(), [&](std::size_t i) { sheets[i] = setupSheet(subject, i); });
    Element main("main.sheets");
    for (std::optional<Element>& sheet : sheets)
        main.add(std::move(sheet));
    return main;
}

std::string sheetsPage(const std::string& name, Element sheets, Paper paper) {
    return printedDocument(name + ": setup sheets", std::move(sheets),
                           std::string(kPageStyle) + std::string(kSheetStyle) + paperStyle(paper));
}

}  // namespace stepmill::report

std::string stepmill::sheetsHtml(const ProvenPlan& proven, const SheetOptions& options,
                                 const Tolerances& tol) {
    return report::sheetsPage(proven.plan.part.name, report::sheetsOf(proven, options, tol),
                              report::Paper::AsPrinter);
}
