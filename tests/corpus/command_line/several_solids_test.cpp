#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>
#include <gp_Pnt.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Shape.hxx>

#include "support/run_program.h"
#include "support/told.h"

namespace stepmill::test {
namespace {

/// Inspects a file with a block of 40 x 30 x 10 mm and a cube of that size beside it.
ProgramRun inspectBlockAnd(double size_mm, const TemporaryFolder& folder) {
    STEPControl_Writer writer;
    for (const TopoDS_Shape& solid :
         {TopoDS_Shape(BRepPrimAPI_MakeBox(40, 30, 10).Shape()),
          TopoDS_Shape(BRepPrimAPI_MakeBox(gp_Pnt(50, 0, 0), size_mm, size_mm, size_mm).Shape())})
        writer.Transfer(solid, STEPControl_ManifoldSolidBrep);
    const std::string file = folder.path() + "/two.step";
    writer.Write(file.c_str());
    return runProgram({stepmillBinary(), "inspect", file, "-o", folder.path() + "/out"});
}

TEST(SeveralSolids, TheLargestIsTakenWhereTheOthersAreCrumbs) {
    const TemporaryFolder folder;
    const ProgramRun run = inspectBlockAnd(2, folder);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_TRUE(tells(run.out, {"2 different solids", "8 mm3", "--solid"}));
}

TEST(SeveralSolids, TheUserChoosesBetweenParts) {
    const TemporaryFolder folder;
    const ProgramRun run = inspectBlockAnd(8, folder);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(tells(run.err, {"2 different solids", "--solid all"}));
}

}  // namespace
}  // namespace stepmill::test
