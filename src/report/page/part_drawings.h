#pragma once

#include <string>
#include <vector>

#include "report/page/element.h"
#include "report/page/faceted_part.h"

namespace stepmill::report {

/// A view of the part, as partViews() gives it (part_views.h), for a page.
struct PartDrawing {
    std::string title;
    Element drawing;
};

/// Top, front, right and isometric views.
/// \param tints  one a part face: what is visible of each is filled with tintClass(), of negative ones not
///               at all; empty: lines alone
/// \throws Error(GeometryKernel)
std::vector<PartDrawing> partDrawings(const FacetedPart& faceted, const Eigen::Isometry3d& part_to_setup,
                                      const std::vector<int>& tints = {});

/// Figures in pairs, titles below.
Element figuresOf(std::vector<PartDrawing> drawings);

}  // namespace stepmill::report
