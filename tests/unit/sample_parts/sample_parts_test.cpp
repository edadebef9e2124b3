#include "sample_parts.h"

#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "stepmill/core/file.h"
#include "stepmill/core/units.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {
namespace {

/// Area of a rectangle with four rounded corners.
double rounded(double length, double width, double radius) {
    return length * width - (4 - kPi) * radius * radius;
}

double disc(double diameter) {
    return kPi * diameter * diameter / 4;
}

/// What n corners of 90 degrees with this radius take from an area (or add, for outside corners).
double corners(int n, double radius) {
    return n * (1 - kPi / 4) * radius * radius;
}

void expectVolume(const SamplePart& sample, double expected_mm3) {
    EXPECT_NEAR(makePart(sample.solid, sample.name).volume_mm3, expected_mm3, 1e-8 * expected_mm3)
        << sample.name;
}

TEST(SampleParts, VolumesAreThoseOfTheirDimensions) {
    expectVolume(roundedPocket(), 100 * 80 * 30 - 12 * (rounded(70, 50, 6) - disc(16)));
    // Lobes and necks; 12 inside corners of radius 4, 8 outside corners of radius 2.
    expectVolume(butterflyPocket(), 130 * 70 * 25 - 10 * (30 * 40 + 26 * 30 + 30 * 40 + 12 * 9 + 12 * 5 -
                                                          corners(12, 4) + corners(8, 2)));
    expectVolume(nestedPockets(), 120 * 90 * 40 - 8 * rounded(100, 70, 10) - 10 * rounded(70, 45, 8) -
                                      12 * rounded(30, 20, 5));
    expectVolume(plateWithHoles(), 10 * (150 * 100 - rounded(40, 25, 5) - rounded(30, 30, 6) - 4 * disc(8.5) -
                                         6 * disc(5) - 6 * disc(6.8) - 2 * disc(10)) -
                                       6 * 2 * disc(10));
    expectVolume(fourSetups(), 80 * 60 * 40 - 10 * rounded(40, 30, 5) - 80 * 12 * 6 - 2 * 10 * disc(6) -
                                   8 * rounded(24, 14, 4) - 12 * disc(10));
    expectVolume(shoulderBlock(), 105000);
}

TEST(SampleParts, BossedPocketIsCutAndRaisedAsItsDimensionsSay) {
    const double inch3 = kMillimetresPerInch * kMillimetresPerInch * kMillimetresPerInch;
    // 8 inside corners of the main outline, 2 at the leg's end; the others are sharp.
    const double outline = 5 * 4 - 0.8 * 1.4 - 1.4 * 0.6 + 0.22 * 0.4 - corners(8, 0.08);
    const double block = 6.5 * 5.7 - 0.3 * (outline - disc(0.7));
    const double bosses = 0.55 * (rounded(0.85, 0.95, 0.1) + disc(0.5));
    expectVolume(bossedPocket(), inch3 * (block + bosses));
    expectVolume(pocketWithoutBosses(), inch3 * block);
}

TEST(SampleParts, EachIsOneValidSolidInAPlausibleBox) {
    for (const SamplePart& sample : allSampleParts()) {
        const Part part = makePart(sample.solid, sample.name);
        EXPECT_NEAR(part.bbox_mm.min().norm(), 0, 1e-6) << sample.name;
        EXPECT_LT(part.bbox_mm.sizes().maxCoeff(), 200) << sample.name;
    }
}

TEST(SampleParts, TheCommittedFilesAreWhatTheProgramWrites) {
    const std::filesystem::path folder = std::filesystem::path(STEPMILL_SOURCE_DIR) / "step_parts";
    const std::vector<SamplePart> samples = allSampleParts();
    for (const SamplePart& sample : samples) {
        // Compared as a flag: two files of 100 kB in a failure message help nobody.
        const bool same = readFile(folder / (sample.name + ".step")) == sampleStepText(sample);
        EXPECT_TRUE(same) << sample.name << ".step differs; run stepmill-parts step_parts";
    }
    EXPECT_EQ(readFile(folder / "README.md"), sampleReadme(samples));
}

TEST(SampleParts, TheSamePartGivesTheSameBytesWhateverWasWrittenBefore) {
    const std::string first = sampleStepText(shoulderBlock());
    sampleStepText(plateWithHoles());
    EXPECT_TRUE(first == sampleStepText(shoulderBlock()));
}

TEST(SampleParts, ReadBackFromStepTheyAreTheSameParts) {
    const std::filesystem::path folder = std::filesystem::path(STEPMILL_SOURCE_DIR) / "step_parts";
    for (const SamplePart& sample : allSampleParts()) {
        SCOPED_TRACE(sample.name);
        const Part drawn = makePart(sample.solid, sample.name);
        const std::vector<Part> read = readStep(folder / (sample.name + ".step"));
        ASSERT_EQ(read.size(), 1U);
        EXPECT_EQ(read[0].name, sample.name);
        EXPECT_TRUE(read[0].remarks.empty());
        EXPECT_EQ(read[0].surfaces, drawn.surfaces);
        EXPECT_NEAR(read[0].volume_mm3, drawn.volume_mm3, 1e-8 * drawn.volume_mm3);
        for (const PartFace& face : read[0].faces)
            EXPECT_FALSE(face.step_name.empty());
    }
}

}  // namespace
}  // namespace stepmill
