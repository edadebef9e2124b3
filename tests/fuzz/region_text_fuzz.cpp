// Whatever text comes in: it is read or refused with Error(InvalidRegion); a valid region stands every planar
// operation, and the results keep the plainest laws. A broken law, another exception or a sanitizer's finding
// stops the fuzzer and leaves the text behind as a case.

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <fmt/core.h>

#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/region_text.h"

namespace stepmill {
namespace {

/// Parts between a tenth of a millimetre and ten metres; kernels may refuse the rest, but that is not tested.
constexpr double kSmallestMm = 0.1;
constexpr double kLargestMm = 1e4;
/// Keeps one input below a second.
constexpr std::size_t kMostEdges = 200;

[[noreturn]] void fail(const std::string& law, const Region& region) {
    fmt::print(stderr, "law broken: {}\n{}", law, toText(region));
    std::abort();
}

void require(bool holds, const std::string& law, const Region& region) {
    if (!holds) fail(law, region);
}

/// Runs one operation; refusing is allowed only with the codes that say so.
template <typename Operation>
void allowRefusal(const std::string& name, const Region& region, Operation operation) {
    try {
        operation();
    } catch (const Error& error) {
        if (error.code() == ErrorCode::InvalidRegion || error.code() == ErrorCode::GeometryKernel) return;
        fail(fmt::format("{} throws: {}", name, error.what()), region);
    }
}

void requireValid(const Region& result, const std::string& name, const Region& region) {
    if (const auto trouble = diagnose(result)) fail(name + " is valid: " + *trouble, region);
}

/// A strip of `linear_mm` along all walls is what areas may differ by.
double slackMm2(const Region& region, const Tolerances& tol) {
    return tol.area_mm2 + 2 * tol.linear_mm * perimeter(region);
}

void checkOffsets(const Region& region, const Tolerances& tol) {
    const ClearanceDiagram diagram(region, tol);
    const auto widest = diagram.largestInscribedDisc();
    require(widest.has_value(), "a region with area holds a disc", region);
    const double whole_mm2 = area(region);
    const double slack_mm2 = slackMm2(region, tol);
    for (const double share : {0.2, 0.5, 0.9}) {
        const double distance_mm = share * widest->radius_mm;
        const Region shrunk = diagram.offset(-distance_mm);
        requireValid(shrunk, "shrunk", region);
        require(area(shrunk) <= whole_mm2 + slack_mm2, "shrinking never gains area", region);
        const Region opened = diagram.opening(distance_mm);
        requireValid(opened, "opening", region);
        require(area(opened) <= whole_mm2 + slack_mm2, "an opening stays inside", region);
        require(area(opened) + slack_mm2 >= area(shrunk), "an opening holds what it was grown from", region);
        const Region grown = diagram.offset(distance_mm);
        requireValid(grown, "grown", region);
        require(area(grown) + slack_mm2 >= whole_mm2, "growing never loses area", region);
    }
    require(diagram.offset(-1.01 * widest->radius_mm - tol.linear_mm).empty(),
            "nothing is left beyond the widest disc", region);
}

void checkBooleans(const Region& region, const Tolerances& tol) {
    const double whole_mm2 = area(region);
    const double slack_mm2 = slackMm2(region, tol);
    const Region both = unite(region, region, tol);
    requireValid(both, "union with itself", region);
    require(std::abs(area(both) - whole_mm2) <= slack_mm2, "united with itself it stays", region);
    const Region common = intersect(region, region, tol);
    requireValid(common, "intersection with itself", region);
    require(std::abs(area(common) - whole_mm2) <= slack_mm2, "intersected with itself it stays", region);
    require(area(subtract(region, region, tol)) <= slack_mm2, "without itself nothing stays", region);
    const Region moved = translated(region, snapToGrid(Vec2(0.1 * boundingBox(region).sizes())));
    const double together_mm2 = area(unite(region, moved, tol)) + area(intersect(region, moved, tol));
    require(std::abs(together_mm2 - 2 * whole_mm2) <= 4 * slack_mm2, "inclusion and exclusion", region);
}

void checkText(const std::string& text) {
    const Region region = regionFromText(text, "fuzz");
    std::size_t edges = 0;
    for (const Loop& loop : region.loops)
        edges += loop.segments.size();
    if (edges == 0 || edges > kMostEdges) return;
    if (diagnose(region)) return;
    require(toText(regionFromText(toText(region), "again")) == toText(region), "text keeps the region",
            region);
    const Vec2 size = boundingBox(region).sizes();
    const Vec2 far = boundingBox(region).max().cwiseAbs().cwiseMax(boundingBox(region).min().cwiseAbs());
    if (size.minCoeff() < kSmallestMm || far.maxCoeff() > kLargestMm) return;
    const Tolerances tol;
    if (area(region) < tol.area_mm2) return;
    allowRefusal("an offset", region, [&] { checkOffsets(region, tol); });
    allowRefusal("a Boolean", region, [&] { checkBooleans(region, tol); });
}

}  // namespace
}  // namespace stepmill

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        stepmill::checkText(text);
    } catch (const stepmill::Error& error) {
        if (error.code() == stepmill::ErrorCode::InvalidRegion) return 0;
        fmt::print(stderr, "reading throws: {}\n", error.what());
        std::abort();
    }
    return 0;
}
