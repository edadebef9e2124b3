#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <regex>

#include <fmt/format.h>
#include <BRep_Builder.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Geom_BSplineCurve.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/core/units.h"
#include "stepmill/drawing/drawing.h"
#include "support/run_program.h"

namespace stepmill {
namespace {

DrawingOptions plate(std::map<std::string, double> depths = {}, double thickness = 10) {
    DrawingOptions options;
    options.depths = std::move(depths);
    options.outline = "OUT";
    options.thickness = thickness;
    return options;
}

/// A DXF of entities, in mm unless told otherwise.
std::string dxf(const std::string& entities, int units = 4) {
    return fmt::format(
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{}\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{}0\nENDSEC\n0\n"
        "EOF\n",
        units, entities);
}

std::string line(const char* layer, double x1, double y1, double x2, double y2) {
    return fmt::format("0\nLINE\n8\n{}\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", layer, x1, y1, x2, y2);
}

std::string square(const char* layer, double x0, double y0, double size) {
    return line(layer, x0, y0, x0 + size, y0) + line(layer, x0 + size, y0, x0 + size, y0 + size) +
           line(layer, x0 + size, y0 + size, x0, y0 + size) + line(layer, x0, y0 + size, x0, y0);
}

std::string circle(const char* layer, double x, double y, double radius) {
    return fmt::format("0\nCIRCLE\n8\n{}\n10\n{}\n20\n{}\n40\n{}\n", layer, x, y, radius);
}

std::string svg(const std::string& content) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 "
           "100\">" +
           content + "</svg>";
}

/// A STEP file of sketches, each a product of its name.
std::string stepOf(const std::vector<std::pair<std::string, std::vector<TopoDS_Shape>>>& sketches) {
    STEPControl_Writer writer;
    for (const auto& [name, shapes] : sketches) {
        TopoDS_Compound sketch;
        BRep_Builder builder;
        builder.MakeCompound(sketch);
        for (const TopoDS_Shape& shape : shapes)
            builder.Add(sketch, shape);
        Interface_Static::SetCVal("write.step.product.name", name.c_str());
        writer.Transfer(sketch, STEPControl_AsIs);
    }
    const test::TemporaryFolder folder;
    const std::filesystem::path file = std::filesystem::path(folder.path()) / "sketches.step";
    writer.Write(file.c_str());
    std::string text = readFile(file);
    // The writer numbers the products it names.
    for (const auto& [name, shapes] : sketches)
        text = std::regex_replace(text, std::regex("'" + name + " [0-9.]+'"), "'" + name + "'");
    return text;
}

double volume(const std::string& text, const DrawingOptions& options, const char* name = "plate.dxf") {
    return drawingFromText(text, name, options).volume_mm3;
}

std::string refusal(const std::string& text, const DrawingOptions& options, const char* name = "plate.dxf") {
    try {
        drawingFromText(text, name, options);
    } catch (const Error& error) {
        EXPECT_TRUE(isInputError(error.code())) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "expected an Error";
    return {};
}

/// Volumes of the kernel are integrals refined to 1e-6 of themselves.
constexpr double kShare = 2e-6;
#define EXPECT_VOLUME(found, expected) EXPECT_NEAR(found, expected, kShare*(expected))

TEST(Dxf, IsThePartOfItsProfiles) {
    const Part part = drawingFromText(dxf(square("OUT", 0, 0, 50) + circle("P", 25, 25, 10)), "plate.dxf",
                                      plate({{"P", 4}}));
    EXPECT_EQ(part.schema, "DXF");
    EXPECT_EQ(part.unit_in_file, "mm");
    EXPECT_EQ(part.name, "plate");
    EXPECT_NEAR(part.bbox_mm.min().z(), -10, 1e-6);
    EXPECT_NEAR(part.bbox_mm.max().z(), 0, 1e-6);
    EXPECT_EQ(part.faces.size(), 8u);
    EXPECT_VOLUME(part.volume_mm3, 25000 - 4 * kPi * 100);
}

TEST(Dxf, LeavesIslandsAndCutsThrough) {
    const std::string text = dxf(square("OUT", 0, 0, 50) + square("P", 10, 10, 30) + circle("P", 25, 25, 5) +
                                 circle("H", 5, 5, 2));
    EXPECT_VOLUME(volume(text, plate({{"P", 4}, {"H", 10}})), 25000 - 4 * (900 - kPi * 25) - 10 * kPi * 4);
}

TEST(Dxf, TakesProfilesInsideTheOutlineOnItsLayerAsWindows) {
    EXPECT_VOLUME(volume(dxf(square("OUT", 0, 0, 50) + square("OUT", 10, 10, 10)), plate()),
                  10 * (2500 - 100));
}

TEST(Dxf, CutsPocketsThatLieOverEachOtherOnce) {
    const std::string text = dxf(square("OUT", 0, 0, 50) + square("A", 10, 10, 20) + square("B", 20, 20, 20));
    EXPECT_VOLUME(volume(text, plate({{"A", 3}, {"B", 5}})), 25000 - 3 * 400 - 5 * 400 + 3 * 100);
}

TEST(Dxf, ReadsArcsAndBulges) {
    const double bulge = std::tan(kPi / 8);
    const std::string slot = fmt::format(
        "0\nLWPOLYLINE\n8\nP\n90\n4\n70\n1\n10\n15\n20\n20\n10\n35\n20\n20\n42\n1\n10\n35\n20\n30\n10\n15\n20"
        "\n30\n"
        "42\n1\n");
    EXPECT_VOLUME(volume(dxf(square("OUT", 0, 0, 50) + slot), plate({{"P", 2}})),
                  25000 - 2 * (200 + kPi * 25));
    const std::string quarter = "0\nARC\n8\nP\n10\n10\n20\n10\n40\n20\n50\n0\n51\n90\n" +
                                line("P", 10, 30, 10, 10) + line("P", 10, 10, 30, 10);
    EXPECT_VOLUME(volume(dxf(square("OUT", 0, 0, 50) + quarter), plate({{"P", 2}})), 25000 - 2 * kPi * 100);
    const std::string polyline = fmt::format(
        "0\nPOLYLINE\n8\nP\n66\n1\n70\n1\n0\nVERTEX\n8\nP\n10\n20\n20\n10\n42\n{0}"
        "\n0\nVERTEX\n8\nP\n10\n30\n20\n20\n42\n{0}\n"
        "0\nVERTEX\n8\nP\n10\n20\n20\n30\n42\n{0}\n0\nVERTEX\n8\nP\n10\n10\n20\n20\n42\n{0}"
        "\n0\nSEQEND\n8\nP\n",
        bulge);
    EXPECT_VOLUME(volume(dxf(square("OUT", 0, 0, 50) + polyline), plate({{"P", 2}})), 25000 - 2 * kPi * 100);
}

TEST(Dxf, TakesEllipsesAndSplinesAsTheyAre) {
    const std::string ellipse =
        "0\nELLIPSE\n8\nP\n10\n25\n20\n25\n11\n15\n21\n0\n40\n0.5\n41\n0\n42\n6.283185307179586\n";
    EXPECT_VOLUME(volume(dxf(square("OUT", 0, 0, 50) + ellipse), plate({{"P", 2}})),
                  25000 - 2 * kPi * 15 * 7.5);
    // Area under it by the integral of y dx over its parameter.
    const std::string spline =
        "0\nSPLINE\n8\nP\n70\n8\n71\n3\n72\n8\n73\n4\n74\n0\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1"
        "\n40\n1\n"
        "10\n10\n20\n10\n10\n20\n20\n20\n10\n20\n20\n20\n10\n30\n20\n10\n" +
        line("P", 30, 10, 10, 10);
    const double under_mm2 = 90;
    EXPECT_VOLUME(volume(dxf(square("OUT", 0, 0, 50) + spline), plate({{"P", 2}})), 25000 - 2 * under_mm2);
}

TEST(Dxf, AsksForTheUnitWhereItIsSilentAndConvertsInches) {
    const std::string text = dxf(square("OUT", 0, 0, 2), 0);
    EXPECT_NE(refusal(text, plate({}, 0.5)).find("--unit: expected mm, cm, m or inch"), std::string::npos);
    DrawingOptions inch = plate({}, 0.5);
    inch.unit = "inch";
    EXPECT_VOLUME(volume(text, inch), 2 * std::pow(25.4, 3));
    EXPECT_VOLUME(volume(dxf(square("OUT", 0, 0, 2), 1), plate({}, 0.5)), 2 * std::pow(25.4, 3));
}

TEST(Dxf, HealsGapsAndSaysSo) {
    const std::string text = dxf(line("OUT", 0, 0, 50, 0.01) + line("OUT", 50, 0, 50, 50) +
                                 line("OUT", 50, 50, 0, 50) + line("OUT", 0, 50, 0, 0));
    const Part part = drawingFromText(text, "plate.dxf", plate());
    EXPECT_NEAR(part.volume_mm3, 25000, 10);
    ASSERT_FALSE(part.remarks.empty());
    EXPECT_NE(part.remarks.front().text.find("1 gaps"), std::string::npos);
}

TEST(Dxf, RefusesOpenProfilesWithTheirPlace) {
    const std::string text = dxf(square("OUT", 0, 0, 50) + line("P", 10, 10, 20, 10) +
                                 line("P", 20, 10, 20, 20) + line("P", 20, 20, 10, 10.5));
    EXPECT_NE(refusal(text, plate({{"P", 2}}))
                  .find("plate.dxf, layer 'P', entity 7, at (10.0000, 10.5000) mm: expected a closed "
                        "profile, found an open end"),
              std::string::npos)
        << refusal(text, plate({{"P", 2}}));
}

TEST(Dxf, RefusesProfilesThatCross) {
    const std::string bow = line("P", 10, 10, 30, 30) + line("P", 30, 30, 30, 10) +
                            line("P", 30, 10, 10, 30) + line("P", 10, 30, 10, 10);
    const std::string itself = refusal(dxf(square("OUT", 0, 0, 50) + bow), plate({{"P", 2}}));
    EXPECT_NE(itself.find("cross neither themselves nor each other: edges cross at ("), std::string::npos)
        << itself;
    const std::string each_other = refusal(
        dxf(square("OUT", 0, 0, 50) + square("P", 10, 10, 20) + square("P", 20, 20, 20)), plate({{"P", 2}}));
    EXPECT_NE(each_other.find("edges cross at"), std::string::npos) << each_other;
    const std::string twice = refusal(
        dxf(square("OUT", 0, 0, 50) + square("P", 10, 10, 20) + square("P", 10, 10, 20)), plate({{"P", 2}}));
    EXPECT_NE(twice.find("a line drawn twice"), std::string::npos) << twice;
}

TEST(Dxf, RefusesWhatIsNoProfile) {
    const std::string out = square("OUT", 0, 0, 50);
    EXPECT_NE(refusal(dxf(out + "0\nINSERT\n8\nP\n2\nHOLE\n10\n0\n20\n0\n" + circle("P", 9, 9, 1)),
                      plate({{"P", 2}}))
                  .find("layer 'P': it holds the block 'HOLE'"),
              std::string::npos);
    EXPECT_NE(refusal(dxf(out), plate({{"Q", 2}}))
                  .find("layer 'Q': expected profiles on it, found none; the file has 'OUT'"),
              std::string::npos);
    EXPECT_NE(refusal(dxf(out + circle("P", 90, 90, 5)), plate({{"P", 2}})).find("lies inside the outline"),
              std::string::npos);
    EXPECT_NE(refusal(dxf(out + circle("P", 9, 9, -1)), plate({{"P", 2}})).find("a circle's radius above 0"),
              std::string::npos);
    EXPECT_NE(refusal("AutoCAD Binary DXF\r\n", plate()).find("export it as ASCII"), std::string::npos);
    EXPECT_NE(refusal("no drawing", plate()).find("expected a DXF drawing"), std::string::npos);
    EXPECT_NE(
        refusal(dxf(out + square("OUT", 60, 0, 10)), plate()).find("one outer profile of the part, found 2"),
        std::string::npos);
}

// dxflib makes room for them before it has read one.
TEST(Dxf, RefusesCountsOfPointsThatNoDrawingHas) {
    const std::string out = square("OUT", 0, 0, 50);
    for (const char* entity : {"LWPOLYLINE\n90\n6237309503", "SPLINE\n71\n3\n72\n-4294000000",
                               "SPLINE\n73\n200001", "SPLINE\n74\n900000000", "LEADER\n76\n900000000"})
        EXPECT_NE(refusal(dxf(out + "0\n" + entity + "\n"), plate()).find("expected 0 to 200000 points"),
                  std::string::npos)
            << entity;
}

TEST(Dxf, AsksForOutlineAndThickness) {
    DrawingOptions options = plate();
    options.outline = "";
    EXPECT_NE(refusal(dxf(square("OUT", 0, 0, 50)), options).find("--outline: expected the layer"),
              std::string::npos);
    EXPECT_NE(refusal(dxf(square("OUT", 0, 0, 50)), plate({}, 0)).find("--thickness"), std::string::npos);
    EXPECT_NE(refusal(dxf(square("OUT", 0, 0, 50)), plate({{"P", -1}})).find("--depth"), std::string::npos);
    EXPECT_NE(refusal(dxf(square("OUT", 0, 0, 9e6)), plate()).find("expected a part of"), std::string::npos);
}

TEST(Dxf, RemarksOnWhatItLeavesAside) {
    const Part part = drawingFromText(dxf(square("OUT", 0, 0, 50) + circle("Q", 9, 9, 1) +
                                          "0\nTEXT\n8\nN\n10\n0\n20\n0\n40\n3\n1\nhello\n"),
                                      "plate.dxf", plate());
    ASSERT_EQ(part.remarks.size(), 2u);
    EXPECT_NE(part.remarks[0].text.find("layers left aside, as no depth is told for them: Q"),
              std::string::npos);
    EXPECT_NE(part.remarks[1].text.find("1 N (text)"), std::string::npos);
}

TEST(Dxf, FindsProfilesByColour) {
    const std::string red = "0\nCIRCLE\n8\nP\n62\n1\n10\n25\n20\n25\n40\n5\n";
    EXPECT_VOLUME(volume(dxf(square("OUT", 0, 0, 50) + red), plate({{"colour:1", 3}})), 25000 - 3 * kPi * 25);
}

// Curves as CAD systems export sketches: a set of curves a sketch, named by it.
TEST(StepCurves, MakeThePartOfTheirProfiles) {
    const auto rectangle = [](double x, double y, double width, double height, double z) {
        BRepBuilderAPI_MakePolygon polygon;
        for (const auto& [px, py] : {std::pair(x, y), std::pair(x + width, y),
                                     std::pair(x + width, y + height), std::pair(x, y + height)})
            polygon.Add(gp_Pnt(px, py, z));
        polygon.Close();
        return polygon.Wire();
    };
    const gp_Ax2 down(gp_Pnt(30, 20, 5), gp_Dir(0, 0, -1), gp_Dir(1, 0, 0));
    const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(down, 6));
    const TopoDS_Edge half_ellipse = BRepBuilderAPI_MakeEdge(gp_Elips(down, 9, 7), 0, kPi);
    const TopoDS_Edge half_arc = BRepBuilderAPI_MakeEdge(gp_Circ(down, 9), kPi, 2 * kPi);
    const std::string plain = stepOf({{"OUT", {rectangle(0, 0, 60, 40, 5)}}, {"P", {circle}}});
    EXPECT_VOLUME(volume(plain, plate({{"P", 2}}), "plate.step"), 24000 - 2 * kPi * 36);
    const std::string mixed =
        stepOf({{"OUT", {rectangle(0, 0, 60, 40, 5)}}, {"P", {half_ellipse, half_arc}}});
    EXPECT_VOLUME(volume(mixed, plate({{"P", 2}}), "plate.step"), 24000 - kPi * (9 * 7 + 81));
}

// As POLYLINEs and splines of CAD systems are: one edge of several spans, with a point given twice.
TEST(StepCurves, AreCutAtTheirKnots) {
    const std::vector<gp_Pnt> corners{{20, 10, 5}, {40, 10, 5}, {40, 30, 5},
                                      {40, 30, 5}, {20, 30, 5}, {20, 10, 5}};
    const int count = static_cast<int>(corners.size());
    TColgp_Array1OfPnt poles(1, count);
    TColStd_Array1OfReal knots(1, count);
    TColStd_Array1OfInteger repeats(1, count);
    for (int i = 1; i <= count; ++i) {
        poles(i) = corners[static_cast<std::size_t>(i - 1)];
        knots(i) = i;
        repeats(i) = i == 1 || i == count ? 2 : 1;
    }
    const TopoDS_Edge polyline = BRepBuilderAPI_MakeEdge(new Geom_BSplineCurve(poles, knots, repeats, 1));
    const TopoDS_Edge circle =
        BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(30, 20, 5), gp_Dir(0, 0, 1)), 18));
    const std::string text = stepOf({{"OUT", {circle}}, {"P", {polyline}}});
    const Part part = drawingFromText(text, "plate.step", plate({{"P", 2}}));
    EXPECT_VOLUME(part.volume_mm3, 10 * kPi * 18 * 18 - 2 * 400);
    EXPECT_EQ(part.faces.size(), 3U + 5U);
}

