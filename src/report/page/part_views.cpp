// Views of the part by hidden-line removal.

#include "stepmill/report/part_views.h"

#include <gp_Ax2.hxx>
#include <HLRAlgo_Projector.hxx>

#include "report/page/drawing.h"
#include "report/page/hidden_lines.h"
#include "report/page/part_drawings.h"
#include "report/page/shading.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {

namespace report {
namespace {

/// Chord error of drawn curves as a share of the part's size.
constexpr double kDrawingDeflection = 5e-4;

struct Eye {
    const char* title;
    gp_Dir towards_viewer;
    gp_Dir right;
};

/// The eye's plane in part coordinates, x to the right; its origin is the setup's.
gp_Ax2 planeOf(const Eye& eye, const Eigen::Isometry3d& part_to_setup) {
    const gp_Ax2 in_setup(gp_Pnt(0, 0, 0), eye.towards_viewer, eye.right);
    return in_setup.Transformed(toTrsf(part_to_setup.inverse()));
}

Element drawn(const Lines& lines, const Shading& shading, std::string label) {
    Box2 box;
    for (const std::vector<Polyline>* group : {&lines.visible, &lines.hidden})
        for (const Polyline& line : *group)
            for (const Vec2& p : line)
                box.extend(p);
    Drawing drawing(box, std::move(label));
    for (const auto& [tint, patches] : shading)
        drawing.polylines(patches, "shade " + tintClass(tint));
    drawing.strokes(lines.hidden, "hidden");
    drawing.strokes(lines.visible, "visible");
    return std::move(drawing).element();
}

const std::vector<Eye>& eyes() {
    static const std::vector<Eye> all{{"Top", gp_Dir(0, 0, 1), gp_Dir(1, 0, 0)},
                                      {"Front", gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)},
                                      {"Right", gp_Dir(1, 0, 0), gp_Dir(0, 1, 0)},
                                      {"Isometric", gp_Dir(1, -1, 1), gp_Dir(1, 1, 0)}};
    return all;
}

std::vector<PartDrawing> drawAll(const FacetedPart& faceted, const Eigen::Isometry3d& part_to_setup,
                                 const std::vector<int>& tints) {
    const Part& part = faceted.part();
    const double deflection_mm = kDrawingDeflection * part.bbox_mm.diagonal().norm();
    std::vector<PartDrawing> drawings;
    for (const Eye& eye : eyes()) {
        const gp_Ax2 plane = planeOf(eye, part_to_setup);
        const HLRAlgo_Projector projector(plane);
        const Lines lines = hiddenLines(faceted.solid(), projector, deflection_mm);
        const Shading shading = tints.empty() ? Shading{} : shade(faceted.solid(), plane, tints);
        drawings.push_back({eye.title, drawn(lines, shading, std::string(eye.title) + " view")});
    }
    return drawings;
}

}  // namespace

std::vector<PartDrawing> partDrawings(const FacetedPart& faceted, const Eigen::Isometry3d& part_to_setup,
                                      const std::vector<int>& tints) {
    STEPMILL_CHECK(tints.empty() || tints.size() == faceted.part().faces.size(), "one tint a face");
    std::vector<PartDrawing> drawings;
    guardOcct(ErrorCode::GeometryKernel, "views of " + faceted.part().name,
              [&] { drawings = drawAll(faceted, part_to_setup, tints); });
    return drawings;
}

Element figuresOf(std::vector<PartDrawing> drawings) {
    Element pairs("div.pairs.views");
    for (PartDrawing& view : drawings)
        pairs.add(Element("figure", std::move(view.drawing), Element("figcaption", view.title)));
    return pairs;
}

}  // namespace report

namespace {

std::vector<View> asText(const std::vector<report::PartDrawing>& drawings) {
    std::vector<View> views;
    for (const report::PartDrawing& view : drawings)
        views.push_back({view.title, view.drawing.markup()});
    return views;
}

}  // namespace

std::vector<View> partViews(const Part& part, const Eigen::Isometry3d& part_to_setup) {
    return asText(report::partDrawings(report::FacetedPart(part), part_to_setup));
}

}  // namespace stepmill
