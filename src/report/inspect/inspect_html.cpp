// inspect.html: setups with shaded views, features, holes, books and what makes the part costly.

#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/inspect/inspect_words.h"
#include "report/page/document.h"
#include "report/page/drawing.h"
#include "report/page/part_drawings.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/report/inspection.h"

namespace stepmill::report {

namespace {

/// The number of each feature's tint; see tintClass().
using Tints = std::map<std::string, int>;

/// Features of the whole part take the tints in turn; the bands of one share theirs.
Tints tintsOf(const Inspection& inspection) {
    Tints tints;
    int next = 0;
    for (const InspectedSetup& setup : inspection.setups)
        for (const WholeFeature<InspectedFeature>& feature : wholeFeatures(setup.features)) {
            for (const InspectedFeature* band : feature.bands)
                tints[band->feature.id] = next;
            ++next;
        }
    return tints;
}

/// The tint and id of a band, or of a feature by one of its bands.
Element featureKey(const std::string& id, const Feature& band, const Tints& tints) {
    return Element("span.name", Element("i").with("class", tintClass(tints.at(band.id))), id);
}

/// The row of a feature with several bands; what differs from band to band stands in theirs.
void addWhole(Table& table, const WholeFeature<InspectedFeature>& whole, const Tints& tints) {
    table
        .row(featureKey(whole.id(), whole.uppermost(), tints), toString(whole.featureClass()), "",
             listed(whole.uppermost().parents), fixed(whole.depth_mm(), 3), "", "", "", "",
             fixed(whole.volume_mm3() / 1000, 3), fmt::format("{} bands", whole.bands.size()))
        .mark(Anchor("feature", whole.id()));
}

void addBand(Table& table, const InspectedFeature& inspected, const Tints& tints) {
    const Feature& feature = inspected.feature;
    const auto measured = [&](auto words) {
        return inspected.measures ? words(*inspected.measures) : std::string("?");
    };
    table
        .row(featureKey(feature.id, feature, tints), toString(feature.feature_class), listed(inspected.holes),
             listed(feature.parents), fixed(feature.depth_mm(), 3),
             measured([](const FeatureMeasures& m) { return fixed(m.width_mm, 2); }),
             measured([](const FeatureMeasures& m) { return fixed(m.depth_to_width, 2); }),
             measured(cornerWords), measured(wallWords), fixed(feature.volume_mm3 / 1000, 3),
             fmt::format("{}", fmt::join(costDrivers(inspected), "; ")))
        .mark(Anchor("feature", feature.id));
}

std::optional<Element> featuresTable(const InspectedSetup& setup, const Tints& tints) {
    Table table({"feature", "class", "hole", "after", numbers("depth mm"), numbers("width mm"),
                 numbers("depth/width"), numbers("corner R"), numbers("wall × height"), numbers("volume cm³"),
                 "what makes it costly"});
    for (const WholeFeature<InspectedFeature>& whole : wholeFeatures(setup.features)) {
        if (whole.bands.size() > 1) addWhole(table, whole, tints);
        for (const InspectedFeature* band : whole.bands)
            addBand(table, *band, tints);
    }
    return std::move(table).elementIfAny();
}

/// One a part face: the tint of the feature that makes it in this setup; negative where none does.
std::vector<int> faceTints(const Inspection& inspection, const InspectedSetup& setup, const Tints& tints) {
    std::vector<int> by_face(inspection.part.faces.size(), -1);
    for (const InspectedFeature& inspected : setup.features)
        for (const FaceRow& row : inspection.faces)
            if (row.feature == inspected.feature.id) by_face[row.index] = tints.at(row.feature);
    return by_face;
}

Element setupSection(const Inspection& inspection, const FacetedPart& part, const InspectedSetup& setup,
                     const Tints& tints) {
    const std::string words = fmt::format("Tool axis {} of the part{}. Stock {} as it arrives. {}",
                                          axisName(setup.setup.axis), setup.setup.indexed ? " (indexed)" : "",
                                          sizeWords(setup.setup.stock_bbox_mm.sizes()), setup.clamping.text);
    return Element(
        "section", Element("h2", "Setup " + setup.setup.id), Element("p", words),
        figuresOf(partDrawings(part, setup.setup.part_to_setup, faceTints(inspection, setup, tints))),
        featuresTable(setup, tints));
}

std::optional<Element> holesSection(const Inspection& inspection) {
    if (inspection.holes.empty()) return std::nullopt;
    Table table({numbers("count"), "class", "steps, mm from the entry", "tap core of", "which"});
    for (const HoleGroup& group : groupHoles(inspection.holes)) {
        std::vector<std::string> ids;
        for (const Hole* hole : group.holes)
            ids.push_back(hole->id);
        table.row(std::to_string(group.holes.size()), group.name, group.steps,
                  group.tap_core_of.empty() ? "-" : listed(group.tap_core_of), listed(ids));
    }
    return Element("section", Element("h2", "Holes"), std::move(table).element());
}

Element booksSection(const InspectedBooks& books) {
    Table table({"entry", numbers("cm³")});
    const auto add = [&table](const std::string& name, double volume_mm3) {
        table.row(name, fixed(volume_mm3 / 1000, 4));
    };
    add("stock minus part", books.stock_minus_part_mm3);
    add("features", books.features_mm3);
    for (const ReasonVolume& left : books.left)
        add("stays: " + toString(left.reason), left.volume_mm3);
    return Element("section", Element("h2", "Volume books"), std::move(table).element(),
                   Element("p.soft", fmt::format("Not accounted for: {} of stock minus part.",
                                                 gapWords(books.gapShare()))));
}

std::optional<Element> notesSection(const Inspection& inspection) {
    const std::vector<std::string> notes = notesOn(inspection);
    if (notes.empty()) return std::nullopt;
    Element list("ul");
    for (const std::string& note : notes)
        list.add(Element("li", note));
    return Element("section", Element("h2", "What makes it costly"), std::move(list));
}

Element partWords(const Part& part) {
    return Element("p.soft", fmt::format("{} · {} (file unit: {}) · {} faces · {:.3f} cm³", part.file,
                                         sizeWords(part.bbox_mm.sizes()), part.unit_in_file,
                                         part.faces.size(), part.volume_mm3 / 1000));
}

}  // namespace
}  // namespace stepmill::report

std::string stepmill::inspectionHtml(const Inspection& inspection) {
    using namespace report;
    Element main("main", Element("h1", inspection.part.name), partWords(inspection.part));
    for (const std::string& warning : inspection.warnings)
        main.add(Element("div.warn", warning));
    main.add(notesSection(inspection));
    const Tints tints = tintsOf(inspection);
    const FacetedPart part(inspection.part);
    for (const InspectedSetup& setup : inspection.setups)
        main.add(setupSection(inspection, part, setup, tints));
    main.add(holesSection(inspection), booksSection(inspection.books));
    return htmlDocument(inspection.part.name, std::move(main));
}