TEST(StepCurves, KeepTheirFineKnots) {
    // 400 chords of a circle of 2 mm: each shorter than what is mended.
    constexpr int kChords = 400;
    TColgp_Array1OfPnt poles(1, kChords + 1);
    TColStd_Array1OfReal knots(1, kChords + 1);
    TColStd_Array1OfInteger repeats(1, kChords + 1);
    for (int i = 1; i <= kChords + 1; ++i) {
        const double angle = 2 * kPi * (i - 1) / kChords;
        poles(i) = i > kChords ? poles(1) : gp_Pnt(5 + std::cos(angle), std::sin(angle), 0);
        knots(i) = i;
        repeats(i) = i == 1 || i > kChords ? 2 : 1;
    }
    const TopoDS_Edge fine = BRepBuilderAPI_MakeEdge(new Geom_BSplineCurve(poles, knots, repeats, 1));
    const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 18));
    const TopoDS_Edge beside = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(-8, 0, 0), gp_Dir(0, 0, 1)), 2));
    const std::string text = stepOf({{"OUT", {circle}}, {"P", {fine, beside}}});
    EXPECT_NEAR(volume(text, plate({{"P", 2}}), "plate.step"), 10 * kPi * 18 * 18 - 2 * kPi * (1 + 4), 0.01);
}

