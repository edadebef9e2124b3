// The section of report.html about the leaning walls of a setup: what form cutters take off, and their
// passes.

#include <fmt/format.h>

#include "report/page/drawing.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "report/plan/html_sections.h"

namespace stepmill::report {
namespace {

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

}  // namespace

Anchor workAnchor(const Operation& operation) {
    return operation.role == Role::Form ? Anchor("form", operation.setup_id)
                                        : bandAnchor(operation.feature_id);
}

Element formSection(const ReportSubject& subject, const PlannedSetup& setup) {
    std::vector<const Operation*> operations;
    double taken_mm3 = 0;
    for (const Operation& operation : setup.operations)
        if (operation.role == Role::Form) {
            operations.push_back(&operation);
            taken_mm3 += takenMm3(operation);
        }
    Element section("section", Element("h3", "Leaning walls of " + setup.setup.id),
                    Element("p", fmt::format("After all flat operations form cutters take {} off what "
                                             "flat layers leave over walls that lean, in fillets and at "
                                             "chamfers.",
                                             subject.in.crumb(taken_mm3))),
                    takesTable(operations, subject.in));
    section.mark(Anchor("form", setup.setup.id));
    Element figures("div.pairs");
    for (const Operation* operation : operations)
        figures.add(Element("figure", passesDrawing(*setup.form, *operation),
                            Element("figcaption", fmt::format("{}: {}, {} levels", operation->id,
                                                              operation->tool_id, operation->path.depths))));
    section.add(std::move(figures));
    return section;
}

}  // namespace stepmill::report
