#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/plan/usable_library.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill {
namespace {

SequenceOptions inAluminium() {
    SequenceOptions options;
    options.material = "aluminium";
    return options;
}

/// How many tools keep their cutting data, over that height of stock.
std::size_t usable(const ToolLibrary& library, const SequenceOptions& options, const Machine& machine,
                   double deepest_mm, std::vector<Warning>& warnings) {
    const UsableLibrary found = usableLibrary(library, options, machine, deepest_mm);
    warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
    std::size_t count = 0;
    for (const ToolAssembly& tool : found.library.tools)
        count += tool.cuttingFor(options.material) != nullptr ? 1 : 0;
    return count;
}

TEST(UsableLibrary, IsAllOfAGoodOne) {
    const ToolLibrary library = defaultToolLibrary();
    std::vector<Warning> warnings;
    EXPECT_EQ(usable(library, inAluminium(), defaultMachine(), 300, warnings), library.tools.size());
    EXPECT_TRUE(warnings.empty());
}

TEST(UsableLibrary, LeavesOutFeedsThatASlowSpindleMakesNothing) {
    Machine machine = defaultMachine();
    machine.max_speed_rpm = 1;
    std::vector<Warning> warnings;
    EXPECT_EQ(usable(defaultToolLibrary(), inAluminium(), machine, 30, warnings), 0U);
    ASSERT_EQ(warnings.size(), defaultToolLibrary().tools.size());
    EXPECT_EQ(warnings.front().code, "tool-unusable");
}

TEST(UsableLibrary, LeavesOutStepDownsTooThinForTheStock) {
    ToolLibrary library = defaultToolLibrary();
    for (CuttingData& data : library.tools.front().cutting)
        data.step_down_mm = 0.01;
    std::vector<Warning> warnings;
    EXPECT_EQ(usable(library, inAluminium(), defaultMachine(), 9, warnings), library.tools.size());
    EXPECT_EQ(usable(library, inAluminium(), defaultMachine(), 11, warnings), library.tools.size() - 1);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings.front().subject, library.tools.front().id);
}

TEST(UsableLibrary, LeavesOutFinishingCutsTooThinForTheStock) {
    ToolLibrary library = defaultToolLibrary();
    for (CuttingData& data : library.tools.front().cutting) {
        data.step_over_mm = 0.05;
        data.step_down_mm = 0.5;
    }
    SequenceOptions options = inAluminium();
    options.finish.walls_mm = 2;
    std::vector<Warning> warnings;
    EXPECT_EQ(usable(library, options, defaultMachine(), 20, warnings), library.tools.size() - 1);
}

TEST(UsableLibrary, StandsInTheSpindle) {
    const ToolLibrary library = defaultToolLibrary();
    const UsableLibrary found = usableLibrary(library, inAluminium(), defaultMachine(), 30);
    EXPECT_EQ(found.library.tools.front().holder.size(),
              library.tools.front().holder.size() + defaultMachine().spindle_nose.size());
}

TEST(LayersFor, RefusesMoreThanAPathCanHave) {
    EXPECT_EQ(toolpath::depthsFor(10, 0.01), 1000);
    for (const double step_down_mm : {0.009, 3e-9, 1e-300})
        EXPECT_THROW(toolpath::depthsFor(10, step_down_mm), Error) << step_down_mm;
}

}  // namespace
}  // namespace stepmill
