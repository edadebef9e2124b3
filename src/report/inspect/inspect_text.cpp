#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/inspect/inspect_words.h"
#include "report/page/words.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/report/inspection.h"

namespace stepmill {

namespace {

std::string afterWords(const Feature& feature) {
    return feature.parents.empty() ? "" : fmt::format("after {}", fmt::join(feature.parents, ", "));
}

/// A feature of one band, or one band of several.
std::string bandRow(const InspectedFeature& inspected, const std::string& name, const std::string& after) {
    const Feature& feature = inspected.feature;
    std::string row = fmt::format(
        "  {:<8} {:<15} {:>8.2f} {:>8}", name, toString(feature.feature_class), feature.depth_mm(),
        inspected.measures ? fmt::format("{:.2f}", inspected.measures->width_mm) : "?");
    if (inspected.measures) {
        const FeatureMeasures& measures = *inspected.measures;
        row +=
            fmt::format(" {:>6.2f} {:>7} {:>14} {:>6}", measures.depth_to_width, cornerWords(measures),
                        wallWords(measures),
                        measures.floor_fillet_mm > 0 ? fmt::format("{:.2f}", measures.floor_fillet_mm) : "-");
    } else {
        row += fmt::format(" {:>6} {:>7} {:>14} {:>6}", "?", "?", "?", "?");
    }
    return row + fmt::format(" {:>10.3f}  {:<5} {}\n", feature.volume_mm3 / 1000,
                             fmt::format("{}", fmt::join(inspected.holes, ",")), after);
}

/// A row for the feature; where it has several bands one for each below, with what differs.
std::string featureRows(const WholeFeature<InspectedFeature>& feature) {
    const std::string after = afterWords(feature.uppermost());
    if (feature.bands.size() == 1) return bandRow(*feature.bands.front(), feature.id(), after);
    const std::string bands = fmt::format("{} bands", feature.bands.size());
    std::string rows =
        fmt::format("  {:<8} {:<15} {:>8.2f} {:>8} {:>6} {:>7} {:>14} {:>6} {:>10.3f}  {:<5} {}\n",
                    feature.id(), toString(feature.featureClass()), feature.depth_mm(), bands, "", "", "", "",
                    feature.volume_mm3() / 1000, "", after);
    for (const InspectedFeature* band : feature.bands)
        rows += bandRow(*band, fmt::format("  .{}", bandNumber(band->feature)), "");
    return rows;
}

/// "12 features", "12 features in 30 bands".
std::string featureCount(const InspectedSetup& setup) {
    const std::size_t whole = wholeFeatures(setup.features).size();
    const std::size_t all = setup.features.size();
    return fmt::format("{} features{}", whole, whole < all ? fmt::format(" in {} bands", all) : "");
}

std::string setupBlock(const InspectedSetup& setup) {
    double volume_mm3 = 0;
    for (const InspectedFeature& inspected : setup.features)
        volume_mm3 += inspected.feature.volume_mm3;
    const Vec3 size = setup.setup.stock_bbox_mm.sizes();
    std::string text =
        fmt::format("\n{}  tool axis {}{}, stock {:.2f} x {:.2f} x {:.2f} mm as it arrives, {}, {:.3f} cm3\n",
                    setup.setup.id, axisName(setup.setup.axis), setup.setup.indexed ? " (indexed)" : "",
                    size.x(), size.y(), size.z(), featureCount(setup), volume_mm3 / 1000);
    if (!setup.clamping.text.empty()) text += "    clamping: " + setup.clamping.text + "\n";
    if (setup.features.empty()) return text;
    text += fmt::format("  {:<8} {:<15} {:>8} {:>8} {:>6} {:>7} {:>14} {:>6} {:>10}  {:<5}\n", "feature",
                        "class", "depth", "width", "d/w", "corner", "wall x high", "floorR", "cm3", "hole");
    for (const WholeFeature<InspectedFeature>& feature : wholeFeatures(setup.features))
        text += featureRows(feature);
    return text;
}

std::string holesBlock(const Inspection& inspection) {
    if (inspection.holes.empty()) return {};
    std::string text = "\nHoles\n";
    for (const HoleGroup& group : groupHoles(inspection.holes)) {
        std::vector<std::string> ids;
        for (const Hole* hole : group.holes)
            ids.push_back(hole->id);
        text += fmt::format("  {:>3} x {:<28} {}  ({})", group.holes.size(), group.name, group.steps,
                            fmt::join(ids, ", "));
        if (!group.tap_core_of.empty())
            text += fmt::format("  tap core of {}", fmt::join(group.tap_core_of, ", "));
        text += "\n";
    }
    return text;
}

std::string booksBlock(const InspectedBooks& books) {
    std::string text = fmt::format("\nBooks: stock - part {:.4f} cm3 = features {:.4f}",
                                   books.stock_minus_part_mm3 / 1000, books.features_mm3 / 1000);
    for (const ReasonVolume& left : books.left)
        text += fmt::format(" + {} {:.4f}", toString(left.reason), left.volume_mm3 / 1000);
    return text + fmt::format(" (gap {})\n", report::gapWords(books.gapShare()));
}

}  // namespace

std::string inspectionText(const Inspection& inspection) {
    const Part& part = inspection.part;
    const Vec3 size = part.bbox_mm.sizes();
    std::string text = fmt::format(
        "{}  {:.2f} x {:.2f} x {:.2f} mm (file unit: {}), {} faces, {:.3f} cm3, {:.3f} cm3 to remove\n",
        part.name.empty() ? part.file : part.name, size.x(), size.y(), size.z(), part.unit_in_file,
        part.faces.size(), part.volume_mm3 / 1000, inspection.books.stock_minus_part_mm3 / 1000);
    for (const InspectedSetup& setup : inspection.setups)
        text += setupBlock(setup);
    text += holesBlock(inspection);
    if (const auto counts = countForms(inspection.forms); !counts.empty()) {
        text += "\nForms of the part, whatever the setup\n ";
        for (const FormCount& count : counts)
            text += fmt::format(" {} {}{}", count.count, count.name, &count == &counts.back() ? "\n" : ",");
    }
    text += booksBlock(inspection.books);
    if (const auto notes = notesOn(inspection); !notes.empty()) {
        text += "\nWhat makes it costly\n";
        for (const std::string& note : notes)
            text += "  " + note + "\n";
    }
    for (const std::string& warning : inspection.warnings)
        text += "warning: " + warning + "\n";
    return text;
}

}  // namespace stepmill
