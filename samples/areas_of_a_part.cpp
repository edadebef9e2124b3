// What each cutter of the shop reaches in the features of a part's first setup, holder included.
// Usage: areas_of_a_part PART.step

#include <cstdio>
#include <exception>

#include "stepmill/access/access.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/feature/feature.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/part/part.h"
#include "stepmill/setup/setup.h"

namespace {

using namespace stepmill;

void printReach(const Feature& feature, const ToolLibrary& library, const Tolerances& tol) {
    std::printf("%s: %s, %.1f mm2, %.2f mm deep\n", feature.id.c_str(),
                toString(feature.feature_class).c_str(), feature.area_mm2, feature.depth_mm());
    const FeatureGround ground(feature, tol);
    for (const ToolAssembly& tool : library.tools) {
        const ToolReach reach = toolReach(ground, tool, "aluminium");
        if (const Exclusion* excluded = reach.exclusion())
            std::printf("  %-8s %s\n", tool.id.c_str(), excluded->text.c_str());
        else
            std::printf("  %-8s covers %.1f %%\n", tool.id.c_str(),
                        100 * reach.cutter.coverable_area_mm2 / feature.area_mm2);
    }
}

void printPart(const char* file) {
    const Tolerances tol;
    const Part part = readStep(file).front();
    const Setup setup = chooseSetups(part, SetupRequest{}).front();
    for (const Feature& feature : recogniseFeatures(slice(setup, tol), tol).features)
        printReach(feature, defaultToolLibrary(), tol);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: areas_of_a_part PART.step\n");
        return 2;
    }
    try {
        printPart(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "areas_of_a_part: %s\n", error.what());
        return 2;
    }
    return 0;
}
