#include <gtest/gtest.h>

#include "stepmill/catalog/fit.h"

namespace stepmill {
namespace {

TEST(Fit, HasALetterAndAGrade) {
    const auto fit = fitFrom("JS9");
    ASSERT_TRUE(fit.has_value());
    EXPECT_EQ(fit->letter, "JS");
    EXPECT_EQ(fit->grade, 9);
    for (const char* name : {"", "7", "H", "h7", "H5", "H12", "H70", "P7", "H7 ", "7H"})
        EXPECT_FALSE(fitFrom(name).has_value()) << name;
}

void expectLimits(const char* name, double nominal_mm, double least_um, double most_um) {
    const auto limits = boreLimits(*fitFrom(name), nominal_mm);
    ASSERT_TRUE(limits.has_value());
    EXPECT_NEAR(limits->least_mm, nominal_mm + least_um / 1000, 1e-9) << name << " " << nominal_mm;
    EXPECT_NEAR(limits->most_mm, nominal_mm + most_um / 1000, 1e-9) << name << " " << nominal_mm;
}

// As printed in tables of ISO 286-2.
TEST(Fit, LimitsAreThoseOfTheStandardsTables) {
    expectLimits("H7", 8, 0, 15);
    expectLimits("H7", 6, 0, 12);  // a row's last diameter is its own
    expectLimits("H8", 25, 0, 33);
    expectLimits("G7", 20, 7, 28);
    expectLimits("F8", 40, 25, 64);
    expectLimits("JS7", 10, -7.5, 7.5);
    expectLimits("H11", 200, 0, 290);
    EXPECT_FALSE(boreLimits(*fitFrom("H7"), 250.1).has_value());
}

}  // namespace
}  // namespace stepmill
