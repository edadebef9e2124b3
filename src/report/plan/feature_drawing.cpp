#include "report/plan/feature_drawing.h"

#include <fmt/format.h>

#include "report/page/drawing.h"
#include "stepmill/feature/whole_feature.h"

namespace stepmill::report {

namespace {

/// How much of the surroundings a feature's picture shows, as a share of its longer side.
constexpr double kSurroundings = 0.12;
/// How much of the fixtures beside it the setup's picture shows, in the same way.
constexpr double kFixturesShown = 0.1;

Box2 frameOf(const Feature& feature) {
    const Box2 box = boundingBox(feature.target);
    return grown(box, kSurroundings * box.sizes().maxCoeff());
}

void drawGround(Drawing& drawing, const Feature& feature) {
    drawing.region(feature.obstruction, "obstruction");
    drawing.region(feature.target, "target");
}

void drawBoundary(Drawing& drawing, const PlannedFeature& planned) {
    std::vector<Path> open;
    std::vector<Path> closed;
    for (const BoundaryPiece& piece : planned.feature.boundary)
        (piece.open ? open : closed).push_back(piece.path);
    drawing.paths(closed, "wall");
    drawing.paths(open, "open-edge");
    for (const Residual& residual : planned.sequence.residual)
        drawing.region(residual.region, "residual");
}

}  // namespace

Element stepDrawing(const PlannedFeature& planned, std::size_t step, const Toolpath& path) {
    Box2 frame = frameOf(planned.feature);
    // Passes run out over open edges; the picture follows them.
    const Box2 swept = boundingBox(planned.sequence.steps[step].area.area);
    if (!swept.isEmpty()) {
        frame.extend(swept);
    }
    Drawing drawing(frame, fmt::format("{}, step {}, from above", planned.feature.id, step + 1));
    drawGround(drawing, planned.feature);
    drawing.region(planned.sequence.steps[step].area.area, "swept");
    drawBoundary(drawing, planned);
    drawing.paths(topView(path), "cut");
    return std::move(drawing).element();
}

Element unmachinedDrawing(const PlannedFeature& planned) {
    Drawing drawing(frameOf(planned.feature), planned.feature.id + " from above");
    drawGround(drawing, planned.feature);
    drawBoundary(drawing, planned);
    return std::move(drawing).element();
}

Element setupDrawing(const PlannedSetup& setup) {
    const Box3& stock = setup.setup.stock_bbox_mm;
    const Box2 top{stock.min().head<2>(), stock.max().head<2>()};
    Drawing drawing(setup.setup.fixtures.empty() ? top : grown(top, kFixturesShown * top.sizes().maxCoeff()),
                    setup.setup.id + " from above");
    drawing.region(makeRectangle(top.min(), top.max()), "obstruction");
    for (const Fixture& fixture : setup.setup.fixtures)
        drawing.region(fixture.section, "fixture");
    int feature = 0;
    for (const WholeFeature<PlannedFeature>& whole : wholeFeatures(setup.features)) {
        const std::string tint = "feature " + tintClass(feature++);
        for (const PlannedFeature* band : whole.bands)
            drawing.region(band->feature.target, tint);
    }
    for (const Prism& prism : setup.reserve)
        drawing.region(prism.region, "reserve");
    return std::move(drawing).element();
}

}  // namespace stepmill::report
