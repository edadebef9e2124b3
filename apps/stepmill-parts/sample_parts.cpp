#include "sample_parts.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <GeomConvert.hxx>
#include <Precision.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "solids.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// Tools that cut an open side reach beyond it by this much, so that no face of theirs lies in the side.
constexpr double kBeyond_mm = 5;

/// Outline given in inches, moved and turned into mm.
std::vector<Corner> inches(std::vector<Corner> outline, double x_in, double y_in) {
    for (Corner& corner : outline) {
        corner.x_mm = inchToMm(corner.x_mm + x_in);
        corner.y_mm = inchToMm(corner.y_mm + y_in);
        corner.radius_mm = inchToMm(corner.radius_mm);
    }
    return outline;
}

/// z = lowest + rise (u^2 + v^2) + skew u v^2 with u = (x - x0) / a, v = (y - y0) / b: a bowl, or with a
/// negative rise a dome, that is not symmetric in x.
struct Bowl {
    double x_mm = 0;
    double y_mm = 0;
    double a_mm = 0;
    double b_mm = 0;
    double lowest_mm = 0;
    double rise_mm = 0;
    double skew_mm = 0;
    double reach = 1;  ///< largest u and v
};

/// Exact as a B-spline of degree 2.
Handle(Geom_Surface) bowl(const Bowl& made) {
    const double reach = made.reach;
    const double linear[] = {-reach, 0, reach};                              // control values of u
    const double square[] = {reach * reach, -reach * reach, reach * reach};  // and of u^2
    TColgp_Array2OfPnt poles(1, 3, 1, 3);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double z = made.lowest_mm + made.rise_mm * (square[i] + square[j]) +
                             made.skew_mm * linear[i] * square[j];
            poles.SetValue(i + 1, j + 1,
                           gp_Pnt(made.x_mm + made.a_mm * linear[i], made.y_mm + made.b_mm * linear[j], z));
        }
    }
    return GeomConvert::SurfaceToBSplineSurface(new Geom_BezierSurface(poles));
}

/// All that stands over a surface, up to that much.
TopoDS_Shape over(const Handle(Geom_Surface) & surface, double height_mm) {
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(surface, Precision::Confusion()).Shape();
    return BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, height_mm)).Shape();
}

/// Upright cone that gets narrower towards its top.
TopoDS_Shape cone(double x, double y, double z0, double diameter, double z1, double top_diameter) {
    return BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(x, y, z0), gp::DZ()), diameter / 2, top_diameter / 2, z1 - z0)
        .Shape();
}

/// Block whose four sides lean inwards by `draft_mm` over its height.
TopoDS_Shape drafted(double x0, double y0, double z0, double x1, double y1, double z1, double draft_mm) {
    // A wedge rises along its y, which becomes z; its z then runs against y.
    const gp_Ax2 axes(gp_Pnt(x0, y1, z0), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0));
    return BRepPrimAPI_MakeWedge(axes, x1 - x0, z1 - z0, y1 - y0, draft_mm, draft_mm, x1 - x0 - draft_mm,
                                 y1 - y0 - draft_mm)
        .Shape();
}

}  // namespace

SamplePart roundedPocket() {
    // The pocket is a ring around the island: cut the pocket less the island.
    const TopoDS_Shape pocket = assemble(prism(rectangle(15, 15, 85, 65, 6), 18, 30 + kBeyond_mm), {},
                                         {cylinder(50, 40, 16, 18 - kBeyond_mm, 30 + 2 * kBeyond_mm)});
    return {"rounded_pocket",
            "block 100 x 80 x 30 with a centred pocket 70 x 50 x 12, corner radius 6, round island of "
            "diameter 16 "
            "as high as the pocket: the smallest part with a wall inside and one outside",
            assemble(box(0, 0, 0, 100, 80, 30), {}, {pocket})};
}

