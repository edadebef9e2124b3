#include "part/step/text.h"

#include <gtest/gtest.h>

namespace stepmill {
namespace {

const std::string kHeader =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
    "FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));\nENDSEC;\nDATA;\n";
const std::string kEnd = "ENDSEC;\nEND-ISO-10303-21;\n";

std::string fileWith(const std::string& data) {
    return kHeader + data + kEnd;
}

struct Refusal {
    ErrorCode code = ErrorCode::Internal;
    std::string message;
};

Refusal refusalOf(const std::string& text) {
    try {
        screenStep(text, "part.step");
    } catch (const Error& error) {
        return {error.code(), error.what()};
    }
    ADD_FAILURE() << "not refused:\n" << text;
    return {};
}

TEST(StepText, TakesAPlainFileAndReadsItsSchema) {
    const StepText text = screenStep(fileWith("#1=CARTESIAN_POINT('',(0.,-1.5E1,+2));\n"), "part.step");
    EXPECT_EQ(text.entities, 1);
    EXPECT_EQ(text.schemas, std::vector<std::string>{"CONFIG_CONTROL_DESIGN"});
    EXPECT_TRUE(text.remarks.empty());
}

TEST(StepText, CommentsStringsAndLineEndsOfAllKindsAreNoObstacle) {
    std::string text =
        "\xEF\xBB\xBF" +
        fileWith("/* #9 NaN ; */#1 =\r\nPRODUCT('it''s NaN; #7 /* no comment',\r($,*,.T.));\r\n");
    EXPECT_EQ(screenStep(text, "part.step").entities, 1);
}

TEST(StepText, ComplexEntitiesAndTypedValuesAreTaken) {
    const StepText text = screenStep(
        fileWith(
            "#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n#2=X(LENGTH_MEASURE(2.E-5),#1);\n"),
        "part.step");
    EXPECT_TRUE(text.has_length_unit);
    EXPECT_EQ(text.entities, 2);
}

TEST(StepText, RefusesNumbersThatAreNotFiniteWithTheirLine) {
    for (const char* value : {"NaN", "nan", "-inf", "INF", "1.#QNAN", "-1.#IND", "Infinity", "nan(ind)"}) {
        const Refusal refusal =
            refusalOf(fileWith("\n#1=CARTESIAN_POINT('',(0.," + std::string(value) + ",0.));\n"));
        EXPECT_EQ(refusal.code, ErrorCode::StepDamaged) << value;
        EXPECT_NE(refusal.message.find("line 9: a finite number expected"), std::string::npos)
            << refusal.message;
    }
}

TEST(StepText, RefusesAbsurdNumbersInGeometryOnly) {
    EXPECT_EQ(refusalOf(fileWith("#1=CARTESIAN_POINT('',(1.E300,0.,0.));\n")).code,
              ErrorCode::ImplausibleSize);
    EXPECT_EQ(refusalOf(fileWith("#1=CARTESIAN_POINT('',(-2.E12,0.,0.));\n")).code,
              ErrorCode::ImplausibleSize);
    EXPECT_EQ(refusalOf(fileWith("#1=ANY_ENTITY(1.E999);\n")).code, ErrorCode::ImplausibleSize);
    EXPECT_EQ(screenStep(fileWith("#1=MEASURE(2.1E14);\n#2=CARTESIAN_POINT('',(1.E-400,1.E11,0.));\n"), "p")
                  .entities,
              2);
}

TEST(StepText, RefusesAShapeThatRefersToWhatIsNotThere) {
    const Refusal refusal =
        refusalOf(fileWith("#1=CLOSED_SHELL('',(#2,#3));\n#2=ADVANCED_FACE('',(),$,.T.);\n"));
    EXPECT_EQ(refusal.code, ErrorCode::StepDamaged);
    EXPECT_NE(refusal.message.find("#1 CLOSED_SHELL refers to #3"), std::string::npos) << refusal.message;
}

TEST(StepText, ADanglingReferenceOutsideTheShapeIsARemark) {
    const StepText text = screenStep(fileWith("#1=APPROVAL(#99);\n"), "part.step");
    ASSERT_EQ(text.remarks.size(), 1U);
    EXPECT_NE(text.remarks[0].find("#99"), std::string::npos);
}

TEST(StepText, RefusesEntitiesThatContainThemselves) {
    EXPECT_EQ(refusalOf(fileWith("#1=CLOSED_SHELL('',(#1));\n")).code, ErrorCode::StepDamaged);
    const Refusal loop = refusalOf(
        fileWith("#1=ADVANCED_FACE('',(#2));\n#2=FACE_BOUND('',#3,.T.);\n#3=EDGE_LOOP('',(#1));\n"));
    EXPECT_EQ(loop.code, ErrorCode::StepDamaged);
    EXPECT_NE(loop.message.find("contains itself"), std::string::npos) << loop.message;
}

TEST(StepText, RefusesAnIdDefinedTwice) {
    EXPECT_EQ(refusalOf(fileWith("#1=A();\n#1=B();\n")).code, ErrorCode::StepDamaged);
}

TEST(StepText, RefusesBrokenSyntaxInsteadOfGuessing) {
    for (const char* data :
         {"#1=A(\n", "#1=A(1;\n", "#1=A(1));\n", "#1=A(1 2);\n", "#1=A(1)\n#2=B();\n", "1=A();\n", "#=A();\n",
          "#1 A();\n", "#1=A(FOO);\n", "#1=A(12x);\n", "#1=A('open);\n", "#1=A(.OPEN);\n", "#1=A(\x01);\n"}) {
        EXPECT_EQ(refusalOf(fileWith(data)).code, ErrorCode::StepDamaged) << data;
    }
}

TEST(StepText, RefusesValuesAndListsOutsideRecords) {
    for (const char* data :
         {"#1=((LENGTH_UNIT()NAMED_UNIT(*)));\n", "#1=(5.,LENGTH_UNIT());\n", "#1=(LENGTH_UNIT(),(1.,2.));\n",
          "#1=5.;\n", "#1=DIRECTION('',(0.,0.,1.))DIRECTION('',(0.,0.,1.));\n"})
        EXPECT_EQ(refusalOf(fileWith(data)).code, ErrorCode::StepDamaged) << data;
}

TEST(StepText, EveryTruncationOfAFileIsRefused) {
    const std::string whole =
        fileWith("#1=CARTESIAN_POINT('a /* b',(0.,1.5E1,2.));\n/* c */#2=VERTEX_POINT('',#1);\n");
    const std::size_t last = whole.rfind("21;") + 2;  // without the final ';' nothing is lost
    for (std::size_t length = 0; length < last; ++length) {
        const Refusal refusal = refusalOf(whole.substr(0, length));
        EXPECT_TRUE(refusal.code == ErrorCode::StepDamaged || refusal.code == ErrorCode::NotStep)
            << "cut after " << length << " bytes: " << refusal.message;
    }
}

TEST(StepText, SaysWhatAFileThatIsNotStepLooksLike) {
    EXPECT_NE(refusalOf("\x1f\x8b\x08\x01").message.find("gzip"), std::string::npos);
    EXPECT_NE(refusalOf("PK\x03\x04....").message.find("ZIP"), std::string::npos);
    EXPECT_NE(refusalOf("solid t\nfacet normal 0 0 1\n").message.find("STL"), std::string::npos);
    EXPECT_NE(refusalOf("%PDF-1.4").message.find("PDF"), std::string::npos);
    EXPECT_NE(refusalOf("hello\n").message.find("plain text"), std::string::npos);
    EXPECT_NE(refusalOf(std::string("\x01\x00\x02", 3)).message.find("binary"), std::string::npos);
    EXPECT_NE(refusalOf("").message.find("empty"), std::string::npos);
    EXPECT_NE(refusalOf(" \r\n").message.find("blank"), std::string::npos);
}

/// What the message of a refusal says of the entity.
void expectRefused(const std::string& data, const std::string& words) {
    const Refusal refusal = refusalOf(fileWith(data));
    EXPECT_EQ(refusal.code, ErrorCode::StepDamaged) << data;
    EXPECT_NE(refusal.message.find(words), std::string::npos) << refusal.message;
}

const std::string kFrame =
    "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=DIRECTION('',(0.,0.,1.));\n#3=DIRECTION('',(1.,0.,0.));\n"
    "#4=AXIS2_PLACEMENT_3D('',#1,#2,#3);\n";

TEST(StepText, RefusesDirectionsAndVectorsOfNoLength) {
    expectRefused("#1=DIRECTION('',(0.,-0.,1.E-12));\n", "line 8: #1 DIRECTION has no direction");
    for (const char* length : {"0.", "-0.", "-1.", "1.E-400"})
        expectRefused(kFrame + "#168=VECTOR('',#2," + length + ");\n",
                      "line 12: #168 VECTOR parameter 3: a number above 0 expected");
    expectRefused(kFrame + "#5=AXIS2_PLACEMENT_3D('',#1,#2,#2);\n", "#5 AXIS2_PLACEMENT_3D has an axis");
}

TEST(StepText, RefusesCurvesAndSurfacesOfNoSize) {
    for (const char* entity :
         {"CIRCLE('',#4,0.)", "CYLINDRICAL_SURFACE('',#4,-2.)", "SPHERICAL_SURFACE('',#4,0.)",
          "TOROIDAL_SURFACE('',#4,2.,0.)", "ELLIPSE('',#4,1.,0.)", "CONICAL_SURFACE('',#4,-1.,0.5)",
          "CONICAL_SURFACE('',#4,1.,0.)", "CONICAL_SURFACE('',#4,1.,1.6)"})
        expectRefused(kFrame + "#5=" + entity + ";\n", "line 12: #5 ");
    EXPECT_EQ(screenStep(fileWith(kFrame + "#5=CONICAL_SURFACE('',#4,0.,0.5);\n"), "p").entities, 5);
}

TEST(StepText, RefusesReferencesToTheWrongKind) {
    expectRefused(kFrame + "#5=VERTEX_POINT('',#2);\n",
                  "#5 VERTEX_POINT parameter 2: a CARTESIAN_POINT expected, found #2 DIRECTION");
    expectRefused(kFrame + "#5=PLANE('',#1);\n", "an axis placement expected");
    expectRefused(kFrame + "#5=PLANE('',$);\n", "an axis placement expected");
    expectRefused(kFrame + "#5=PLANE(#4);\n", "#5 PLANE");
}

TEST(StepText, RefusesSplinesWhoseNumbersDisagree) {
    const auto curve = [](const std::string& points, const std::string& counts, const std::string& knots) {
        return kFrame + "#5=B_SPLINE_CURVE_WITH_KNOTS('',1,(" + points + "),.UNSPECIFIED.,.F.,.F.,(" +
               counts + "),(" + knots + "),.UNSPECIFIED.);\n";
    };
    EXPECT_EQ(screenStep(fileWith(curve("#1,#1,#1", "2,1,2", "0.,1.,2.")), "p").entities, 5);
    expectRefused(curve("#1,#1,#1", "2,1,2", "0.,2.,2."), "knots that do not increase");
    expectRefused(curve("#1,#1", "2,1,2", "0.,1.,2."), "has 2 control points of degree 1 and knots for 3");
    expectRefused(curve("#1,#1,#1", "2,1", "0.,1.,2."), "3 knots and 2 multiplicities");
    expectRefused(curve("#1,#1,#1", "2,0,3", "0.,1.,2."), "a knot of multiplicity 0");
    expectRefused(kFrame +
                      "#5=(BOUNDED_CURVE()B_SPLINE_CURVE(1,(#1,#1),.UNSPECIFIED.,.F.,.F.)"
                      "B_SPLINE_CURVE_WITH_KNOTS((2,2),(0.,1.),.UNSPECIFIED.)CURVE()"
                      "RATIONAL_B_SPLINE_CURVE((1.,0.))REPRESENTATION_ITEM(''));\n",
                  "has the weight 0");
}

TEST(StepText, RefusesIdsThatReadersCut) {
    EXPECT_EQ(screenStep(fileWith("#2147483647=A();\n"), "p").entities, 1);
    expectRefused("#2147483648=A();\n", "line 8: entity number up to 2147483647 expected");
    expectRefused("#4294967297=A();\n", "#4294967297");
    expectRefused("#1=A(#99999999999999999999999);\n", "entity number up to");
}

TEST(StepText, RefusesTokensAndNestingThatReadersCannotHold) {
    expectRefused("/*" + std::string(17000, 'x') + "*/#1=A();\n", "line 8: a comment of 17004 bytes");
    expectRefused("#1=A('" + std::string(17000, 'x') + "');\n", "line 8: a string of 17002 bytes");
    expectRefused("#1=A(" + std::string(100, '(') + std::string(100, ')') + ");\n", "nested deeper than");
    std::string chain;
    for (int i = 1; i < 1000; ++i)
        chain += "#" + std::to_string(i) + "=MAPPED_ITEM('',#" + std::to_string(i + 1) + ");\n";
    expectRefused(chain + "#1000=CARTESIAN_POINT('',(0.,0.,0.));\n", "nests entities deeper than");
}

TEST(StepText, DoubtsUnitsThatAreNotWhatTheirNamesSay) {
    const auto doubts = [](const std::string& factor) {
        return screenStep(fileWith("#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
                                   "#2=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(" +
                                   factor +
                                   "),#1);\n#3=(CONVERSION_BASED_UNIT('Inch',#2)LENGTH_UNIT()"
                                   "NAMED_UNIT(*));\n"),
                          "p")
            .doubts.size();
    };
    EXPECT_EQ(doubts("25.4"), 0U);
    EXPECT_EQ(doubts("26.4"), 1U);
}

TEST(StepText, ReferencesIntoOtherFilesByTheReferenceSectionAreDefined) {
    std::string text = fileWith("#1=CLOSED_SHELL('',(#2));\n");
    text.insert(text.find("DATA;"), "REFERENCE;\n#2=<other.stp#face>;\nENDSEC;\n");
    EXPECT_EQ(screenStep(text, "part.step").entities, 1);
}

}  // namespace
}  // namespace stepmill
