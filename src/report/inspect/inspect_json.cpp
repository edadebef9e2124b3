#include "report/inspect/inspect_words.h"
#include "stepmill/catalog/json_schema.h"
#include "stepmill/catalog/json_values.h"
#include "stepmill/core/enum_words.h"
#include "stepmill/core/error.h"
#include "stepmill/report/inspection.h"

namespace stepmill {

namespace {

constexpr EnumWord<HoleStep::Kind> kStepKinds[] = {
    {HoleStep::Kind::Bore, "bore"}, {HoleStep::Kind::Cone, "cone"}, {HoleStep::Kind::Point, "point"}};

using json::Json;
using json::listOf;
using json::number;
using json::point;
using json::textOrNull;

Json wallJson(const std::optional<WallThickness>& wall) {
    if (!wall) return nullptr;
    return {{"thickness_mm", number(wall->thickness_mm)},
            {"height_mm", number(wall->height_mm)},
            {"at", point(wall->at)},
            {"thin", wall->thin}};
}

Json measuresJson(const std::optional<FeatureMeasures>& measures) {
    if (!measures) return nullptr;
    return {{"width_mm", number(measures->width_mm)},
            {"depth_to_width", number(measures->depth_to_width)},
            {"necks", listOf(measures->necks,
                             [](const Neck& neck) {
                                 return Json{{"width_mm", number(neck.width_mm)}, {"at", point(neck.at)}};
                             })},
            {"corner_radii_mm", listOf(measures->corner_radii_mm, number)},
            {"sharp_corner", measures->sharp_corner},
            {"draft_deg", number(measures->draft_deg)},
            {"floor_fillet_mm", number(measures->floor_fillet_mm)},
            {"wall", wallJson(measures->wall)}};
}

Json featureJson(const InspectedFeature& inspected) {
    const Feature& feature = inspected.feature;
    return {{"id", feature.id},
            {"class", toString(feature.feature_class)},
            {"parents", feature.parents},
            {"holes", inspected.holes},
            {"top_z_mm", number(feature.top_z_mm)},
            {"floor_z_mm", number(feature.floor_z_mm)},
            {"depth_mm", number(feature.depth_mm())},
            {"through", feature.through},
            {"area_mm2", number(feature.area_mm2)},
            {"volume_mm3", number(feature.volume_mm3)},
            {"open_length_mm", number(feature.open_length_mm)},
            {"closed_length_mm", number(feature.closed_length_mm)},
            {"faces", feature.faces},
            {"measures", measuresJson(inspected.measures)},
            {"cost_drivers", costDrivers(inspected)}};
}

Json unplannedJson(const Unplanned& unplanned) {
    return {{"reason", toString(unplanned.reason)},
            {"volume_mm3", number(unplanned.volume_mm3)},
            {"top_z_mm", number(unplanned.top_z_mm)},
            {"bottom_z_mm", number(unplanned.bottom_z_mm)}};
}

Json setupJson(const InspectedSetup& inspected) {
    const Setup& setup = inspected.setup;
    return {{"id", setup.id},
            {"axis", point(setup.axis)},
            {"axis_name", axisName(setup.axis)},
            {"indexed", setup.indexed},
            {"stock_mm", point(Vec3(setup.stock_bbox_mm.sizes()))},
            {"clamping", textOrNull(inspected.clamping.text)},
            {"features", listOf(inspected.features, featureJson)},
            {"unplanned", listOf(inspected.unplanned, unplannedJson)},
            {"arrives_mm3", number(inspected.stock.arrives_mm3)},
            {"leaves_mm3", number(inspected.stock.leaves_mm3)},
            {"gap_mm3", number(inspected.gap_mm3)}};
}

bool isStepOf(const InspectedFeature& inspected, const Hole& hole) {
    return std::find(inspected.holes.begin(), inspected.holes.end(), hole.id) != inspected.holes.end();
}

Json holeJson(const Hole& hole, const Inspection& inspection) {
    Json features = Json::array();
    for (const InspectedSetup& setup : inspection.setups)
        for (const InspectedFeature& inspected : setup.features)
            if (isStepOf(inspected, hole)) features.push_back(inspected.feature.id);
    return {{"id", hole.id},
            {"class", holeName(hole)},
            {"diameter_mm", number(hole.diameter_mm())},
            {"depth_mm", number(hole.depth_mm())},
            {"through", hole.through},
            {"drill_point", hole.drill_point},
            {"tap_core_of", tapCoreOf(hole)},
            {"entry", point(hole.entry)},
            {"axis", point(hole.axis)},
            {"steps", listOf(hole.steps,
                             [](const HoleStep& step) {
                                 return Json{{"kind", wordOf(kStepKinds, step.kind)},
                                             {"diameter_mm", number(step.diameter_mm)},
                                             {"end_diameter_mm", number(step.end_diameter_mm)},
                                             {"top_mm", number(step.top_mm)},
                                             {"bottom_mm", number(step.bottom_mm)}};
                             })},
            {"features", std::move(features)},
            {"faces", hole.faces}};
}

Json formJson(const PartForm& form) {
    return {{"id", form.id},
            {"class", toString(form.form_class)},
            {"sides", form.sides},
            {"floor", form.floor ? Json(*form.floor) : Json(nullptr)},
            {"faces", form.faces}};
}

Json faceJson(const FaceRow& row) {
    return {{"index", row.index},
            {"step_name", row.step_name},
            {"feature", textOrNull(row.feature)},
            {"class", row.face_class},
            {"form", textOrNull(row.form)},
            {"mfcad_class", row.mfcad_class ? Json(*row.mfcad_class) : Json(nullptr)}};
}

Json booksJson(const InspectedBooks& books) {
    return {
        {"stock_minus_part_mm3", number(books.stock_minus_part_mm3)},
        {"features_mm3", number(books.features_mm3)},
        {"left",
         listOf(books.left,
                [](const ReasonVolume& left) {
                    return Json{{"reason", toString(left.reason)}, {"volume_mm3", number(left.volume_mm3)}};
                })},
        {"gap_share", books.gapShare()}};
}

}  // namespace

std::string inspectionJson(const Inspection& inspection) {
    const Part& part = inspection.part;
    Json content{
        {"part",
         {{"file", part.file},
          {"sha256", part.sha256},
          {"name", part.name},
          {"unit_in_file", part.unit_in_file},
          {"size_mm", point(Vec3(part.bbox_mm.sizes()))},
          {"volume_mm3", number(part.volume_mm3)},
          {"surfaces", part.surfaces}}},
        {"stock",
         {{"kind", inspection.stock.kind == Stock::Kind::Box ? "box" : "step"},
          {"volume_mm3", number(inspection.stock.volume_mm3)}}},
        {"setups", listOf(inspection.setups, setupJson)},
        {"holes", listOf(inspection.holes, [&](const Hole& hole) { return holeJson(hole, inspection); })},
        {"forms", listOf(inspection.forms, formJson)},
        {"faces", listOf(inspection.faces, faceJson)},
        {"books", booksJson(inspection.books)},
        {"warnings", inspection.warnings}};
    return finishJson(SchemaName::Inspect, std::move(content));
}

}  // namespace stepmill
