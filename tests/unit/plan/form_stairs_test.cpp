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
    const FormSources sources{setup, layers, setup.stock, setup.stock};
    EXPECT_FALSE(stairsOf(sources, part, kTol, {}).empty());
    try {
        stairsOf(sources, part, kTol, Deadline::in(0));
        FAIL() << "no deadline was heeded";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::TimedOut);
    }
}

}  // namespace
}  // namespace stepmill
