#include "report/inspect/inspect_words.h"

#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stepmill/catalog/thread.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

namespace {

/// Deeper than this many widths ordinary end mills do not reach.
constexpr double kDeep = 4;
/// Below this corner radius the last cutter is a slow one [mm].
constexpr double kSmallCornerMm = 1;
/// A hole deeper than this many diameters is pecked, ...
constexpr double kDeepHole = 5;
/// ... and than this many asks for a special drill.
constexpr double kVeryDeepHole = 10;
/// What stays is worth a note from this share of stock - part on.
constexpr double kWorthANote = 1e-3;

std::string stepWords(const Hole& hole) {
    std::string words;
    for (const HoleStep& step : hole.steps) {
        if (!words.empty()) words += ", ";
        switch (step.kind) {
            case HoleStep::Kind::Bore:
                words += fmt::format("Ø{:.3f} to {:.2f}", step.diameter_mm, step.bottom_mm);
                break;
            case HoleStep::Kind::Cone:
                words += fmt::format("cone Ø{:.3f} to {:.2f}", step.diameter_mm, step.bottom_mm);
                break;
            case HoleStep::Kind::Point:
                words += fmt::format("point to {:.2f}", step.bottom_mm);
                break;
        }
    }
    return words;
}

/// Cost drivers with the features they hold for, in the order of the first of these.
std::vector<std::pair<std::string, std::vector<std::string>>> driversOf(const Inspection& inspection) {
    std::vector<std::pair<std::string, std::vector<std::string>>> drivers;
    for (const InspectedSetup& setup : inspection.setups)
        for (const InspectedFeature& inspected : setup.features)
            for (const std::string& words : costDrivers(inspected)) {
                const auto known = std::find_if(drivers.begin(), drivers.end(),
                                                [&](const auto& driver) { return driver.first == words; });
                if (known == drivers.end())
                    drivers.push_back({words, {inspected.feature.id}});
                else
                    known->second.push_back(inspected.feature.id);
            }
    return drivers;
}

}  // namespace

std::string cornerWords(const FeatureMeasures& measures) {
    if (measures.sharp_corner) return "sharp";
    if (measures.corner_radii_mm.empty()) return "-";
    return fmt::format("{:.2f}", measures.corner_radii_mm.front());
}

std::string wallWords(const FeatureMeasures& measures) {
    if (!measures.wall) return "-";
    return fmt::format("{:.2f} x {:.1f}{}", measures.wall->thickness_mm, measures.wall->height_mm,
                       measures.wall->thin ? " !" : "");
}

std::vector<std::string> tapCoreOf(const Hole& hole) {
    std::vector<std::string> names;
    for (const ThreadSize* size : threadsForCore(hole.diameter_mm()))
        names.push_back(size->thread.name);
    return names;
}

std::vector<HoleGroup> groupHoles(const std::vector<Hole>& holes) {
    std::map<std::pair<double, std::string>, HoleGroup> groups;
    for (const Hole& hole : holes) {
        const std::string steps = stepWords(hole);
        // Diameters as printed, so that rounding of the file does not split a group.
        const double diameter = std::round(1000 * hole.diameter_mm()) / 1000;
        HoleGroup& group = groups[{diameter, holeName(hole) + steps}];
        group.name = holeName(hole);
        group.steps = steps;
        group.tap_core_of = tapCoreOf(hole);
        group.holes.push_back(&hole);
    }
    std::vector<HoleGroup> all;
    for (auto& [key, group] : groups)
        all.push_back(std::move(group));
    return all;
}

std::vector<FormCount> countForms(const std::vector<PartForm>& forms) {
    std::map<FormClass, int> counts;
    for (const PartForm& form : forms)
        ++counts[form.form_class];
    std::vector<FormCount> words;
    for (const auto& [form_class, count] : counts)
        words.push_back({toString(form_class), count});
    return words;
}

std::vector<std::string> costDrivers(const InspectedFeature& inspected) {
    std::vector<std::string> words;
    const Feature& feature = inspected.feature;
    if (feature.feature_class == FeatureClass::Engraving)
        words.push_back("narrower than the smallest cutter: engraving");
    if (!inspected.measures) return words;
    const FeatureMeasures& measures = *inspected.measures;
    if (isHole(feature.feature_class)) {
        if (measures.depth_to_width > kVeryDeepHole)
            words.push_back(fmt::format("{:.1f} diameters deep: special drill", measures.depth_to_width));
        else if (measures.depth_to_width > kDeepHole)
            words.push_back(fmt::format("{:.1f} diameters deep: pecks", measures.depth_to_width));
        return words;
    }
    const bool walled = feature.closed_length_mm > 0;
    if (walled && measures.depth_to_width > kDeep)
        words.push_back(
            fmt::format("{:.1f} times as deep as wide: long slender cutter", measures.depth_to_width));
    if (measures.sharp_corner)
        words.push_back("sharp inner corners: a cutter leaves its radius in them");
    else if (!measures.corner_radii_mm.empty() && measures.corner_radii_mm.front() < kSmallCornerMm)
        words.push_back(fmt::format("inner corners of radius {:.3g} mm: small last cutter",
                                    measures.corner_radii_mm.front()));
    if (measures.wall && measures.wall->thin)
        words.push_back(fmt::format("thin wall: {:.3g} mm thick, {:.3g} mm high", measures.wall->thickness_mm,
                                    measures.wall->height_mm));
    if (measures.draft_deg > 0)
        words.push_back(
            fmt::format("walls lean up to {:.3g} degrees: a flat cutter leaves steps", measures.draft_deg));
    if (measures.floor_fillet_mm > 0)
        words.push_back(fmt::format("floor fillet of radius {:.3g} mm: bull-nose or ball cutter",
                                    measures.floor_fillet_mm));
    return words;
}

std::vector<std::string> notesOn(const Inspection& inspection) {
    std::vector<std::string> notes;
    if (inspection.setups.size() > 1) notes.push_back(fmt::format("{} clampings", inspection.setups.size()));
    for (const InspectedSetup& setup : inspection.setups) {
        if (setup.setup.indexed)
            notes.push_back(setup.setup.id +
                            ": tool axis off the part's box, needs a sine vice or a rotary axis");
    }
    for (const auto& [words, ids] : driversOf(inspection))
        notes.push_back(fmt::format("{}: {}", fmt::join(ids, ", "), words));
    const InspectedBooks& books = inspection.books;
    for (const ReasonVolume& left : books.left)
        if (left.volume_mm3 > std::max(kVolumeRoundingMm3, kWorthANote * books.stock_minus_part_mm3))
            notes.push_back(
                fmt::format("{:.4g} mm3 stay after all setups: {}", left.volume_mm3, toString(left.reason)));
    return notes;
}

}  // namespace stepmill
