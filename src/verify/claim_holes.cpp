// The hole table against the operations of a plan.json.

#include "verify/claim_holes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/feature/heights.h"
#include "stepmill/sequence/sizing.h"
#include "stepmill/sequence/tapping.h"
#include "verify/hole_places.h"

namespace stepmill::verify {
namespace {

bool isAmong(const Vec2& place, const std::vector<Vec2>& places) {
    return std::any_of(places.begin(), places.end(),
                       [&](const Vec2& other) { return (other - place).norm() <= kOnAxisMm; });
}

class HoleComparison {
  public:
    HoleComparison(const PlanRecord& record, const DerivedHole& hole, const Tolerances& tol,
                   std::vector<ProofFailure>& failures)
        : hole_(hole), tol_(tol), failures_(failures) {
        for (const auto& [id, tool] : record.tools)
            tools_.tools.push_back(tool);
        for (const RecordedSetup& setup : record.setups)
            for (const std::string& id : setup.operation_ids)
                if (record.operations.at(id).feature_id == feature().id)
                    operations_.push_back(&record.operations.at(id));
    }

    /// \return  how many holes want a tap or a fit
    int compare(const std::vector<HoleWish>& wishes) {
        int missing = 0;
        std::vector<Vec2> to_tap;
        for (const HoleWish& wish : wishes) {
            if (wish.entry->fit) {
                if (!wish.whole || !isSized(*wish.entry)) missing += static_cast<int>(wish.places.size());
                continue;
            }
            if (wish.entry->make != HoleMaking::Tap) {
                if (wish.whole) compareMaking(wish);
                continue;
            }
            for (const Vec2& place : wish.places)
                if (!isTapped(place, *wish.entry)) ++missing;
            to_tap.insert(to_tap.end(), wish.places.begin(), wish.places.end());
        }
        for (const RecordedOperation* operation : operations_) {
            if (operation->fit && !asksFor(*operation->fit, wishes))
                fail(operation->id,
                     fmt::format("brings the hole to {}, which the hole table does not ask for",
                                 operation->fit->name));
            if (operation->thread)
                for (const Vec2& place : operation->thread->places)
                    if (!isAmong(place, to_tap))
                        fail(operation->id, fmt::format("taps {}, which the hole table does not ask for",
                                                        placeWords(place)));
        }
        return missing;
    }

  private:
    const Feature& feature() const { return hole_.planned.feature; }

    void fail(const std::string& place, const std::string& text) {
        failures_.push_back({"plan.json", 0, place, text});
    }

    void compareMaking(const HoleWish& wish) {
        for (const RecordedOperation* operation : operations_)
            if (wish.entry->make == HoleMaking::Leave)
                fail(operation->id, "cuts a hole that the hole table leaves: " + wish.entry->pointer);
            else if (operation->role != Role::Drill && operation->role != Role::Spot)
                fail(operation->id,
                     "makes a hole that the hole table wants drilled alone: " + wish.entry->pointer);
    }

    static bool asksFor(const Fit& fit, const std::vector<HoleWish>& wishes) {
        return std::any_of(wishes.begin(), wishes.end(), [&](const HoleWish& wish) {
            return wish.whole && wish.entry->fit && wish.entry->fit->name == fit.name;
        });
    }

    bool isSized(const HoleEntry& entry) const {
        return std::any_of(operations_.begin(), operations_.end(), [&](const RecordedOperation* operation) {
            return isSizedBy(operation->role, operation->fit, entry);
        });
    }

    bool isTapped(const Vec2& place, const HoleEntry& entry) {
        for (const RecordedOperation* operation : operations_) {
            if (!operation->thread || !isAmong(place, operation->thread->places)) continue;
            compareThread(*operation, entry);
            return true;
        }
        return false;
    }

    void compareThread(const RecordedOperation& operation, const HoleEntry& entry) {
        if (!sameThread(operation.thread->thread, *entry.thread))
            return fail(operation.id, fmt::format("taps {}, the hole table asks for {}",
                                                  operation.thread->thread.name, entry.thread->name));
        const Feature found = asTapFinds(feature(), operation.tool, hole_.setup.fixtures, tol_);
        const TapTask task{found,
                           boredToZ(found, made(), tools_).value_or(found.floor_z_mm),
                           feature().top_z_mm,
                           entry.thread_depth_mm,
                           {},
                           0};
        const double full_z_mm = tapDepth(task, operation.tool).full_z_mm;
        if (operation.thread->full_to_z_mm > full_z_mm + kSameWrittenHeightMm)
            fail(operation.id, fmt::format("its thread ends at Z{:.4f}, by part and hole table at Z{:.4f}",
                                           operation.thread->full_to_z_mm, full_z_mm));
    }

    /// How the hole is made before it is tapped.
    ToolSequence made() const {
        ToolSequence made = hole_.planned.sequence;
        made.steps.clear();
        for (const RecordedOperation* operation : operations_) {
            if (operation->thread) continue;
            made.steps.emplace_back();
            made.steps.back().tool_id = operation->tool.id;
            made.steps.back().role = operation->role;
        }
        return made;
    }

    ToolLibrary tools_;  ///< the recorded ones
    const DerivedHole& hole_;
    const Tolerances& tol_;
    std::vector<ProofFailure>& failures_;
    std::vector<const RecordedOperation*> operations_;  ///< on the feature, in machining order
};

}  // namespace

int compareHole(const PlanRecord& record, const HoleWishes& wishes, const DerivedHole& hole,
                const Tolerances& tol, std::vector<ProofFailure>& failures) {
    return HoleComparison(record, hole, tol, failures).compare(wishes.of(hole.planned.feature, hole.setup));
}

}  // namespace stepmill::verify
