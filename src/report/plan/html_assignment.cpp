// Which setup cuts what, and what was considered and turned down.

#include <fmt/format.h>

#include "report/page/table.h"
#include "report/page/words.h"
#include "report/plan/html_sections.h"

namespace stepmill::report {
namespace {

double leftForLaterMm3(const PlannedSetup& setup) {
    double sum_mm3 = 0;
    for (const Unplanned& entry : setup.unplanned)
        if (entry.reason == Reason::LeftForLater) sum_mm3 += entry.volume_mm3;
    return sum_mm3;
}

Element setupsTable(const ReportSubject& subject) {
    const Measures& in = subject.in;
    Table table({"setup", "tool axis", numbersIn(in.volumeUnit(), "cuts"), numbers("in"),
                 numbersIn(in.volumeUnit(), "leaves for later setups")});
    for (const PlannedSetup& setup : subject.plan.setups)
        table.row(linkTo(setupAnchor(setup.setup.id), setup.setup.id), axisName(setup.setup.axis),
                  in.volume(setup.balance.planned_mm3, 2), clockTime(setup.time_s),
                  in.volume(leftForLaterMm3(setup), 2));
    return std::move(table).element();
}

/// Of a reserve or a set of setups.
template <typename AnyVerdict>
std::string outcomeWords(AnyVerdict verdict) {
    const std::string words = toString(verdict);
    return verdict == AnyVerdict::Taken ? words : "turned down: " + words;
}

/// A plan with and without it, and each piece of work that it is about.
Element triedSection(const ReportSubject& subject, const TriedReserve& tried) {
    const Measures& in = subject.in;
    const bool taken = tried.verdict == Verdict::Taken;
    Table table({"work of", "or of the setup along", numbersIn(in.volumeUnit(), "volume"),
                 numbers("takes here"), numbers("takes there"), "is"});
    for (const WeighedWork& work : tried.proposal.work)
        table.row(work.feature, work.setup, in.volume(work.volume_mm3, 2), clockTime(work.early_s),
                  clockTime(work.late_s), work.left ? (taken ? "left" : "would be left") : "cut");
    return Element(
        "details.band",
        Element("summary",
                fmt::format("{} leaves work for later setups: {} instead of {} with them, {}", tried.setup,
                            clockTime(tried.with_s), clockTime(tried.before_s), outcomeWords(tried.verdict))),
        std::move(table).element(),
        Element("p.soft",
                "Times of pieces are estimates, by their share of a feature's volume and "
                "without tool changes. Both plans were made, but in flat layers and at the library's feeds: "
                "feeds by what is cut, leaning walls and edges come after the choice."));
}

/// Which sets of setups were weighed; each with what it leaves and takes.
Element choicesTable(const ReportSubject& subject) {
    const Measures& in = subject.in;
    Table table({"setups", numbers("takes a piece"), numbers("setting up, a piece"),
                 numbersIn(in.volumeUnit(), "leaves"), "is"});
    for (const SetupChoice& choice : subject.plan.assignment.choices) {
        const std::string axes = axesWords(choice);
        const std::string is = outcomeWords(choice.verdict);
        if (choice.planned)
            table.row(axes, clockTime(choice.planned->time_s), clockTime(choice.planned->setup_s),
                      in.volume(choice.planned->stays_mm3, 2), is);
        else
            table.row(axes, "", "", "", is);
    }
    return std::move(table).element();
}

}  // namespace

std::optional<Element> assignmentSection(const ReportSubject& subject) {
    const Plan& plan = subject.plan;
    const bool chosen = !plan.assignment.choices.empty();
    if (plan.setups.size() < 2 && !chosen) return std::nullopt;
    Element section("section", Element("h2", "Which setup cuts what"), setupsTable(subject));
    if (chosen) section.add(Element("h3", "Sets of setups that were weighed")).add(choicesTable(subject));
    for (const TriedReserve& tried : plan.assignment.tried)
        section.add(triedSection(subject, tried));
    return std::move(section).at(Anchor("part", "assignment"));
}

}  // namespace stepmill::report