TEST(StepCurves, AreAllBuiltOrRefused) {
    const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 6));
    std::string text = stepOf({{"OUT", {circle}}});
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, std::regex("GEOMETRIC_CURVE_SET\\('',\\(")));
    text.insert(static_cast<std::size_t>(found.position() + found.length()), "#99999,");
    text.insert(text.rfind("ENDSEC;"),
                "#99998=CARTESIAN_POINT('',(0.,0.,0.));\n#99999=POLYLINE('',(#99998));\n");
    EXPECT_NE(refusal(text, plate(), "disc.step")
                  .find("#99999 POLYLINE is a curve that the geometry reader cannot"),
              std::string::npos);
}

TEST(StepCurves, LieOnTheLayersOfTheFile) {
    const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 6));
    std::string text = stepOf({{"sketch", {circle}}});
    std::smatch set;
    ASSERT_TRUE(std::regex_search(text, set, std::regex("(#[0-9]+) = GEOMETRIC_CURVE_SET")));
    const std::string layer =
        fmt::format("#99999 = PRESENTATION_LAYER_ASSIGNMENT('DISC','',({}));\n", set[1].str());
    text.insert(text.rfind("ENDSEC;"), layer);
    DrawingOptions options = plate();
    options.outline = "DISC";
    EXPECT_VOLUME(volume(text, options, "disc.step"), 10 * kPi * 36);
}

