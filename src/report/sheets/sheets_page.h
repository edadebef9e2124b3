#pragma once

#include "report/page/element.h"
#include "stepmill/report/sheets.h"

namespace stepmill::report {

enum class Paper { AsPrinter, A4, Letter };

/// The sheets of all setups; their pictures take most of the time.
/// \throws Error(GeometryKernel)
Element sheetsOf(const ProvenPlan& proven, const SheetOptions& options, const Tolerances& tol);

/// The page that holds them, for one paper.
/// \param name  of the part
std::string sheetsPage(const std::string& name, Element sheets, Paper paper);

}  // namespace stepmill::report
