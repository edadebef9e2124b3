// Draws what one cutter reaches in a pocket, what it leaves to a smaller one, the rings of a contour-parallel
// path, a finishing pass, what a holder keeps from a cutter and a die's hunt planes: the pictures of
// docs/algorithms. Usage: draw_areas FOLDER

#include <filesystem>

#include <fmt/core.h>

#include "stepmill/access/lumps.h"
#include "stepmill/core/file.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/svg_path.h"
#include "stepmill/toolpath/finish_walls.h"

namespace stepmill {
namespace {

struct Layer {
    std::string data;  ///< SVG path data
    std::string fill;
    std::string stroke;
};

/// What the pictures tell apart.
constexpr double kUnitMm = 0.001;
constexpr double kLineMm = 0.35;

template <typename Shape>
std::string dataOf(const Shape& shape) {
    return toSvgPath(shape, kUnitMm);
}

std::string svg(const Box2& frame, const std::vector<Layer>& layers) {
    constexpr double kMarginMm = 3;
    const Box2 box = grown(frame, kMarginMm);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"560\" viewBox=\"{:.2f} {:.2f} {:.2f} {:.2f}\">"
        "<g transform=\"scale({},-{})\" stroke-width=\"{:g}\" fill-rule=\"nonzero\">\n",
        box.min().x(), -box.max().y(), box.sizes().x(), box.sizes().y(), kUnitMm, kUnitMm, kLineMm / kUnitMm);
    for (const Layer& layer : layers)
        text +=
            fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n", layer.data, layer.fill, layer.stroke);
    return text + "</g></svg>\n";
}

/// The butterfly of step_parts: lobes joined by necks, and an island.
Region butterfly(const Tolerances& tol) {
    const Region lobes =
        unite(makeRoundedRectangle({0, 0}, {34, 40}, 5), makeRoundedRectangle({42, 4}, {80, 36}, 5), tol);
    const Region joined = unite(lobes, makeRectangle({30, 14}, {46, 25}), tol);
    return subtract(joined, makeCircle({61, 20}, 6), tol);
}

/// What a finishing pass takes off the pocket's walls, and its way. The strip is drawn wider than a shop
/// would leave it, to be seen.
void drawFinishing(const std::filesystem::path& folder, const Region& pocket, const Tolerances& tol) {
    constexpr double kAllowanceMm = 0.8;
    ToolAssembly tool;
    tool.diameter_mm = 8;
    CuttingData cutting;
    cutting.feed_mm_per_min = cutting.plunge_feed_mm_per_min = 1000;
    Machine machine;
    machine.rapid_mm_per_min = 5000;
    const ClearanceDiagram diagram(pocket, tol);
    ClearingTask clearing;
    clearing.free_centres = diagram.offset(-tool.radius_mm());
    clearing.cleared_centres = diagram.offset(-tool.radius_mm() - kAllowanceMm);
    clearing.target = pocket;
    const Box2 block = grown(boundingBox(pocket), 2 * tool.diameter_mm);
    clearing.obstruction = subtract(makeRectangle(block.min(), block.max()), pocket, tol);
    clearing.floor_z_mm = -1;
    clearing.retract_z_mm = 1;
    const Region roughed = offset(clearing.cleared_centres, tool.radius_mm(), tol);
    const Region strip = subtract(diagram.opening(tool.radius_mm()), roughed, tol);
    const Toolpath path = toolpath::finishWalls({clearing, strip, kAllowanceMm}, tool, cutting, machine, tol);
    std::string ways;
    for (const Path& way : topView(path))
        ways += dataOf(way);
    writeFile(folder / "finishing.svg", svg(boundingBox(pocket), {{dataOf(pocket), "#fdf6df", "none"},
                                                                  {dataOf(strip), "#f4c97a", "none"},
                                                                  {ways, "none", "#0b4f75"},
                                                                  {dataOf(pocket), "none", "#1d2733"}}));
}

/// A pocket 20 mm deep with two round bosses that stand up to its top.
Feature bossedPocket(const Tolerances& tol) {
    const Region bosses = unite(makeCircle({25, 22}, 7), makeCircle({62, 30}, 7), tol);
    Feature feature;
    feature.floor_z_mm = -20;
    feature.target = subtract(makeRoundedRectangle({0, 0}, {90, 50}, 6), bosses, tol);
    const Box2 block = grown(boundingBox(feature.target), 40);
    feature.obstruction = subtract(makeRectangle(block.min(), block.max()), feature.target, tol);
    feature.obstacles = {{feature.floor_z_mm, 0, bosses}};
    feature.area_mm2 = area(feature.target);
    return feature;
}

/// What a holder keeps from a 10 mm cutter beside the bosses: the lumps of one edge of the tool DAG.
void drawLumps(const std::filesystem::path& folder, const Tolerances& tol) {
    ToolAssembly tool;
    tool.diameter_mm = 10;
    tool.stick_out_mm = 15;
    tool.holder = {{24, 15, 60}};
    CuttingData cutting;
    cutting.material = "aluminium";
    cutting.step_down_mm = 2;
    tool.cutting = {cutting};
    const FeatureGround ground(bossedPocket(tol), tol);
    const ToolReach reach = toolReach(ground, tool, cutting.material);
    const CutterArea own = collisionFreeArea(ground, tool, reach).value();
    std::string lumps;
    for (const Region& lump : lumpsOf(subtract(reach.cutter.coverable, own.coverable, tol), 10, tol))
        lumps += dataOf(lump);
    const Region& target = ground.feature().target;
    writeFile(folder / "lumps.svg",
              svg(boundingBox(target), {{dataOf(target), "#fdf6df", "none"},
                                        {dataOf(own.coverable), "#8ec9e3", "none"},
                                        {dataOf(own.free_centres), "#4d9cc0", "#0b4f75"},
                                        {lumps, "#f4c97a", "#8a5600"},
                                        {dataOf(target), "none", "#1d2733"}}));
}

/// The target of one of a die's hunt planes: the cavity gets narrower, its two islands wider.
Region huntPlane(int number, const Tolerances& tol) {
    constexpr double kLeanMm = 2.2;
    const double in = kLeanMm * number;
    const Region cavity = makeRoundedRectangle({in, in}, {90 - in, 56 - in}, 16 - in);
    const Region cone = makeCircle({28, 28}, 3 + in);
    return subtract(subtract(cavity, cone, tol), makeCircle({64, 30}, 7), tol);
}

/// A die's hunt planes from above, and the ground that a cutter shares among all of them.
void drawHuntPlanes(const std::filesystem::path& folder, const Tolerances& tol) {
    constexpr int kPlanes = 4;
    constexpr double kCutterMm = 4.5;
    const Region top = huntPlane(0, tol);
    std::vector<Layer> layers{{dataOf(top), "#fdf6df", "none"}};
    const Region lowest = huntPlane(kPlanes - 1, tol);
    layers.push_back({dataOf(ClearanceDiagram(lowest, tol).opening(kCutterMm)), "#8ec9e3", "#0b4f75"});
    for (int number = 1; number < kPlanes; ++number)
        layers.push_back({dataOf(huntPlane(number, tol)), "none", "#d08a1e"});
    layers.push_back({dataOf(top), "none", "#1d2733"});
    writeFile(folder / "hunt-planes.svg", svg(boundingBox(top), layers));
}

/// Bites of constant engagement in a pocket with an island, and the ways between them.
void drawAdaptive(const std::filesystem::path& folder, const Tolerances& tol) {
    constexpr double kDiameterMm = 12;
    Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 6);
    pocket.loops.push_back(reversed(makeCircle({35, 25}, 8).loops.front()));
    ToolAssembly tool;
    tool.diameter_mm = kDiameterMm;
    CuttingData cutting;
    cutting.feed_mm_per_min = cutting.plunge_feed_mm_per_min = 1000;
    cutting.step_over_mm = cutting.step_down_mm = kDiameterMm / 2;
    cutting.adaptive = AdaptiveData{0.17 * kDiameterMm, kDiameterMm, 0, 0, 0};
    Machine machine;
    machine.rapid_mm_per_min = 5000;
    const Box2 block = grown(boundingBox(pocket), 15);
    ClearingTask task;
    task.target = pocket;
    task.obstruction = subtract(makeRectangle(block.min(), block.max()), pocket, tol);
    task.free_centres = task.centres = offset(pocket, -tool.radius_mm(), tol);
    const auto widest = ClearanceDiagram(task.free_centres, tol).largestInscribedDisc().value();
    task.entries = {{EntryKind::Helix, widest.centre, 0.9 * tool.radius_mm(), Vec2::Zero()}};
    task.floor_z_mm = -kDiameterMm;
    task.retract_z_mm = 5;
    task.pattern = Pattern::Adaptive;
    const Toolpath path = clearArea(task, tool, cutting, machine, tol);
    std::string passes;
    std::string ways;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const Path part{from.head<2>(), {{Vec2(move.to.head<2>()), move.arc}}};
        if (move.kind == MoveKind::Feed) (isGlide(move) ? ways : passes) += dataOf(part);
        from = move.to;
    }
    writeFile(folder / "adaptive.svg", svg(boundingBox(pocket), {{dataOf(pocket), "#fdf6df", "none"},
                                                                 {ways, "none", "#9fb9a5"},
                                                                 {passes, "none", "#0b4f75"},
                                                                 {dataOf(pocket), "none", "#1d2733"}}));
}

