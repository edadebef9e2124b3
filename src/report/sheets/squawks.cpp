// What the setter must know, graded.

#include <algorithm>

#include <fmt/format.h>

#include "report/page/program_lines.h"
#include "report/page/words.h"
#include "report/sheets/sheet_sections.h"
#include "stepmill/core/squawk_grade.h"
#include "stepmill/plan/warning_order.h"

namespace stepmill::report {
namespace {

SquawkGrade gradeOf(const Warning& warning) {
    switch (consequenceOf(warning)) {
        case Consequence::Danger:
            return SquawkGrade::Danger;
        case Consequence::MissingOnThePart:
        case Consequence::Cost:
            return SquawkGrade::Caution;
        case Consequence::Note:
            break;
    }
    return SquawkGrade::Note;
}

struct Squawk {
    SquawkGrade grade = SquawkGrade::Note;
    std::string text;
};

bool hasSheet(const SheetSubject& subject, const std::string& setup_id) {
    return std::any_of(subject.setups.begin(), subject.setups.end(),
                       [&](const PlannedSetup* setup) { return setup->setup.id == setup_id; });
}

std::string warningText(const Warning& warning) {
    return fmt::format("{}: {}", subjectWords(warning), warning.text);
}

std::vector<Squawk> ownSquawks(const SheetSubject& subject, const PlannedSetup& setup) {
    std::vector<Squawk> own;
    if (programOf(subject.proven, setup) == nullptr)
        own.push_back(
            {SquawkGrade::Danger, "No program is written for this setup: run none that lies about."});
    if (setup.setup.indexed)
        own.push_back(
            {SquawkGrade::Caution, "The tool axis is not along the part's box: sine vise or rotary axis."});
    return own;
}

Element row(const Squawk& squawk) {
    const std::string grade = wordOf(kSquawkGrades, squawk.grade);
    return Element("p", Element("b", grade), " " + squawk.text).with("class", "squawk " + grade);
}

}  // namespace

Element squawks(const SheetSubject& subject, const PlannedSetup& setup, bool first) {
    std::vector<Squawk> all = ownSquawks(subject, setup);
    for (const Warning& warning : subject.plan().warnings) {
        const std::string of = setupOf(warning);
        if (hasSheet(subject, of) ? of == setup.setup.id : first)
            all.push_back({gradeOf(warning), warningText(warning)});
    }
    for (const PlannedSetup& other : subject.plan().setups)
        if (first && !hasSheet(subject, other.setup.id))
            all.push_back(
                {SquawkGrade::Note,
                 other.setup.id + ": nothing can be cut from there; it has no program and no sheet."});
    if (all.empty()) all.push_back({SquawkGrade::Note, "nothing to heed in this setup."});
    std::stable_sort(all.begin(), all.end(),
                     [](const Squawk& a, const Squawk& b) { return a.grade < b.grade; });
    Element list("div.squawks");
    for (const Squawk& squawk : all)
        list.add(row(squawk));
    return titled("Squawks", std::move(list));
}

}  // namespace stepmill::report