SamplePart butterflyPocket() {
    const double r = 4;         // inside corners, what limits the cutter
    const double shoulder = 2;  // outside corners at the necks
    const std::vector<Corner> outline = {
        {10, 15, r},  {40, 15, r},          {40, 30.5, shoulder}, {52, 30.5, shoulder}, {52, 20, r},
        {78, 20, r},  {78, 32.5, shoulder}, {90, 32.5, shoulder}, {90, 15, r},          {120, 15, r},
        {120, 55, r}, {90, 55, r},          {90, 37.5, shoulder}, {78, 37.5, shoulder}, {78, 50, r},
        {52, 50, r},  {52, 39.5, shoulder}, {40, 39.5, shoulder}, {40, 55, r},          {10, 55, r}};
    return {"butterfly_pocket",
            "block 130 x 70 x 25 with a closed pocket 10 deep: lobes 30 x 40, 26 x 30 and 30 x 40 joined by "
            "necks "
            "9 and 5 wide, inside corner radius 4: cutters above 9, above 5 and below see three, two and one "
            "area",
            assemble(box(0, 0, 0, 130, 70, 25), {}, {prism(outline, 15, 25 + kBeyond_mm)})};
}

namespace {

constexpr double kPocketX_in = 0.75;  // of the bossed pocket in its block
constexpr double kPocketY_in = 0.75;
constexpr double kBlockTop_in = 1.0;
constexpr double kPocketFloor_in = 0.7;

/// The block of both parts: a pocket, and in it an island as high as the block.
TopoDS_Shape blockOfTheBosses() {
    const double r = 0.08;
    const double top = inchToMm(kBlockTop_in);
    const double floor = inchToMm(kPocketFloor_in);
    const std::vector<Corner> outline = {{0, 0, r},    {5, 0, r},   {5, 2.6, r},   {4.2, 2.6, 0},
                                         {4.2, 4, r},  {2.6, 4, 0}, {2.6, 4.4, r}, {2.38, 4.4, r},
                                         {2.38, 4, 0}, {1.4, 4, r}, {1.4, 3.4, 0}, {0, 3.4, r}};
    const TopoDS_Shape block =
        assemble(box(0, 0, 0, inchToMm(6.5), inchToMm(5.7), top), {},
                 {prism(inches(outline, kPocketX_in, kPocketY_in), floor, top + kBeyond_mm)});
    const TopoDS_Shape island = cylinder(inchToMm(kPocketX_in + 1.6), inchToMm(kPocketY_in + 1.7),
                                         inchToMm(0.7), floor - kBeyond_mm, top);
    return assemble(block, {island}, {});
}

}  // namespace

SamplePart bossedPocket() {
    const double top = inchToMm(kBlockTop_in);
    const double boss_top = inchToMm(kPocketFloor_in + 0.85);
    const TopoDS_Shape square_boss = prism(
        inches(rectangle(4.35, 2.75, 5.2, 3.7, 0.1), kPocketX_in, kPocketY_in), top - kBeyond_mm, boss_top);
    const TopoDS_Shape round_boss = cylinder(inchToMm(kPocketX_in + 0.9), inchToMm(kPocketY_in + 3.8),
                                             inchToMm(0.5), top - kBeyond_mm, boss_top);
    return {"bossed_pocket",
            "block 6.5 x 5.7 x 1 in with a closed pocket 5 x 4 in, 0.3 in deep, corner radius 0.08 in, a leg "
            "0.22 in wide, an island as high as the block and two bosses 0.85 in over the floor, 0.15 in "
            "behind the "
            "wall: of [DSouza2006, Table 2] only the holders of the 0.2 and 0.125 in cutters pass them, "
            "after the "
            "spirit of its Fig. 8",
            assemble(blockOfTheBosses(), {square_boss, round_boss}, {})};
}

SamplePart pocketWithoutBosses() {
    return {"pocket_without_bosses", "`bossed_pocket` without its bosses, for [DSouza2006, Table 4]",
            blockOfTheBosses()};
}

