#include "report/plan/feature_drawing.h"

#include <fmt/format.h>

#include "report/page/svg.h"

namespace stepmill {

namespace {

/// How much of the surroundings a feature's picture shows, as a share of its longer side.
constexpr double kSurroundings = 0.12;
/// How much of the fixtures beside it the setup's picture shows, in the same way.
constexpr double kFixturesShown = 0.1;
constexpr int kTints = 8;

Box2 frameOf(const Feature& feature) {
    const Box2 box = boundingBox(feature.target);
    return grown(box, kSurroundings * box.sizes().maxCoeff());
}

void drawGround(SvgDrawing& svg, const Feature& feature) {
    svg.region(feature.obstruction, "obstruction");
    svg.region(feature.target, "target");
}

void drawBoundary(SvgDrawing& svg, const PlannedFeature& planned) {
    std::vector<Path> open;
    std::vector<Path> closed;
    for (const BoundaryPiece& piece : planned.feature.boundary)
        (piece.open ? open : closed).push_back(piece.path);
    svg.paths(closed, "wall");
    svg.paths(open, "open-edge");
    for (const Residual& residual : planned.sequence.residual)
        svg.region(residual.region, "residual");
}

}  // namespace

std::string stepDrawing(const PlannedFeature& planned, std::size_t step, const Toolpath& path) {
    Box2 frame = frameOf(planned.feature);
    // Passes run out over open edges; the picture follows them.
    const Box2 swept = boundingBox(planned.sequence.steps[step].area.area);
    if (!swept.isEmpty()) {
        frame.extend(swept);
    }
    SvgDrawing svg(frame);
    drawGround(svg, planned.feature);
    svg.region(planned.sequence.steps[step].area.area, "swept");
    drawBoundary(svg, planned);
    svg.paths(topView(path), "cut");
    return svg.text();
}

std::string unmachinedDrawing(const PlannedFeature& planned) {
    SvgDrawing svg(frameOf(planned.feature));
    drawGround(svg, planned.feature);
    drawBoundary(svg, planned);
    return svg.text();
}

std::string setupDrawing(const PlannedSetup& setup) {
    const Box3& stock = setup.setup.stock_bbox_mm;
    const Box2 top{stock.min().head<2>(), stock.max().head<2>()};
    SvgDrawing svg(setup.setup.fixtures.empty() ? top : grown(top, kFixturesShown * top.sizes().maxCoeff()));
    svg.region(makeRectangle(top.min(), top.max()), "obstruction");
    for (const Fixture& fixture : setup.setup.fixtures)
        svg.region(fixture.section, "fixture");
    int tint = 0;
    for (const PlannedFeature& planned : setup.features)
        svg.region(planned.feature.target, fmt::format("tint tint{}", tint++ % kTints));
    return svg.text();
}

}  // namespace stepmill
