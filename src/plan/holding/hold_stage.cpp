// What holds the part in a setup, as the plan keeps clear of it.

#include "stepmill/plan/hold_stage.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "plan/holding/held_stock.h"
#include "stepmill/access/collision.h"
#include "stepmill/core/error.h"
#include "stepmill/core/parallel.h"
#include "stepmill/layers/section_cutter.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/setup/stock_growth.h"

namespace stepmill {
namespace {

/// A fixture may reach that far into the stock: that much is taken for touching [mm].
constexpr double kTouchMm = 0.01;

/// The tip of a mill that breaks edges goes so far below the break [mm].
constexpr double kTipBelowBreakMm = 1;

Fixture grown(const Fixture& fixture, double growth_mm, const Tolerances& tol) {
    Fixture larger = fixture;
    larger.section = offset(fixture.section, growth_mm, tol);
    larger.top_z_mm += growth_mm;
    return larger;
}

/// \throws Error(Usage) for a fixture that stands in the stock.
void requireOutside(const Fixture& fixture, const FixtureFile& given, const LayerStack& layers,
                    const std::string& setup_id, const Tolerances& tol) {
    const Region core = offset(fixture.section, -kTouchMm, tol);
    double most_mm2 = 0;
    double from_mm = fixture.top_z_mm;
    double to_mm = fixture.bottom_z_mm;
    for (const Layer& layer : layers.layers) {
        const double low_mm = std::max(layer.bottom_z_mm, fixture.bottom_z_mm);
        const double high_mm = std::min(layer.top_z_mm, fixture.top_z_mm);
        if (high_mm - low_mm <= kTouchMm) continue;
        const double inside_mm2 = area(intersect(core, layer.stock, tol));
        if (inside_mm2 <= tol.area_mm2) continue;
        most_mm2 = std::max(most_mm2, inside_mm2);
        from_mm = std::min(from_mm, low_mm);
        to_mm = std::max(to_mm, high_mm);
    }
    if (most_mm2 == 0) return;
    throw Error(ErrorCode::Usage, given.file,
                fmt::format("fixture '{}' of {} stands in the stock: {:.4g} mm2 of it between z {:.4g} and "
                            "{:.4g} mm; expected fixtures beside the stock or on it",
                            fixture.name, setup_id, most_mm2, from_mm, to_mm));
}

/// What stands under the stock is set against it and does not grow into it.
void capUnderStock(const Fixture& fixture, const LayerStack& layers, const Tolerances& tol, Fixture& larger) {
    for (const Layer& layer : layers.layers) {
        const bool over = layer.bottom_z_mm >= fixture.top_z_mm - kTouchMm;
        if (!over || layer.bottom_z_mm >= larger.top_z_mm) continue;
        if (area(intersect(fixture.section, layer.stock, tol)) > tol.area_mm2)
            larger.top_z_mm = std::max(fixture.top_z_mm, layer.bottom_z_mm);
    }
}

/// A jaw gives way to a stock that is larger, a clamp stands on it: each counts in both places.
void growWithStock(Fixture& fixture, const StockGrowth& growth, const Tolerances& tol) {
    if (growth.raw_sides_mm) {
        const Region stock =
            makeRectangle(snapToGrid(growth.raw_sides_mm->min()), snapToGrid(growth.raw_sides_mm->max()));
        const Region away = subtract(offset(fixture.section, growth.side_mm, tol), stock, tol);
        fixture.section = unite(fixture.section, away, tol);
    }
    if (fixture.top_z_mm > kTouchMm) fixture.top_z_mm += growth.top_mm;
}

/// What the file says of the setup stands there instead of a vise.
std::vector<Fixture> givenFixtures(const Stage& stage, const FixtureFile& given, double growth_mm,
                                   const Tolerances& tol) {
    STEPMILL_CHECK(given.solids.empty(), "solids of fixtures are read before planning");
    std::vector<Fixture> fixtures;
    for (const Fixture& fixture : given.setups.at(stage.setup.id)) {
        requireOutside(fixture, given, stage.layers, stage.setup.id, tol);
        Fixture larger = grown(fixture, growth_mm, tol);
        capUnderStock(fixture, stage.layers, tol, larger);
        fixtures.push_back(std::move(larger));
    }
    return fixtures;
}

Clamping givenClamping(const FixtureFile& given, const std::string& setup_id) {
    std::vector<std::string> names;  // a solid's blocks have one
    for (const Fixture& fixture : given.setups.at(setup_id))
        if (std::find(names.begin(), names.end(), fixture.name) == names.end()) names.push_back(fixture.name);
    Clamping clamping;
    clamping.kind = HoldKind::Given;
    clamping.text =
        fmt::format("as {} says: {}", given.file,
                    names.empty() ? "nothing in the way" : fmt::format("{}", fmt::join(names, ", ")));
    return clamping;
}

/// What stands at every height of each slab; nothing over where jaws end, where it leans.
std::vector<Region> standingThroughout(const Stage& stage, const Vise& vise, const Tolerances& tol) {
    const LayerStack& layers = stage.layers;
    std::vector<Region> standing(layers.layers.size());
    std::vector<std::size_t> leaning;
    for (std::size_t i = 0; i < standing.size(); ++i) {
        const Layer& layer = layers.layers[i];
        if (layer.stock_air_mm3 <= 0)
            standing[i] = layer.stock;
        else if (layer.bottom_z_mm < layers.stock_bottom_z_mm + vise.jaw_height_mm)
            leaning.push_back(i);
    }
    if (leaning.empty()) return standing;
    const StockSections sections(stage.setup, stage.setup.stock, tol);
    parallelFor(leaning.size(), [&](std::size_t i) {
        const Layer& layer = layers.layers[leaning[i]];
        standing[leaning[i]] = sections.throughout(layer.stock, layer.bottom_z_mm, layer.top_z_mm);
    });
    return standing;
}

StockToHold stockToHold(const Stage& stage, const Vise& vise, double break_edges_mm, const Tolerances& tol) {
    StockToHold stock;
    const LayerStack& layers = stage.layers;
    for (const Layer& layer : layers.layers)
        stock.arriving.push_back({layer.stock, layer.top_z_mm, layer.bottom_z_mm});
    stock.standing = standingThroughout(stage, vise, tol);
    stock.removed = featurePrisms(stage.found);
    for (const FaceTrace& trace : layers.traces)
        if (trace.stand == FaceStand::Leaning && !trace.region.empty())
            stock.leaning.push_back({trace.region, trace.top_z_mm, trace.bottom_z_mm});
    const auto highest = std::find_if(layers.layers.begin(), layers.layers.end(),
                                      [](const Layer& layer) { return !layer.part.empty(); });
    if (break_edges_mm > 0 && highest != layers.layers.end())
        stock.round_above_mm =
            highest->top_z_mm - layers.stock_bottom_z_mm - break_edges_mm - kTipBelowBreakMm;
    const auto lowest = std::find_if(layers.layers.rbegin(), layers.layers.rend(),
                                     [](const Layer& layer) { return !layer.part.empty(); });
    if (lowest != layers.layers.rend()) stock.under_part_mm = lowest->bottom_z_mm - layers.stock_bottom_z_mm;
    return stock;
}

/// What a setup leaves for good: the frame, and the tabs that tie the part to it.
void holdByTabs(Stage& stage) {
    for (Unplanned& entry : stage.found.unplanned)
        if (entry.reason == Reason::LeftForLater) entry.reason = {Reason::Holding, {}};
    const std::size_t tabs = components(stage.reserve.back().region).size();
    stage.clamping.text += fmt::format("; {} tabs at the bottom tie the part to a frame", tabs);
}

}  // namespace

double fixtureGrowthMm(const FixtureFile& shop, const ToolLibrary& library) {
    double widest_mm = 0;
    for (const ToolAssembly& tool : library.tools) {
        widest_mm = std::max(widest_mm, tool.diameter_mm);
        for (const HolderCylinder& cylinder : tool.holder)
            widest_mm = std::max(widest_mm, cylinder.diameter_mm);
    }
    return shop.growth * widest_mm / 2;
}

Clamping clampingOf(const Stage& stage, const FixtureFile& shop, const HoldRequest& asked,
                    const Tolerances& tol) {
    if (shop.setups.contains(stage.setup.id)) return givenClamping(shop, stage.setup.id);
    return suggestClamping(stockToHold(stage, shop.vise, asked.break_edges_mm, tol),
                           {shop.vise, shop.plate_mm, asked.kind, asked.growth_mm}, tol);
}

void holdStage(Stage& stage, const FixtureFile& shop, const HoldRequest& asked, const Tolerances& tol) {
    stage.clamping = clampingOf(stage, shop, asked, tol);
    if (asked.kind == HoldKind::Tabs && !stage.reserve.empty()) holdByTabs(stage);
    std::vector<Fixture>& fixtures = stage.setup.fixtures;
    fixtures = stage.clamping.kind == HoldKind::Given ? givenFixtures(stage, shop, asked.growth_mm, tol)
                                                      : stage.clamping.fixtures;
    const HeldStock held = heldStock(stage);
    stage.found = withHeldStock(std::move(stage.found), held, tol);
    Region section = heldSection(stage.layers, stage.found, held, tol);
    if (!section.empty())
        fixtures.push_back(
            {"held stock", std::move(section), held.bottom_z_mm, held.top_z_mm, FixtureKind::HeldStock});
    const StockGrowth growth = growthOf(stage.setup.stock, stage.setup.part_to_setup);
    if (!growth.any()) return;
    for (Fixture& fixture : fixtures)
        growWithStock(fixture, growth, tol);
}

double highestFixtureMm(const std::vector<Fixture>& fixtures) {
    double highest_mm = 0;
    for (const Fixture& fixture : fixtures)
        highest_mm = std::max(highest_mm, fixture.top_z_mm);
    return highest_mm;
}

double farthestBackMm(double stock_mm, const StockGrowth& growth, const std::vector<Fixture>& fixtures) {
    double back_mm = stock_mm + growth.side_mm;
    for (const Fixture& fixture : fixtures)
        if (!fixture.section.empty()) back_mm = std::max(back_mm, boundingBox(fixture.section).max().y());
    return back_mm;
}

}  // namespace stepmill