void draw(const std::filesystem::path& folder) {
    const Tolerances tol;
    const Region pocket = butterfly(tol);
    const Box2 frame = boundingBox(pocket);
    const ClearanceDiagram diagram(pocket, tol);
    constexpr double kLargeMm = 7;
    constexpr double kSmallMm = 3;
    const Region large_centres = diagram.offset(-kLargeMm);
    const Region small_centres = diagram.offset(-kSmallMm);
    const Layer walls{dataOf(pocket), "none", "#1d2733"};

    writeFile(folder / "accessible-area.svg",
              svg(frame, {{dataOf(pocket), "#fdf6df", "none"},
                          {dataOf(diagram.opening(kLargeMm)), "#8ec9e3", "none"},
                          {dataOf(large_centres), "#4d9cc0", "#0b4f75"},
                          walls}));

    const Region rest_centres = subtract(small_centres, offset(large_centres, kLargeMm - kSmallMm, tol), tol);
    writeFile(folder / "decomposed-area.svg",
              svg(frame, {{dataOf(pocket), "#fdf6df", "none"},
                          {dataOf(offset(rest_centres, kSmallMm, tol)), "#f4c97a", "none"},
                          {dataOf(rest_centres), "#d08a1e", "#8a5600"},
                          walls}));

    std::string rings;
    for (const Region& ring : diagram.rings(kSmallMm, kSmallMm))
        rings += dataOf(ring);
    writeFile(folder / "rings.svg",
              svg(frame, {{dataOf(pocket), "#fdf6df", "none"}, {rings, "none", "#0b4f75"}, walls}));
    drawFinishing(folder, pocket, tol);
    drawLumps(folder, tol);
    drawHuntPlanes(folder, tol);
    drawAdaptive(folder, tol);
}

}  // namespace
}  // namespace stepmill

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: draw_areas FOLDER\n");
        return 2;
    }
    std::filesystem::create_directories(argv[1]);
    stepmill::draw(argv[1]);
    return 0;
}
