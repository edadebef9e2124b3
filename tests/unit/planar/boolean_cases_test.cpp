// Operands that once broke a boolean, as files of tests/planar_cases: "union" or another name in the first
// line, then "a" and "b" on lines of their own, each followed by a region.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planar/boolean/arrangement.h"
#include "planar/boolean/loop_builder.h"
#include "planar/boolean/windings.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/region_text.h"

namespace stepmill {
namespace {

struct Case {
    std::string name;
    Region a;
    Region b;
};

std::vector<Case> cases() {
    std::vector<Case> result;
    for (const auto& entry : std::filesystem::directory_iterator(STEPMILL_SOURCE_DIR "/tests/planar_cases")) {
        if (entry.path().filename().string().rfind("clearance_", 0) == 0) continue;  // cases of one region
        std::ifstream file(entry.path());
        std::string line;
        std::string text[2];
        int operand = 0;
        std::getline(file, line);
        while (std::getline(file, line)) {
            if (line == "a" || line == "b")
                operand = line == "b";
            else
                text[operand] += line + "\n";
        }
        const std::string name = entry.path().filename().string();
        result.push_back({name, regionFromText(text[0], name), regionFromText(text[1], name)});
    }
    return result;
}

Region onChords(const Case& one, bool (*inside)(int, int)) {
    std::vector<planar::Curve> curves;
    planar::appendCurves(one.a, 0, curves);
    planar::appendCurves(one.b, 1, curves);
    const auto arrangement = planar::arrangeOnChords(curves, 1e-4);
    const auto labels = planar::labelled(arrangement);
    EXPECT_TRUE(planar::consistent(arrangement, labels)) << one.name;
    const auto region =
        planar::buildLoops(arrangement, planar::boundary(labels, inside), Tolerances().linear_mm);
    EXPECT_TRUE(region.has_value()) << one.name;
    return region.value_or(Region{});
}

TEST(BooleanCases, AreSolvedAndKeepTheAreaLaws) {
    const Tolerances tol;
    ASSERT_GE(cases().size(), 5u);
    for (const Case& one : cases()) {
        SCOPED_TRACE(one.name);
        const Region both = unite(one.a, one.b, tol);
        const Region common = intersect(one.a, one.b, tol);
        const Region rest = subtract(one.a, one.b, tol);
        const double slack = 2 * tol.linear_mm * (perimeter(one.a) + perimeter(one.b));
        EXPECT_NEAR(area(both) + area(common), area(one.a) + area(one.b), slack);
        EXPECT_NEAR(area(rest) + area(common), area(one.a), slack);
        for (const Region* result : {&both, &common, &rest})
            EXPECT_FALSE(diagnose(*result).has_value()) << *diagnose(*result) << "\n" << toText(*result);
    }
}

TEST(BooleanCases, ChordsNeverContradictThemselvesAndFindTheSameArea) {
    const Tolerances tol;
    for (const Case& one : cases()) {
        SCOPED_TRACE(one.name);
        const double slack = 2 * tol.linear_mm * (perimeter(one.a) + perimeter(one.b));
        const Region both = onChords(one, [](int a, int b) { return a > 0 || b > 0; });
        const Region rest = onChords(one, [](int a, int b) { return a > 0 && b <= 0; });
        EXPECT_NEAR(area(both), area(unite(one.a, one.b, tol)), slack);
        EXPECT_NEAR(area(rest), area(subtract(one.a, one.b, tol)), slack);
    }
}

TEST(BooleanCases, ChordsGiveTrueArcsBack) {
    const Case one{"ring", makeCircle({4, 4}, 3), makeRectangle({4, 0}, {9, 9})};
    const Region half = onChords(one, [](int a, int b) { return a > 0 && b <= 0; });
    EXPECT_EQ(toText(half), "loop 4 1  line 4 7  arc 4 1 centre 4 4 ccw  close\n");
}

}  // namespace
}  // namespace stepmill
