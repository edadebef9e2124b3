#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/page/element.h"
#include "report/page/measures.h"
#include "stepmill/report/sheets.h"

// The parts of a setup sheet. Each takes the sheets' subject and gives an element of the page.

namespace stepmill::report {

/// All that the sheets of one plan are made of.
struct SheetSubject {
    const ProvenPlan& proven;
    const JobDetails& job;
    Measures measures;
    const Tolerances& tol;
    /// In order: those that cut something, each with a sheet of its own; all where none does.
    std::vector<const PlannedSetup*> setups;

    const Plan& plan() const { return proven.plan; }
};

/// A heading with what belongs to it; not parted from its first lines on paper.
Element titled(const char* title, Element content);

/// Part, revision, customer and so on; what is not told is a line to write on.
Element jobBlock(const SheetSubject& subject);
/// The whole job: a row for each setup.
Element runTable(const SheetSubject& subject);

/// Datum, flip, blank, clamping in words.
/// \param before  null for the first
Element setupWords(const SheetSubject& subject, const PlannedSetup& setup, const Setup* before);

/// Tools in the order of their first use, with a picture to scale.
std::vector<Element> toolSections(const SheetSubject& subject, const PlannedSetup& setup);
Element operationTable(const SheetSubject& subject, const PlannedSetup& setup);

/// Equal holes that are made the same way.
struct HoleGroup {
    std::string name;  ///< "A"
    double diameter_mm = 0;
    double top_mm = 0;
    double floor_mm = 0;
    bool through = false;
    double made_to_mm = 0;  ///< the floor, or where this setup's operations end over it
    std::string way;        ///< "drilled T5 DR6, milled T3 EM4"
    int last = -1;          ///< place of the last operation on any of them; -1: none is made
    double time_s = 0;      ///< of all their operations, without tool changes
    std::vector<Vec2> centres;

    bool isMadeInPart() const;
    /// "10.00", "13.50 of 32.00 through".
    std::string depthWords(const Measures& in) const;
};
std::vector<HoleGroup> holeGroups(const SheetSubject& subject, const PlannedSetup& setup);
std::optional<Element> holeTable(const SheetSubject& subject, const std::vector<HoleGroup>& groups);

/// What the operator measures, and when.
/// \param last  is it the plan's last setup?
Element checkTable(const SheetSubject& subject, const PlannedSetup& setup,
                   const std::vector<HoleGroup>& holes, bool last);

/// Warnings graded danger, caution, note: those of the setup, and with the first setup those of the plan.
Element squawks(const SheetSubject& subject, const PlannedSetup& setup, bool first);

}  // namespace stepmill::report
