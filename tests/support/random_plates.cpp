#include "support/random_plates.h"

#include <vector>

#include <fmt/format.h>

#include "solids.h"

namespace stepmill::test {
namespace {

/// Between cuts, and from the edge [mm].
constexpr double kWallMm = 6;

/// The plate seen from above, in strips along x of which each holds one cut.
struct Strips {
    double length_mm = 0;
    double width_mm = 0;
    std::size_t count = 1;

    double wide() const { return (length_mm - kWallMm) / static_cast<double>(count) - kWallMm; }
    double from(std::size_t i) const { return kWallMm + static_cast<double>(i) * (wide() + kWallMm); }
};

}  // namespace

SamplePart randomPlate(const std::string& name, Dice& dice) {
    const double length = dice.between(60, 120, 1);
    const double width = dice.between(50, 100, 1);
    const double thick = dice.between(14, 24, 1);
    const double corner = dice.between(5, 20, 1);
    SamplePart part{name, fmt::format("plate {} x {} x {}, corners R{}", length, width, thick, corner), {}};
    const std::size_t windows = 1 + dice.below(2);
    const std::size_t holes = 1 + dice.below(2);
    const Strips strips{length, width, windows + holes};
    std::vector<TopoDS_Shape> cuts;
    for (std::size_t i = 0; i < strips.count; ++i) {
        const double from = strips.from(i);
        const double middle = from + strips.wide() / 2;
        // Corners of the plate cut off what lies there.
        const double low = kWallMm + corner / 2;
        if (i < windows) {
            const double high = dice.between(width / 2 + 5, width - low);
            cuts.push_back(prism(rectangle(from, low, from + strips.wide(), high, 4), -1, thick + 1));
            part.about += fmt::format("; window {:.1f} x {:.1f}", strips.wide(), high - low);
        } else {
            const double diameter = dice.oneOf({5.0, 6.0, 8.0, 10.0});
            cuts.push_back(
                cylinder(middle, dice.between(low + 5, width - low - 5, 1), diameter, -1, thick + 1));
            part.about += fmt::format("; hole {}", diameter);
        }
    }
    part.solid = assemble(prism(rectangle(0, 0, length, width, corner), 0, thick), {}, cuts);
    return part;
}

}  // namespace stepmill::test
