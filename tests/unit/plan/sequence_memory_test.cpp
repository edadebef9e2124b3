#include "stepmill/plan/sequence_memory.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"

namespace stepmill {
namespace {

class SequenceMemoryTest : public ::testing::Test {
  protected:
    SequenceMemoryTest() {
        pocket_.id = "S1.F1";
        pocket_.top_z_mm = 0;
        pocket_.floor_z_mm = -10;
        pocket_.target = makeRectangle({0, 0}, {40, 30});
    }

    /// Asks, and says whether the sequence had to be made.
    bool isMade(const Feature& feature) {
        bool made = false;
        const ToolSequence sequence = memory_.sequence(feature, library_, options_, [&] {
            made = true;
            ToolSequence one;
            one.feature_id = feature.id;
            one.floor_z_mm = feature.floor_z_mm;
            return one;
        });
        EXPECT_EQ(sequence.feature_id, feature.id);
        EXPECT_EQ(sequence.floor_z_mm, feature.floor_z_mm);
        return made;
    }

    Feature pocket_;
    ToolLibrary library_ = defaultToolLibrary();
    SequenceOptions options_;
    SequenceMemory memory_;
};

TEST_F(SequenceMemoryTest, MakesEachOnceWhateverItsName) {
    EXPECT_TRUE(isMade(pocket_));
    pocket_.id = "S1.F7";
    EXPECT_FALSE(isMade(pocket_));
}

TEST_F(SequenceMemoryTest, TellsFeaturesToolsAndOptionsApart) {
    EXPECT_TRUE(isMade(pocket_));
    Feature deeper = pocket_;
    deeper.floor_z_mm = -10.000001;
    EXPECT_TRUE(isMade(deeper));
    Feature walled = pocket_;
    walled.obstruction = makeRectangle({-5, 0}, {0, 30});
    EXPECT_TRUE(isMade(walled));
    library_.tools.pop_back();
    EXPECT_TRUE(isMade(pocket_));
    options_.finish.walls_mm = 0.2;
    EXPECT_TRUE(isMade(pocket_));
    EXPECT_FALSE(isMade(pocket_));
}

TEST_F(SequenceMemoryTest, ForgetsWhatTheLastPlansDidNotAskFor) {
    constexpr int kKept = 4;
    const auto plans = [&](int count) {
        for (int i = 0; i < count; ++i)
            memory_.beginPlan();
    };
    plans(1);
    EXPECT_TRUE(isMade(pocket_));
    plans(kKept);
    EXPECT_FALSE(isMade(pocket_));
    plans(kKept + 1);
    EXPECT_TRUE(isMade(pocket_));
}

TEST_F(SequenceMemoryTest, AsksAgainAfterAFailure) {
    const auto fails = [&] {
        return memory_.sequence(pocket_, library_, options_,
                                []() -> ToolSequence { throw std::runtime_error("no time"); });
    };
    EXPECT_THROW(fails(), std::runtime_error);
    EXPECT_TRUE(isMade(pocket_));
}

TEST_F(SequenceMemoryTest, TriesWhatTookTooLongAgainOnlyWithMoreTime) {
    constexpr double kGivenS = 50;
    options_.deadline = Deadline::in(kGivenS);
    int tries = 0;
    const auto ends = [&] {
        return memory_.sequence(pocket_, library_, options_, [&]() -> ToolSequence {
            ++tries;
            throw Error(ErrorCode::TimedOut, pocket_.id, "the time for it is over");
        });
    };
    EXPECT_THROW(ends(), Error);
    EXPECT_THROW(ends(), Error);
    EXPECT_EQ(tries, 1);
    options_.deadline = Deadline::in(2 * kGivenS);
    EXPECT_TRUE(isMade(pocket_));
    options_.deadline = Deadline::in(kGivenS);
    EXPECT_FALSE(isMade(pocket_)) << "what is known is there at once";
}

}  // namespace
}  // namespace stepmill
