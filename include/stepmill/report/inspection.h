#pragma once

#include <string>
#include <vector>

#include "stepmill/study/inspection.h"

namespace stepmill {

/// For people: setups, features with their dimensions, holes, edges, books and what makes the part costly.
std::string inspectionText(const Inspection& inspection);

/// inspect.json, checked against schemas/inspect.schema.json before it leaves.
/// \throws Error(Internal) if it breaks the schema
std::string inspectionJson(const Inspection& inspection);

/// The same with hidden-line views, faces tinted by feature: one self-contained page.
std::string inspectionHtml(const Inspection& inspection);

/// What of a feature asks for slow or special work, in words; empty when nothing does.
std::vector<std::string> costDrivers(const InspectedFeature& inspected);

}  // namespace stepmill