TEST(StepCurves, RefuseWhatIsNoProfileInOnePlane) {
    const TopoDS_Edge low = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0));
    const TopoDS_Edge high = BRepBuilderAPI_MakeEdge(gp_Pnt(10, 0, 4), gp_Pnt(10, 9, 4));
    EXPECT_NE(refusal(stepOf({{"OUT", {low, high}}}), plate(), "plate.step")
                  .find("curve 2: expected profiles in one plane across z, found z 0 mm and z 4 mm"),
              std::string::npos);
    EXPECT_NE(refusal(stepOf({{"OUT", {low}}}), plate(), "plate.step").find("layer 'OUT'"),
              std::string::npos);
    EXPECT_NE(refusal(stepOf({{"OUT", {BRepPrimAPI_MakeBox(9, 9, 9).Shape()}}}), plate(), "plate.step")
                  .find("expected the curves of profiles alone, found 1 solid"),
              std::string::npos);
    EXPECT_NE(refusal("no STEP", plate(), "plate.step").find("plate.step"), std::string::npos);
}

TEST(Svg, ReadsShapesPathsAndTransforms) {
    const char* const name = "plate.svg";
    const std::string out = "<g id=\"OUT\"><rect width=\"50\" height=\"50\"/></g>";
    const auto pocket = [&](const std::string& shape) {
        return volume(svg(out + "<g id=\"P\">" + shape + "</g>"), plate({{"P", 2}}), name);
    };
    EXPECT_VOLUME(pocket("<rect x=\"10\" y=\"10\" width=\"20\" height=\"20\" rx=\"5\"/>"),
                  25000 - 2 * (400 - 100 + kPi * 25));
    EXPECT_VOLUME(pocket("<circle cx=\"20\" cy=\"20\" r=\"5\"/>"), 25000 - 2 * kPi * 25);
    EXPECT_VOLUME(pocket("<ellipse cx=\"20\" cy=\"20\" rx=\"8\" ry=\"4\"/>"), 25000 - 2 * kPi * 32);
    EXPECT_VOLUME(pocket("<polygon points=\"10,10 30,10 30,30\"/>"), 25000 - 2 * 200);
    EXPECT_VOLUME(pocket("<path d=\"M10 10h20v20h-20z\"/>"), 25000 - 2 * 400);
    EXPECT_VOLUME(pocket("<path d=\"m15,20a5 5 0 0110 0 5 5 0 01-10 0z\"/>"), 25000 - 2 * kPi * 25);
    EXPECT_VOLUME(pocket("<path d=\"M10 20A10 5 0 1 1 30 20A10 5 0 1 1 10 20Z\"/>"), 25000 - 2 * kPi * 50);
    // Under a cubic from (10, 10) to (30, 10) with both controls 10 farther down.
    EXPECT_VOLUME(pocket("<path d=\"M10 10C20 20 20 20 30 10Z\"/>"), 25000 - 2 * 90);
    EXPECT_VOLUME(pocket("<path d=\"M10 10Q20 30 30 10Z\"/>"), 25000 - 2 * (2.0 / 3 * 20 * 10));
    EXPECT_VOLUME(pocket("<g transform=\"translate(20 20) rotate(30) scale(2)\"><circle r=\"2\"/></g>"),
                  25000 - 2 * kPi * 16);
}

