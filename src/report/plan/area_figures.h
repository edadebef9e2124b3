#pragma once

#include <optional>

#include "report/page/element.h"
#include "report/page/measures.h"
#include "stepmill/plan/plan.h"

namespace stepmill::report {

/// A picture for all tools that reach the same of a feature, of those that take part or would but for their
/// holders: what the cutter covers, and of that what shank and holder keep from it [DSouza2006, Fig. 9 and
/// 10]. Nothing where there is no such tool.
/// \param most_bytes  as many pictures as have room in so many bytes of the page; what they take is taken off
std::optional<Element> areaFigures(const PlannedFeature& planned, const Measures& in,
                                   std::size_t& most_bytes);

/// Room for the pictures of areas of a whole report [bytes].
inline constexpr std::size_t kMostAreaBytes = 2'500'000;

}  // namespace stepmill::report
