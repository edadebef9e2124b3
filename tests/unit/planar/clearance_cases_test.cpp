// Regions that once broke a clearance diagram, as files tests/planar_cases/clearance_*.txt: a region with
// comments; "# radii 1 2.5" names the distances that did it. Sizes may be below what any cutter sees: then a
// clear refusal will do.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/region_text.h"
#include "support/region_checks.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

struct Case {
    std::string name;
    Region region;
    std::vector<double> radii_mm;
    bool may_refuse = false;  ///< "# may refuse"
};

Case readCase(const std::filesystem::path& path) {
    Case result{path.stem().string(), {}, {}};
    std::ifstream file(path);
    std::string all;
    std::string line;
    while (std::getline(file, line)) {
        all += line + "\n";
        if (line.rfind("# may refuse", 0) == 0) result.may_refuse = true;
        if (line.rfind("# radii", 0) != 0) continue;
        std::istringstream numbers(line.substr(7));
        for (double radius; numbers >> radius;)
            result.radii_mm.push_back(radius);
    }
    result.region = regionFromText(all, result.name);
    return result;
}

std::vector<Case> cases() {
    std::vector<Case> result;
    for (const auto& entry : std::filesystem::directory_iterator(STEPMILL_SOURCE_DIR "/tests/planar_cases"))
        if (entry.path().filename().string().rfind("clearance_", 0) == 0)
            result.push_back(readCase(entry.path()));
    std::sort(result.begin(), result.end(), [](const Case& a, const Case& b) { return a.name < b.name; });
    return result;
}

void expectOffset(const Case& one, const ClearanceDiagram& diagram, double distance) {
    SCOPED_TRACE("offset " + fmt::format("{:.6f}", distance));
    constexpr double kRoundingMm = 1e-5;
    const Region result = diagram.offset(distance);
    EXPECT_EQ(diagnose(result), std::nullopt);
    const test::Deviation off = test::deviation(result, one.region, distance);
    EXPECT_LT(off.too_close_mm, kRoundingMm) << "at " << off.closest_at.transpose();
    EXPECT_LT(off.too_far_mm, kTol.linear_mm) << "at " << off.farthest_at.transpose();
    test::Random random(1);
    for (int i = 0; i < 200; ++i) {
        const Vec2 p = test::probePoint(one.region, std::max(0.0, distance), random);
        const double above = test::signedClearance(one.region, p) + distance;
        if (std::abs(above) < 2e-5) continue;
        EXPECT_EQ(contains(result, p), above > 0) << p.transpose() << " is above by " << above;
    }
}

void expectLaws(const Case& one, double r) {
    const ClearanceDiagram diagram(one.region, kTol);
    expectOffset(one, diagram, -r);
    expectOffset(one, diagram, r);
    const Region opened = diagram.opening(r);
    EXPECT_EQ(diagnose(opened), std::nullopt);
    const double slack = 1e-5 * perimeter(one.region);
    EXPECT_LE(area(opened), area(one.region) + slack);
    EXPECT_NEAR(diagram.accessibleArea(r), area(opened), slack);
    // At a tie a room may count either way.
    EXPECT_LE(area(opened), area(offset(diagram.offset(-0.99999 * r), r, kTol)) + 1e-3 * area(one.region));
    EXPECT_GE(area(opened), area(offset(diagram.offset(-1.00001 * r), r, kTol)) - slack);
    EXPECT_EQ(diagnose(diagram.restCentres(r, r / 2)), std::nullopt);
    EXPECT_FALSE(diagram.events().empty());
    EXPECT_FALSE(diagram.medialAxis().nodes.empty());
}

TEST(ClearanceCases, KeepTheLaws) {
    ASSERT_GE(cases().size(), 5u);
    for (const Case& one : cases()) {
        SCOPED_TRACE(one.name);
        ASSERT_FALSE(one.radii_mm.empty());
        for (const double r : one.radii_mm) {
            SCOPED_TRACE(fmt::format("radius {:.6f}", r));
            try {
                expectLaws(one, r);
            } catch (const Error& error) {
                EXPECT_TRUE(one.may_refuse && error.code() != ErrorCode::Internal) << error.what();
            }
        }
    }
}

}  // namespace
}  // namespace stepmill
