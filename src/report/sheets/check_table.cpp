// What the operator measures.

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "report/page/table.h"
#include "report/page/words.h"
#include "report/sheets/flip.h"
#include "report/sheets/sheet_sections.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/setup/stock_growth.h"

namespace stepmill::report {
namespace {

/// More floors than this are measured in the report's list, not at the machine.
constexpr std::size_t kMostFloors = 10;
constexpr std::size_t kMostPockets = 6;
/// Floors that a depth gauge does not tell apart.
constexpr double kSameFloorMm = 1e-3;

/// Where of the setup's operations one stands; before all for none.
int placeOf(const PlannedSetup& setup, const std::string& operation_id) {
    for (std::size_t i = 0; i < setup.operations.size(); ++i)
        if (setup.operations[i].id == operation_id) return static_cast<int>(i);
    return -1;
}

/// The last operation on a feature; null where there is none.
const Operation* lastOn(const PlannedSetup& setup, const WholeFeature<PlannedFeature>& feature) {
    const Operation* last = nullptr;
    for (const Operation& operation : setup.operations)
        for (const PlannedFeature* band : feature.bands)
            if (operation.feature_id == band->feature.id) last = &operation;
    return last;
}

/// Features that end at one height.
struct Floor {
    double z_mm = 0;
    std::vector<std::string> features;
    int after = -1;
};

/// As deep as the programs go, so that an allowance counts.
std::vector<Floor> floorsOf(const PlannedSetup& setup) {
    std::vector<Floor> floors;
    for (const WholeFeature<PlannedFeature>& feature : wholeFeatures(setup.features)) {
        const Operation* last = lastOn(setup, feature);
        if (last == nullptr || !hasFloor(feature.featureClass()) || isHole(feature.featureClass())) continue;
        const double z_mm = last->z_floor_mm;
        auto floor = std::find_if(floors.begin(), floors.end(), [&](const Floor& known) {
            return std::abs(known.z_mm - z_mm) < kSameFloorMm;
        });
        if (floor == floors.end()) floor = floors.insert(floors.end(), {z_mm, {}, -1});
        floor->features.push_back(shortId(feature.id()));
        floor->after = std::max(floor->after, placeOf(setup, last->id));
    }
    return floors;
}

bool isWalledAllRound(FeatureClass feature_class) {
    return feature_class == FeatureClass::ClosedPocket || feature_class == FeatureClass::ThroughPocket;
}

/// Checks in the order in which they can be made.
class Checks {
  public:
    explicit Checks(const PlannedSetup& setup) : setup_(setup) {}

    /// \param after  place of an operation; -1: before the start
    void add(std::string what, std::string nominal, int after) {
        checks_.push_back({std::move(what), std::move(nominal), after});
    }

    Element element() && {
        std::stable_sort(checks_.begin(), checks_.end(),
                         [](const Check& a, const Check& b) { return a.after < b.after; });
        Table table({"when", "measure", "nominal", "found"});
        for (const Check& check : checks_)
            table.row(whenWords(check.after), check.what, check.nominal, "");
        return titled("Checks", std::move(table).element());
    }

  private:
    struct Check {
        std::string what;
        std::string nominal;
        int after = -1;
    };

    std::string whenWords(int after) const {
        if (after < 0) return "before the start";
        return "after no. " + shortId(setup_.operations[after].id);
    }

    const PlannedSetup& setup_;
    std::vector<Check> checks_;
};

void addStock(Checks& checks, const Measures& in, const Setup& setup) {
    const Vec3 size = setup.stock_bbox_mm.sizes();
    std::string nominal = in.size(size);
    if (setup.stock.isRaw() && setup.stock.tolerance_mm > 0) {
        const StockGrowth growth = growthOf(setup.stock, setup.part_to_setup);
        nominal += " to " + in.size(size + Vec3(2 * growth.side_mm, 2 * growth.side_mm, growth.top_mm));
    }
    checks.add(setup.stock.isRaw() ? "blank, X × Y × Z" : "stock as it arrives, X × Y × Z", nominal, -1);
}

void addFloors(Checks& checks, const Measures& in, const PlannedSetup& setup) {
    const double seat_mm = setup.setup.stock_bbox_mm.min().z();
    std::vector<Floor> floors = floorsOf(setup);
    if (floors.size() > kMostFloors) floors.resize(kMostFloors);
    for (const Floor& floor : floors)
        checks.add(fmt::format("floor of {}: Z, height over the seat", listed(floor.features)),
                   fmt::format("Z {}, {} over the seat", in.length(floor.z_mm, 3),
                               in.length(floor.z_mm - seat_mm, 3)),
                   floor.after);
}

void addPockets(Checks& checks, const Measures& in, const PlannedSetup& setup) {
    std::size_t count = 0;
    for (const WholeFeature<PlannedFeature>& feature : wholeFeatures(setup.features)) {
        const Operation* last = lastOn(setup, feature);
        if (last == nullptr || !isWalledAllRound(feature.featureClass()) || ++count > kMostPockets) continue;
        const Vec2 size = boundingBox(feature.lowest().target).sizes();
        checks.add(
            fmt::format("{} {}: X × Y at the floor", shortId(feature.id()), toString(feature.featureClass())),
            fmt::format("{} × {}", in.number(size.x(), 3), in.length(size.y(), 3)), placeOf(setup, last->id));
    }
}

/// A through hole is as deep as the part.
std::string deepWords(const HoleGroup& hole, const Measures& in) {
    if (hole.through && !hole.isMadeInPart()) return {};
    return fmt::format(", {} deep", in.length(hole.top_mm - hole.made_to_mm));
}

void addHoles(Checks& checks, const Measures& in, const std::vector<HoleGroup>& holes) {
    for (const HoleGroup& hole : holes)
        if (hole.last >= 0)
            checks.add(fmt::format("holes {} ({}): Ø", hole.name, hole.centres.size()),
                       "Ø " + in.length(hole.diameter_mm, 3) + deepWords(hole, in), hole.last);
}

}  // namespace

Element checkTable(const SheetSubject& subject, const PlannedSetup& setup,
                   const std::vector<HoleGroup>& holes, bool last) {
    const Measures& in = subject.measures;
    Checks checks(setup);
    addStock(checks, in, setup.setup);
    addFloors(checks, in, setup);
    // What roughing leaves on walls makes them no size to measure.
    if (!subject.plan().request.roughing) {
        addPockets(checks, in, setup);
        addHoles(checks, in, holes);
        if (last && !setup.operations.empty()) {
            const Box3& part = subject.plan().part.bbox_mm;
            const bool square = isSquare(setup.setup);
            checks.add(square ? "part, X × Y × Z" : "part, x × y × z as drawn",
                       in.size((square ? part.transformed(setup.setup.part_to_setup) : part).sizes()),
                       static_cast<int>(setup.operations.size()) - 1);
        }
    }
    return std::move(checks).element();
}

}  // namespace stepmill::report
