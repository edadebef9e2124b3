// What form cutters find to take off.

#include <gtest/gtest.h>

#include "plan/forms/form_stairs.h"
#include "stepmill/core/error.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/part/part.h"
#include "stepmill/setup/setup.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

Setup firstSetupOf(const std::string& name) {
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name).front();
    return chooseSetups(part, {}).front();
}

TEST(FormStairs, AreNotLookedForAfterTheDeadline) {
    const stepmill::Setup setup = firstSetupOf("mold_core.step");
    const LayerStack layers = slice(setup, kTol);
    const SectionCutter part(setup, kTol);
    EXPECT_FALSE(stairsOf({setup, layers, setup.stock, setup.stock, {}}, part, kTol).empty());
    const FormSources late{setup, layers, setup.stock, setup.stock, Deadline::in(0)};
    try {
        stairsOf(late, part, kTol);
        FAIL() << "no deadline was heeded";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::TimedOut);
    }
}

}  // namespace
}  // namespace stepmill
