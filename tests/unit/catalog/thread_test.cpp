#include <gtest/gtest.h>

#include "stepmill/catalog/thread.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// The standard's table rounds tolerances to preferred numbers, 3 % apart [mm].
constexpr double kTableMm = 0.015;

std::vector<std::string> namesForCore(double bore_mm) {
    std::vector<std::string> names;
    for (const ThreadSize* size : threadsForCore(bore_mm))
        names.push_back(size->thread.name);
    return names;
}

TEST(Thread, CoreLimitsAreThoseOfTheStandardsTables) {
    const auto expect = [](const char* name, double least_mm, double most_mm) {
        const CoreRange range = coreRange(threadFrom(name).value());
        EXPECT_NEAR(range.least_mm, least_mm, 1e-3) << name;
        EXPECT_NEAR(range.most_mm, most_mm, kTableMm) << name;
    };
    // ISO 965-2, class 6H.
    expect("M3", 2.459, 2.599);
    expect("M6", 4.917, 5.153);
    expect("M8", 6.647, 6.912);
    expect("M10", 8.376, 8.676);
    expect("M20", 17.294, 17.744);
}

TEST(Thread, UnifiedCoreLimitsAreThoseOfTheStandardsTable) {
    // ASME B1.1, class 2B [inch].
    const auto expect = [](const char* name, double least_inch, double most_inch) {
        const CoreRange range = coreRange(threadFrom(name).value());
        EXPECT_NEAR(mmToInch(range.least_mm), least_inch, 6e-4) << name;
        EXPECT_NEAR(mmToInch(range.most_mm), most_inch, 6e-4) << name;
    };
    expect("1/4-20", 0.196, 0.207);
    expect("#10-24", 0.145, 0.156);
    expect("3/8-16", 0.307, 0.321);
    expect("1/2-13", 0.417, 0.434);
}

TEST(Thread, EveryTapDrillMakesTheCoreOfItsThread) {
    ASSERT_GT(threadSizes().size(), 40U);
    for (const ThreadSize& size : threadSizes())
        EXPECT_TRUE(isCoreOf(size.thread, size.tap_drill_mm)) << size.thread.name;
}

TEST(Thread, NamesOfTheTablesAreReadBackAsTheirThreads) {
    for (const ThreadSize& size : threadSizes()) {
        const std::optional<Thread> read = threadFrom(size.thread.name);
        ASSERT_TRUE(read) << size.thread.name;
        EXPECT_EQ(read->name, size.thread.name);
        EXPECT_DOUBLE_EQ(read->diameter_mm, size.thread.diameter_mm);
        EXPECT_DOUBLE_EQ(read->pitch_mm, size.thread.pitch_mm);
    }
}

TEST(Thread, AMetricNameWithoutPitchIsTheCoarseOne) {
    EXPECT_EQ(threadFrom("M8")->name, "M8x1.25");
    EXPECT_DOUBLE_EQ(threadFrom("M8x1")->pitch_mm, 1);
    EXPECT_FALSE(threadFrom("M8.3")) << "no coarse pitch is known for it";
}

TEST(Thread, FractionsAndNumbersOfAnInchAreDiameters) {
    EXPECT_DOUBLE_EQ(threadFrom("#10-24")->diameter_mm, 25.4 * 0.19);
    EXPECT_DOUBLE_EQ(threadFrom("1 1/8-7")->diameter_mm, 25.4 * 1.125);
    EXPECT_DOUBLE_EQ(threadFrom("1/4-28 UNF")->pitch_mm, 25.4 / 28);
}

TEST(Thread, OtherWordsAreNoThread) {
    for (const char* name : {"", "M", "8x1.25", "M8x", "M8x0", "M8x5", "M8 x 1.25", "m8", "1/0-20", "1/4-0",
                             "1/4", "#-24", "M8x1.25 6H", "M999x0.1", "///-20"})
        EXPECT_FALSE(threadFrom(name)) << name;
    EXPECT_FALSE(threadFrom("M" + std::string(1'000'000, '8')));
}

TEST(Thread, ABoreMayBeTheCoreOfThreadsOfBothStandards) {
    EXPECT_EQ(namesForCore(6.8), std::vector<std::string>{"M8x1.25"});
    EXPECT_EQ(namesForCore(5.13), (std::vector<std::string>{"M6x1", "1/4-20 UNC"}));
    EXPECT_TRUE(namesForCore(6.0) == std::vector<std::string>{"M7x1"}) << "never its own nominal diameter";
    EXPECT_TRUE(namesForCore(0.5).empty());
}

}  // namespace
}  // namespace stepmill