SamplePart openSlots() {
    const double out = kBeyond_mm;
    const std::vector<TopoDS_Shape> cuts = {
        box(20, -out, 17, 30, 80 + out, 25 + out),  // through slot, 10 wide, 8 deep
        assemble(box(67, 48, 15, 100 + out, 62, 25 + out), {cylinder(67, 55, 14, 15, 25 + out)},
                 {}),  // blind slot
        prism({{70, -out, 0}, {100 + out, -out, 0}, {100 + out, 25, 0}, {70, 25, 5}}, 19,
              25 + out),                                    // corner step
        box(-out, -out, 13, 6, 80 + out, 25 + out),         // shoulder, 6 wide, 12 deep
        box(-out, 75, 21, 100 + out, 80 + out, 25 + out)};  // shoulder, 5 wide, 4 deep
    return {
        "open_slots",
        "block 100 x 80 x 25 with a through slot 10 wide and 8 deep, a blind slot 14 wide and 10 deep with a "
        "round end, an open corner step 30 x 25 x 6 with radius 5, shoulders 6 x 12 and 5 x 4 narrower than "
        "a "
        "12 mm cutter: what can be entered and left over open edges",
        assemble(box(0, 0, 0, 100, 80, 25), {}, cuts)};
}

SamplePart nestedPockets() {
    const TopoDS_Shape step = assemble(
        prism(rectangle(10, 10, 110, 80, 10), 32, 40 + kBeyond_mm),
        {prism(rectangle(20, 22.5, 90, 67.5, 8), 22, 36), prism(rectangle(35, 35, 65, 55, 5), 10, 30)}, {});
    return {"nested_pockets",
            "block 120 x 90 x 40 with three pockets in one another: 100 x 70 to depth 8 (radius 10), 70 x 45 "
            "to 18 "
            "(radius 8), 30 x 20 to 30 (radius 5): parents come before children",
            assemble(box(0, 0, 0, 120, 90, 40), {}, {step})};
}

SamplePart plateWithHoles() {
    const double below = -kBeyond_mm;
    const double above = 10 + kBeyond_mm;
    std::vector<TopoDS_Shape> cuts = {prism(rectangle(25, 55, 65, 80, 5), below, above),
                                      prism(rectangle(95, 50, 125, 80, 6), below, above)};
    for (const double x : {10.0, 140.0}) {
        for (const double y : {10.0, 90.0})
            cuts.push_back(cylinder(x, y, 8.5, below, above));
    }
    for (int i = 0; i < 6; ++i)
        cuts.push_back(cylinder(35 + 15 * i, 12, 5, below, above));
    for (const double x : {30.0, 45.0, 60.0}) {
        for (const double y : {30.0, 44.0})
            cuts.push_back(cylinder(x, y, 6.8, below, above));
    }
    for (const double y : {35.0, 65.0})
        cuts.push_back(cylinder(80, y, 10, below, above));
    for (const double x : {110.0, 130.0})
        cuts.push_back(cylinder(x, 32, 10, 4, above));
    return {
        "plate_with_holes",
        "plate 150 x 100 x 10 with windows 40 x 25 (radius 5) and 30 x 30 (radius 6), through holes 6 x 5, "
        "6 x 6.8, 4 x 8.5 and 2 x 10 in diameter, and two flat-bottomed holes of diameter 10, 6 deep: "
        "drilling",
        assemble(box(0, 0, 0, 150, 100, 10), {}, cuts)};
}

SamplePart fourSetups() {
    const std::vector<TopoDS_Shape> cuts = {
        prism(rectangle(20, 15, 60, 45, 5), 30, 40 + kBeyond_mm),   // +z pocket
        box(-kBeyond_mm, 24, -kBeyond_mm, 80 + kBeyond_mm, 36, 6),  // -z slot
        cylinder(15, 10, 6, -kBeyond_mm, 10),                       // -z holes
        cylinder(65, 50, 6, -kBeyond_mm, 10),
        facingX(prism(rectangle(-12, -7, 12, 7, 4), -8, kBeyond_mm), 80, 30, 22),  // +x pocket
        facingY(cylinder(0, 0, 10, -12, kBeyond_mm), 40, 60, 20)};                 // +y hole
    return {
        "four_setups",
        "block 80 x 60 x 40 with a pocket 40 x 30 x 10 (radius 5) from +z, a slot 12 x 6 and two holes of "
        "diameter 6, 10 deep, from -z, a pocket 24 x 14 x 8 (radius 4) from +x and a hole of diameter 10, 12 "
        "deep, from +y: no single direction reaches all of it",
        assemble(box(0, 0, 0, 80, 60, 40), {}, cuts)};
}

