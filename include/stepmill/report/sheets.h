#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "stepmill/catalog/job_details.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/proven/proven_plan.h"

namespace stepmill {

/// What a shop wants of its setup sheets.
struct SheetOptions {
    JobDetails job;
    bool inch = false;  ///< lengths and feeds in inches
};

/// The setup sheets of a plan as one page [docs/setup-sheets.md]: for the setter, a sheet or two for each
/// setup, to be printed. No script, no outside file, no date but the job's: same input, same bytes.
/// \throws Error(GeometryKernel) where a stock from a file cannot be drawn
std::string sheetsHtml(const ProvenPlan& proven, const SheetOptions& options, const Tolerances& tol);

/// The files of a plan's setup sheets.
struct Sheets {
    std::string html;
    std::string pdf;         ///< empty: none was asked for, or none could be made
    std::string why_no_pdf;  ///< where one was asked for
};

/// Prints a page without scripts as Chromium does, where it is installed. The PDF's dates are taken out: the
/// same page gives the same bytes as long as program and fonts stay the same. Never throws for want of a
/// printer: `why_no_pdf` says what is missing.
Sheets printed(std::string html);

/// sheets.html, and where asked for the same as a PDF on A4, or on Letter for a shop with inches.
Sheets makeSheets(const ProvenPlan& proven, const SheetOptions& options, bool with_pdf,
                  const Tolerances& tol);

}  // namespace stepmill
