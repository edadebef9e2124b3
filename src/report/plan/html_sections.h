#pragma once

#include "report/page/element.h"
#include "report/page/faceted_part.h"
#include "report/page/measures.h"
#include "report/plan/area_figures.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/plan/plan.h"
#include "stepmill/post/post.h"

// The sections of report.html that belong to one setup or to one feature, and where links lead to.

namespace stepmill::report {

/// What the sections of one report are made of.
struct ReportSubject {
    const Plan& plan;
    const FacetedPart& part;
    Measures in;
    Dialect dialect = Dialect::LinuxCnc;
    std::size_t area_room = kMostAreaBytes;  ///< what is left of the page for pictures of areas
};

/// The section of a setup, of a band, of a feature (of its band where it has but one), and the row of an
/// operation.
Anchor setupAnchor(const std::string& setup_id);
Anchor bandAnchor(const std::string& band_id);
Anchor featureAnchor(const WholeFeature<PlannedFeature>& feature);
Anchor operationAnchor(const std::string& operation_id);

/// The section of what an operation works on: its feature, or its setup's leaning walls.
Anchor workAnchor(const Operation& operation);

/// What each setup cuts and what it leaves for later ones, and what of that was weighed; nothing of one
/// setup.
std::optional<Element> assignmentSection(const ReportSubject& subject);

/// What form cutters take off leaning walls, and their passes.
/// \pre setup.form
Element formSection(const ReportSubject& subject, const PlannedSetup& setup);

/// Which edges are broken, and which stay sharp.
/// \pre setup.edges
Element edgeSection(const ReportSubject& subject, const PlannedSetup& setup);

/// Views, the setup sheet with its features, tools and operations, then each feature.
Element setupSection(ReportSubject& subject, const PlannedSetup& setup);

/// What each step sweeps, what stays, and all that was weighed; of several bands each folded.
Element featureSection(ReportSubject& subject, const PlannedSetup& setup,
                       const WholeFeature<PlannedFeature>& feature);

}  // namespace stepmill::report