SamplePart dieCavity() {
    // Goes past the block's top on all sides.
    const TopoDS_Shape cavity = over(bowl({50, 35, 30, 20, 17, 8, 1.5, 1.3}), 30);
    return {
        "die_cavity",
        "block 100 x 70 x 25 with a free-form cavity about 60 x 40, 8 deep, one B-spline face: roughed in "
        "planes, the rest is for bull nose and ball",
        assemble(box(0, 0, 0, 100, 70, 25), {}, {cavity})};
}

SamplePart dieWithIslands() {
    const TopoDS_Shape cavity = over(bowl({70, 50, 50, 34, 20, 16, 3, 1.3}), 60);
    return {
        "die_with_islands",
        "block 140 x 100 x 36 with a free-form cavity about 100 x 68, 16 deep, one B-spline face, a conical "
        "island of diameter 24 to 14 that ends 5 under the block's top, and a round one of diameter 16 that "
        "ends 10 under it: the loops of a hunt plane are one in another, and fewer from plane to plane",
        assemble(assemble(box(0, 0, 0, 140, 100, 36), {}, {cavity}),
                 {cone(52, 50, 15, 24, 31, 14), cylinder(92, 54, 16, 15, 26)}, {})};
}

SamplePart moldCore() {
    const TopoDS_Shape sky = over(bowl({70, 50, 60, 45, 40, -10, -2, 1.3}), 60);
    const TopoDS_Shape core = assemble(drafted(25, 20, 12, 115, 80, 45, 4), {}, {sky});
    return {"mold_core",
            "plate 140 x 100 x 14 with a core 90 x 60 on it, its sides leaning 4 in 33, its top a dome, one "
            "B-spline face, 40 over the plate's bottom at its highest: roughed from outside in",
            assemble(box(0, 0, 0, 140, 100, 14), {core}, {})};
}

SamplePart shoulderBlock() {
    const std::vector<TopoDS_Shape> cuts = {
        box(30, -kBeyond_mm, 22, 80 + kBeyond_mm, 60 + kBeyond_mm, 30 + kBeyond_mm),
        box(55, -kBeyond_mm, 12, 80 + kBeyond_mm, 60 + kBeyond_mm, 30)};
    return {"shoulder_block",
            "block 80 x 60 x 30 with two steps across, 8 deep from x = 30 and 18 deep from x = 55, no round "
            "at all: "
            "every floor is open on three sides",
            assemble(box(0, 0, 0, 80, 60, 30), {}, cuts)};
}

std::vector<SamplePart> allSampleParts() {
    return {roundedPocket(), butterflyPocket(), bossedPocket(),   pocketWithoutBosses(),
            openSlots(),     nestedPockets(),   plateWithHoles(), fourSetups(),
            dieCavity(),     dieWithIslands(),  moldCore(),       shoulderBlock()};
}

std::string sampleReadme(const std::vector<SamplePart>& parts) {
    std::string text =
        "# Sample parts\n\n"
        "Made by `apps/stepmill-parts` (`stepmill-parts step_parts` writes this folder again, byte for "
        "byte). Drawn\n"
        "for this project; licence as the rest of it. AP214, millimetres, lower left bottom corner of the "
        "block at\n"
        "the origin, +z up, every face named.\n\n"
        "| file | what is in it, and why |\n|---|---|\n";
    for (const SamplePart& part : parts)
        text += "| `" + part.name + ".step` | " + part.about + " |\n";
    return text;
}

}  // namespace stepmill
