#include <gtest/gtest.h>

#include "stack_maker.h"
#include "stepmill/feature/face_owner.h"
#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::makeStack;

using test::kTol;
const Region kBlock = makeRectangle({0, 0}, {100, 80});

FaceShape face(int index, const Vec3& at, const Vec3& normal) {
    FaceShape shape;
    shape.index = index;
    shape.surface = "plane";
    shape.samples = {{at, normal.normalized()}};
    return shape;
}

class AssignFaces : public ::testing::Test {
  protected:
    AssignFaces()
        : stack_(makeStack(
              kBlock, {{-10, subtract(kBlock, makeRectangle({20, 20}, {60, 60}), kTol)}, {-30, kBlock}})),
          found_(recogniseFeatures(stack_, kTol)) {
        graph_.faces = {face(0, {40, 40, -10}, {0, 0, 1}),    // floor
                        face(1, {20, 40, -5}, {1, 0, 0}),     // wall
                        face(2, {5, 5, 0}, {0, 0, 1}),        // top of the block
                        face(3, {40, 40, -30}, {0, 0, -1}),   // its bottom
                        face(4, {30, 30, -10.5}, {0, 1, 1}),  // a slope under the floor
                        face(5, {30, 30, -31}, {0, 1, 1})};   // ... and one of a hole far below it
    }
    LayerStack stack_;
    FeatureSet found_;
    FaceGraph graph_;
};

TEST_F(AssignFaces, FloorAndWallsAreThePockets) {
    ASSERT_EQ(found_.features.size(), 1U);
    const auto shares = assignFaces(graph_, Eigen::Isometry3d::Identity(), stack_, found_);
    EXPECT_EQ(found_.features[0].faces, (std::vector<int>{0, 1, 4}));
    ASSERT_EQ(shares.size(), 3U);
    EXPECT_FALSE(shares[0].leaning);
    EXPECT_TRUE(shares[2].leaning) << "a slope below the floor belongs to the feature above it";
}

TEST_F(AssignFaces, TopAndBottomLieOnTheStock) {
    EXPECT_EQ(facesOnStock(graph_, Eigen::Isometry3d::Identity(), stack_),
              (std::vector<bool>{false, false, true, true, false, true}));
}

}  // namespace
}  // namespace stepmill
