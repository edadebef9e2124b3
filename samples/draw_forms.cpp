// Draws the section through a pocket with drafted walls while a ball finishes one of them: the picture of
// docs/algorithms/form-cutters.md. Usage: draw_forms FOLDER

#include <filesystem>

#include <fmt/core.h>

#include "stepmill/access/form_centres.h"
#include "stepmill/core/file.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/toolpath/form_passes.h"

namespace stepmill {
namespace {

constexpr double kHalfFloorMm = 8;
constexpr double kDepthMm = 9;
constexpr double kLayerMm = 3;
constexpr double kBandMm = 0.3;
constexpr double kLevelMm = 1.5;
/// Of the wall: it leans by that much in x over z.
constexpr double kSlope = 0.7;
const Tolerances kTol;

/// The pocket's section at a height, z = 0 on top.
Region pocketAt(double z_mm) {
    const double half = kHalfFloorMm + kSlope * (kDepthMm + z_mm);
    return makeRoundedRectangle({-half, -40}, {half, 40}, 3);
}

Region blockLess(const Region& region) {
    return subtract(makeRectangle({-40, -60}, {40, 60}), region, kTol);
}

FormGround pocketGround() {
    FormGround ground;
    ground.window = makeRectangle({-60, -80}, {60, 80});
    ground.must_stand.push_back({-kDepthMm - 2, -kDepthMm, blockLess({})});
    for (int i = 0; i * kBandMm < kDepthMm - kBandMm / 2; ++i) {
        const double z = -kDepthMm + i * kBandMm;
        ground.must_stand.push_back({z, z + kBandMm, blockLess(pocketAt(z))});
    }
    for (double z = -kDepthMm; z < -kLayerMm / 2; z += kLayerMm)
        ground.stairs.push_back({z, z + kLayerMm, subtract(pocketAt(z + kLayerMm), pocketAt(z), kTol)});
    ground.obstacles = {{-kDepthMm - 2, 0, blockLess(pocketAt(-kDepthMm))}};
    return ground;
}

/// Where the cutter stands beside the wall on the right, y = 0.
double besideWall(const Region& centres) {
    double right = -100;
    for (const Loop& loop : centres.loops)
        if (boundingBox(loop).max().x() < 39) right = std::max(right, boundingBox(loop).max().x());
    return right;
}

std::string rectangle(double x0, double x1, double z0, double z1, const char* fill) {
    return fmt::format("<rect x=\"{:.3f}\" y=\"{:.3f}\" width=\"{:.3f}\" height=\"{:.3f}\" {}/>\n", x0, -z1,
                       x1 - x0, z1 - z0, fill);
}

std::string stairsOf(const StandingStairs& stairs, const char* fill) {
    std::string text;
    for (const StandingStairs::Slice& slice : stairs.slices())
        for (const Region& piece :
             components(intersect(slice.region, makeRectangle({0, -1}, {40, 1}), kTol))) {
            const Box2 box = boundingBox(piece);
            text += rectangle(box.min().x(), box.max().x(), slice.bottom_mm, slice.top_mm, fill);
        }
    return text;
}

/// The cutter as its discs, one a band.
std::string discsOf(const FormGround& ground, const CutterForm& form, double x_mm, double tip_mm) {
    std::string text;
    for (const Obstacle& band : ground.must_stand) {
        if (band.bottom_z_mm < tip_mm - 1e-6) continue;
        const double radius = form.radiusAt(band.top_z_mm - tip_mm);
        text += rectangle(x_mm - radius, x_mm + radius, band.bottom_z_mm, band.top_z_mm,
                          "fill=\"#8ec9e3\" fill-opacity=\"0.55\" stroke=\"#0b4f75\" stroke-width=\"0.04\"");
    }
    return text;
}

std::string drawing() {
    const FormGround ground = pocketGround();
    ToolAssembly tool;
    tool.type = ToolType::Ball;
    tool.diameter_mm = 6;
    tool.corner_radius_mm = 3;
    const CutterForm form(tool);
    const FormBands bands(ground, kTol);
    const FormCentres centres(bands, tool);
    const toolpath::ShallowGround none;
    toolpath::FormPasses passes(centres, form, {tool.radius_mm(), 0.02, 0}, none, kTol);
    StandingStairs stairs(ground, kTol);
    const std::string before = stairsOf(stairs, "fill=\"#f4c97a\"");
    std::string discs;
    int level = 0;
    for (double tip = -kLevelMm; tip > -kDepthMm - 1e-6; tip -= kLevelMm) {
        const toolpath::FormLevel passed = passes.at(tip, stairs, std::nullopt);
        stairs.cut({tip, passed.passes}, form);
        if (level++ % 3 == 0) discs += discsOf(ground, form, besideWall(passed.free_centres), tip);
    }
    const double top = kHalfFloorMm + kSlope * kDepthMm;
    std::string part =
        fmt::format("<path d=\"M0 {0} L{1} {0} L{2} 0 L20 0 L20 {3} L0 {3} Z\" fill=\"#c3ccd5\"/>\n",
                    kDepthMm, kHalfFloorMm, top, kDepthMm + 2);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" viewBox=\"0 -4 20 15.5\">\n" + part +
           before + discs + stairsOf(stairs, "fill=\"#d93025\"") + "</svg>\n";
}

}  // namespace
}  // namespace stepmill

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: draw_forms FOLDER\n");
        return 2;
    }
    stepmill::writeFile(std::filesystem::path(argv[1]) / "form-cutters.svg", stepmill::drawing());
    return 0;
}
