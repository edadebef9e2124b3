#pragma once

#include <gtest/gtest.h>

#include "support/raster_simulator.h"

namespace stepmill::test {

/// The simulation's cells, and the width of the strip along boundaries that is not judged [mm].
struct RasterSize {
    double cell_mm = 0.1;
    double margin_mm = 0.15;
};

/// The path clears all that the tool reaches and cuts nothing else; its own proof says so too.
inline void expectSound(const Toolpath& path, const ClearingTask& task, double radius_mm,
                        const RasterSize& raster = {}) {
    const SimulatedCut cut = simulate(path, task, radius_mm, raster.cell_mm, raster.margin_mm);
    EXPECT_EQ(cut.gouged_mm2, 0);
    EXPECT_EQ(cut.left_mm2, 0);
    EXPECT_EQ(cut.bad_rapids, 0);
    const PathProof proof = prove(path, task, radius_mm, {});
    EXPECT_GE(proof.least_clearance_mm, 0);
    EXPECT_TRUE(proof.rapids_clear);
}

}  // namespace stepmill::test