TEST(Svg, IsNotUpsideDown) {
    // SVG's y points down: what is drawn near the upper edge lies near the largest y.
    const Part part =
        drawingFromText(svg("<g id=\"OUT\"><path d=\"M0 0H50V40H25V50H0Z\"/></g>"), "plate.svg", plate());
    EXPECT_NEAR(part.bbox_mm.max().y(), 0, 1e-6);
    EXPECT_NEAR(part.bbox_mm.min().y(), -50, 1e-6);
}

TEST(Svg, FindsLayersByLabelAndProfilesByColour) {
    const std::string text =
        svg("<g inkscape:label=\"OUT\" id=\"layer1\"><rect width=\"50\" height=\"50\"/></g>"
            "<circle cx=\"20\" cy=\"20\" r=\"5\" style=\"fill:none;stroke:#ff0000\"/>");
    EXPECT_VOLUME(volume(text, plate({{"colour:#ff0000", 3}}), "plate.svg"), 25000 - 3 * kPi * 25);
}

TEST(Svg, NamesPlaceAndExpectationOfWhatIsWrong) {
    const auto wrong = [](const std::string& shape) {
        return refusal(
            svg("<g id=\"OUT\"><rect width=\"50\" height=\"50\"/></g><g id=\"P\">" + shape + "</g>"),
            plate({{"P", 2}}), "plate.svg");
    };
    EXPECT_NE(wrong("<path id=\"p7\" d=\"M0 0 L\"/>").find("plate.svg, <path> p7 at byte"),
              std::string::npos);
    EXPECT_NE(wrong("<path d=\"M5 5H10V10\"/>").find("expected a closed profile"), std::string::npos);
    EXPECT_NE(
        wrong("<g transform=\"scale(1 2)\"><circle cx=\"9\" cy=\"9\" r=\"2\"/></g>").find("keeps circles"),
        std::string::npos);
    EXPECT_NE(wrong("<g transform=\"shear(3)\"/>").find("expected matrix"), std::string::npos);
    EXPECT_NE(wrong("<rect width=\"5px\" height=\"5\"/>").find("without a unit"), std::string::npos);
    EXPECT_NE(wrong("<use href=\"#x\"/>").find("layer 'P': it holds <use>"), std::string::npos);
    EXPECT_NE(refusal("<html/>", plate(), "plate.svg").find("expected <svg>, found <html>"),
              std::string::npos);
    EXPECT_NE(refusal("<svg", plate(), "plate.svg").find("expected XML"), std::string::npos);
    const std::string unitless =
        "<svg viewBox=\"0 0 9 9\"><g id=\"OUT\"><rect width=\"5\" height=\"5\"/></g></svg>";
    EXPECT_NE(refusal(unitless, plate(), "plate.svg").find("--unit"), std::string::npos);
}

/// The pocket of step_parts/rounded_pocket.step.
TEST(CommonPocketDrawing, IsTheSolidToAMillionth) {
    const std::filesystem::path source = STEPMILL_SOURCE_DIR;
    const Part solid = readStep(source / "step_parts" / "rounded_pocket.step").front();
    DrawingOptions options;
    options.depths = {{"POCKET", 12}};
    options.outline = "OUTLINE";
    options.thickness = 30;
    for (const char* name : {"common_pocket.dxf", "common_pocket.svg"}) {
        const Part drawn = readDrawing(source / "samples" / name, options);
        EXPECT_NEAR(drawn.volume_mm3, solid.volume_mm3, 1e-6 * solid.volume_mm3) << name;
        EXPECT_EQ(drawn.faces.size(), solid.faces.size()) << name;
        EXPECT_EQ(drawn.surfaces, solid.surfaces) << name;
        EXPECT_TRUE(drawn.bbox_mm.sizes().isApprox(solid.bbox_mm.sizes(), 1e-6)) << name;
    }
}

}  // namespace
}  // namespace stepmill
