// What holds the part holds it until the setup ends.

#include "verify/prove_holding.h"

#include <algorithm>

#include <fmt/format.h>

#include "stepmill/feature/heights.h"
#include "stepmill/planar/indexed_region.h"
#include "verify/prove_operation.h"

namespace stepmill::verify {
namespace {

/// A fixture whose section is asked again and again.
struct IndexedFixture {
    const Fixture* fixture = nullptr;
    IndexedRegion section;
};

class HoldingProver {
  public:
    HoldingProver(const PlanRecord& record, const RecordedSetup& setup, const Tolerances& tol,
                  Verification& into)
        : record_(record),
          setup_(setup),
          clamping_(setup.clamping),
          bottom_mm_(-setup.stock_size_mm.z()),
          tol_(tol),
          into_(into) {
        for (const Fixture& fixture : setup.fixtures)
            fixtures_.push_back({&fixture, IndexedRegion(fixture.section)});
    }

    void prove(const std::vector<ReadProgram>& programs) {
        if (clamping_.isVise()) proveVise();
        if (clamping_.kind == HoldKind::Screws && of(FixtureKind::Screw).size() < 2)
            fail("is held by screws, of which two heads at least are no fixtures");
        proveHeldStock();
        for (const ReadProgram& program : programs)
            for (const ReadOperation& operation : program.operations)
                proveOperation(program, operation);
    }

  private:
    void fail(const std::string& text) { into_.failures.push_back({"plan.json", 0, setup_.id, text}); }

    std::vector<const Fixture*> of(FixtureKind kind) const {
        std::vector<const Fixture*> found;
        for (const Fixture& fixture : setup_.fixtures)
            if (fixture.kind == kind) found.push_back(&fixture);
        return found;
    }

    double jawTopMm() const { return bottom_mm_ + clamping_.from_mm + clamping_.depth_mm; }

    void proveVise() {
        const Vise& vise = *record_.request->vise;
        if (clamping_.opening_mm > vise.opening_mm + kSameWrittenHeightMm)
            fail(fmt::format("asks for jaws {:.6g} mm open, the vise opens {:.6g} mm", clamping_.opening_mm,
                             vise.opening_mm));
        if (clamping_.depth_mm < vise.grip_mm - kSamePostedHeightMm)
            fail(fmt::format("is gripped {:.6g} mm deep, less than {:.6g} mm", clamping_.depth_mm,
                             vise.grip_mm));
        const std::vector<const Fixture*> jaws = of(FixtureKind::Jaw);
        if (jaws.size() != 2) fail(fmt::format("is held by {} jaws, expected 2", jaws.size()));
        for (const Fixture* jaw : jaws)
            if (jaw->top_z_mm < jawTopMm() + vise.jaw_clearance_mm - kSameWrittenHeightMm)
                fail(fmt::format("has a jaw up to Z{:.6g}, by grip and clearance Z{:.6g}", jaw->top_z_mm,
                                 jawTopMm() + vise.jaw_clearance_mm));
    }

    /// A grip below the part, or on sides that are cut above it, and a skin are held stock.
    void proveHeldStock() {
        if (clamping_.held_mm <= 0) return;
        const double top_mm = bottom_mm_ + clamping_.held_mm;
        if (clamping_.isVise() &&
            top_mm < jawTopMm() + record_.request->vise->jaw_clearance_mm - kSameWrittenHeightMm)
            fail("holds stock that ends below the clearance over the jaws");
        const std::vector<const Fixture*> held = of(FixtureKind::HeldStock);
        const bool there = std::any_of(held.begin(), held.end(), [&](const Fixture* fixture) {
            return !fixture->section.empty() && fixture->top_z_mm > top_mm - kSameWrittenHeightMm &&
                   fixture->bottom_z_mm < bottom_mm_ + kSameWrittenHeightMm;
        });
        if (!there) fail("has no held stock among its fixtures");
    }

    void proveOperation(const ReadProgram& program, const ReadOperation& operation) {
        const auto planned = record_.operations.find(operation.id);
        // Form cutters are not upright cylinders: proveFormMoves() keeps them off all fixtures as they are.
        if (planned == record_.operations.end() || planned->second.role == Role::Form) return;
        const double radius_mm = planned->second.tool.radius_mm();
        Vec3 from = operation.start;
        for (const ReadMove& read : operation.moves) {
            const Move& move = read.fed.move;
            const double low_mm = std::min(from.z(), move.to.z());
            const Edge way = edgeOf(from, move);
            from = move.to;
            const std::string what = meets(way, low_mm, radius_mm);
            if (what.empty()) continue;
            into_.failures.push_back({program.file, read.line, operation.id, what});
            return;
        }
    }

    /// What of the holding the cutter meets; empty: nothing.
    std::string meets(const Edge& way, double low_mm, double radius_mm) const {
        for (const auto& [fixture, section] : fixtures_) {
            if (low_mm >= fixture->top_z_mm - kSamePostedHeightMm) continue;
            const bool clear = !section.contains(way.segment.to) &&
                               !section.boundary().anyNearer(way, radius_mm - tol_.gouge_mm);
            if (!clear)
                return fmt::format("cuts into what holds the part ({}) at Z{:.4f}", fixture->name, low_mm);
        }
        return {};
    }

    const PlanRecord& record_;
    const RecordedSetup& setup_;
    const Clamping& clamping_;
    double bottom_mm_ = 0;
    const Tolerances& tol_;
    Verification& into_;
    std::vector<IndexedFixture> fixtures_;
};

}  // namespace

void proveHolding(const PlanRecord& record, const RecordedSetup& setup,
                  const std::vector<ReadProgram>& programs, const Tolerances& tol, Verification& into) {
    if (!record.request || !record.request->vise || setup.clamping.text.empty()) return;
    HoldingProver(record, setup, tol, into).prove(programs);
}

}  // namespace stepmill::verify
