// The section of report.html about the leaning walls of a setup: what form cutters take off, and their
// passes.

#include <fmt/format.h>

#include "report/page/drawing.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "report/plan/html_sections.h"

namespace stepmill::report {
namespace {

Anchor groundAnchor(const std::string& ground_id, const std::string& setup_id) {
    return {ground_id == edgeGroundId(setup_id) ? "edges" : "form", setup_id};
}

/// The operations on a ground.
std::vector<const Operation*> operationsOn(const FormGround& ground, const PlannedSetup& setup) {
    std::vector<const Operation*> found;
    for (const Operation& operation : setup.operations)
        if (operation.feature_id == ground.id) found.push_back(&operation);
    return found;
}

double takenMm3(const Operation& operation) {
    double sum = 0;
    for (const ReasonVolume& taken : operation.takes)
        sum += taken.volume_mm3;
    return sum;
}

Element takesTable(const std::vector<const Operation*>& operations, const Measures& in) {
    Table table({"operation", "tool", "what", numbers("takes")});
    for (const Operation* operation : operations)
        for (const ReasonVolume& taken : operation->takes)
            table.row(linkTo(operationAnchor(operation->id), operation->id), operation->tool_id,
                      toString(taken.reason), in.crumb(taken.volume_mm3));
    return std::move(table).element();
}

/// All feeds that go level, at all heights.
std::vector<Path> passesOf(const Toolpath& path) {
    std::vector<Path> passes;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        if (move.kind != MoveKind::Rapid && move.to.z() == from.z())
            passes.push_back({from.head<2>(), {{move.to.head<2>(), move.arc}}});
        from = move.to;
    }
    return passes;
}

Element passesDrawing(const FormGround& ground, const Operation& operation) {
    Drawing drawing(boundingBox(ground.window), operation.id + ", passes from above");
    drawing.region(ground.must_stand.front().section, "obstruction");
    for (const Obstacle& stair : ground.stairs)
        drawing.region(stair.section, "swept");
    drawing.paths(passesOf(operation.path), "cut");
    return std::move(drawing).element();
}

Element passesDrawings(const FormGround& ground, const std::vector<const Operation*>& operations) {
    Element figures("div.pairs");
    for (const Operation* operation : operations)
        figures.add(Element("figure", passesDrawing(ground, *operation),
                            Element("figcaption", fmt::format("{}: {}, {} levels", operation->id,
                                                              operation->tool_id, operation->path.depths))));
    return figures;
}

/// Edges that stay as they are.
Element sharpTable(const std::vector<SharpStretch>& sharp, const Measures& in) {
    Table table({"stays sharp at", numbers("length"), "because"});
    for (const SharpStretch& stretch : sharp)
        table.row(fmt::format("X{} Y{} Z{}", in.number(stretch.at.x()), in.number(stretch.at.y()),
                              in.number(stretch.at.z())),
                  in.length(stretch.length_mm), stretch.why);
    return std::move(table).element();
}

}  // namespace

Anchor workAnchor(const Operation& operation) {
    if (operation.role != Role::Form) return bandAnchor(operation.feature_id);
    return groundAnchor(operation.feature_id, operation.setup_id);
}

Element formSection(const ReportSubject& subject, const PlannedSetup& setup) {
    const std::vector<const Operation*> operations = operationsOn(*setup.form, setup);
    double taken_mm3 = 0;
    for (const Operation* operation : operations)
        taken_mm3 += takenMm3(*operation);
    Element section("section", Element("h3", "Leaning walls of " + setup.setup.id),
                    Element("p", fmt::format("After all flat operations form cutters take {} off what "
                                             "flat layers leave over walls that lean, in fillets and at "
                                             "chamfers.",
                                             subject.in.crumb(taken_mm3))),
                    takesTable(operations, subject.in));
    section.mark(groundAnchor(setup.form->id, setup.setup.id));
    section.add(passesDrawings(*setup.form, operations));
    return section;
}

Element edgeSection(const ReportSubject& subject, const PlannedSetup& setup) {
    const FormGround& ground = *setup.edges;
    const std::vector<const Operation*> operations = operationsOn(ground, setup);
    double broken_mm3 = 0;
    for (const Operation* operation : operations)
        broken_mm3 += operation->breaks_mm3;
    const std::string words =
        operations.empty()
            ? "No edge is broken."
            : fmt::format(
                  "After all else sharp edges that look up are broken by {}, 45 degrees: {} of the part.",
                  subject.in.length(ground.edges_mm), subject.in.crumb(broken_mm3));
    Element section("section", Element("h3", "Edges of " + setup.setup.id), Element("p", words));
    if (!ground.sharp.empty()) section.add(sharpTable(ground.sharp, subject.in));
    section.mark(groundAnchor(ground.id, setup.setup.id));
    section.add(passesDrawings(ground, operations));
    return section;
}

}  // namespace stepmill::report
