#include "stepmill/layers/fixture_solids.h"

#include <algorithm>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/setup/setup.h"

namespace stepmill {
namespace {

/// Of many like vises and angle plates; a mesh of thousands of blocks would slow every plan.
constexpr std::size_t kMostBlocks = 500;

/// The solid as a part in a block of its own size, where it stands in the setup.
Setup standing(const Part& solid, const Eigen::Isometry3d& to_setup) {
    SetupRequest request;
    request.axes = {to_setup.linear().transpose() * Vec3::UnitZ()};
    Setup setup = chooseSetups(solid, request).front();
    const Eigen::Isometry3d moved = to_setup * setup.part_to_setup.inverse();
    Box3 box;
    for (int corner = 0; corner < 8; ++corner)
        box.extend(moved * setup.stock_bbox_mm.corner(static_cast<Box3::CornerType>(corner)));
    setup.part_to_setup = to_setup;
    setup.stock_bbox_mm = box;
    return setup;
}

std::vector<Part> solidsOf(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    ReadOptions options;
    options.max_file_bytes = max_bytes;
    std::vector<Part> solids = readStep(path, options);
    for (const Part& solid : solids) {
        if (solid.count > 1)
            throw Error(ErrorCode::InvalidCatalog, solid.file,
                        fmt::format("expected solids that stand in one place each, found {} used {} times; "
                                    "export the fixture as one part",
                                    solid.name, solid.count));
        for (const Remark& remark : solid.remarks) {
            if (remark.code == kInputDoubt) throw Error(ErrorCode::InvalidCatalog, solid.file, remark.text);
            if (remark.code == kUnitDoubt)
                throw Error(ErrorCode::InvalidCatalog, solid.file,
                            fmt::format("expected a fixture with its unit, found one of unit {} and {:.4g} x "
                                        "{:.4g} x {:.4g} mm",
                                        solid.unit_in_file, solid.bbox_mm.sizes().x(),
                                        solid.bbox_mm.sizes().y(), solid.bbox_mm.sizes().z()));
        }
    }
    return solids;
}

std::vector<Fixture> blocksOf(const FixtureSolid& fixture, const std::filesystem::path& folder,
                              std::uintmax_t max_bytes, const Tolerances& tol) {
    std::vector<Fixture> blocks;
    try {
        for (const Part& solid : solidsOf(folder / fixture.file, max_bytes))
            for (Fixture& block : fixtureBlocks(fixture.name, solid, fixture.to_setup, tol))
                blocks.push_back(std::move(block));
    } catch (const Error& error) {
        if (!isInputError(error.code())) throw;
        throw Error(ErrorCode::InvalidCatalog, fixture.pointer + "/file", error.what());
    }
    if (blocks.size() > kMostBlocks)
        throw Error(
            ErrorCode::InvalidCatalog, fixture.pointer + "/file",
            fmt::format("expected a fixture of at most {} blocks one on the other, found {}; leave out "
                        "what cutters and holders never come near",
                        kMostBlocks, blocks.size()));
    return blocks;
}

}  // namespace

std::vector<Fixture> fixtureBlocks(const std::string& name, const Part& solid,
                                   const Eigen::Isometry3d& to_setup, const Tolerances& tol) {
    std::vector<Fixture> blocks;
    // A clamp's underside may slant close over the stock.
    SliceOptions every_level;
    every_level.join_slabs = false;
    for (Layer& layer : slice(standing(solid, to_setup), tol, every_level).layers) {
        if (layer.part.empty()) continue;
        Fixture& block = blocks.emplace_back();
        block.name = name;
        block.section = std::move(layer.part);
        block.bottom_z_mm = layer.bottom_z_mm;
        block.top_z_mm = layer.top_z_mm;
    }
    return blocks;
}

FixtureFile readFixturesWithSolids(const std::filesystem::path& path, std::uintmax_t max_bytes,
                                   const Tolerances& tol) {
    FixtureFile file = readFixtures(path, max_bytes);
    for (const auto& [setup, solids] : file.solids)
        for (const FixtureSolid& solid : solids)
            for (Fixture& block : blocksOf(solid, path.parent_path(), max_bytes, tol))
                file.setups.at(setup).push_back(std::move(block));
    file.solids.clear();
    return file;
}

}  // namespace stepmill
