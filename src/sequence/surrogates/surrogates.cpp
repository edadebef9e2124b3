#include "sequence/surrogates/surrogates.h"

#include <algorithm>
#include <map>
#include <mutex>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "sequence/surrogates/lump_solver.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Values made once, by who asks first; others wait for it.
template <typename Key, typename Value>
class Shelf {
  public:
    template <typename Make>
    std::shared_ptr<const Value> get(const Key& key, Make make) {
        Place& place = placeOf(key);
        std::call_once(place.once, [&] {
            // A thread that waits for parts of its own work must not take up other work meanwhile: that may
            // ask for this same value.
            tbb::this_task_arena::isolate([&] { place.value = std::make_shared<const Value>(make()); });
        });
        return place.value;
    }

  private:
    struct Place {
        std::once_flag once;
        std::shared_ptr<const Value> value;
    };

    Place& placeOf(const Key& key) {
        const std::lock_guard lock(mutex_);
        return places_[key];
    }

    std::mutex mutex_;
    std::map<Key, Place> places_;
};

std::vector<Helper> helpersAmong(const std::vector<AccessibleArea>& areas, const ToolLibrary& library,
                                 const std::string& material) {
    std::vector<Helper> helpers;
    for (const AccessibleArea& area : areas) {
        const AccessibleArea* reach = ownReach(area);
        const ToolAssembly& tool = library.tool(area.tool_id);
        if (reach == nullptr || tool.isDrill() || tool.cuttingFor(material) == nullptr) continue;
        helpers.push_back({&tool, reach});
    }
    return helpers;
}

}  // namespace

struct SurrogateFinder::Impl {
    explicit Impl(LumpSettings made) : settings(std::move(made)) {}

    LumpSettings settings;
    std::vector<std::shared_ptr<const AccessibleArea>> kept;  ///< what helpers point to
    Shelf<int, Region> obstructions;                          ///< of helpers
    Shelf<const AccessibleArea*, Region> left;                ///< what a tool and its surrogates do not clear
    Shelf<std::pair<const AccessibleArea*, std::size_t>, std::shared_ptr<const SolvedLump>> whole_lumps;

    const Region& obstructionOf(int helper) {
        return *obstructions.get(helper, [&] {
            const AccessibleArea& reach = *settings.helpers[helper].reach;
            return reach.obstruction ? *reach.obstruction
                                     : obstructionWithHolder(settings.ground, *settings.helpers[helper].tool);
        });
    }

    /// What is not cleared when the lump's turn comes: what n leaves, and n's other lumps.
    std::vector<Region> standingAround(const AccessibleArea& n, std::size_t lump) {
        std::vector<Region> standing;
        for (std::size_t i = 0; i < n.blocked_lumps.size(); ++i)
            if (i != lump) standing.push_back(n.blocked_lumps[i].region);
        const Tolerances& tol = settings.ground.tolerances();
        standing.push_back(*left.get(&n, [&] {
            return withoutCrumbs(subtract(settings.ground.feature().target, n.coverable, tol), tol);
        }));
        return standing;
    }

    std::shared_ptr<const SolvedLump> solve(const AccessibleArea& n, std::size_t lump, const Region& rest) {
        return std::make_shared<const SolvedLump>(
            std::make_unique<LumpSolver>(settings, rest, standingAround(n, lump), n.tool_id));
    }
};

SurrogateFinder::SurrogateFinder(const FeatureGround& ground, const std::vector<AccessibleArea>& areas,
                                 const ToolLibrary& library, const SequenceOptions& options,
                                 const Machine& machine, double retract_z_mm)
    : impl_(std::make_unique<Impl>(LumpSettings{ground,
                                                library,
                                                options,
                                                machine,
                                                retract_z_mm,
                                                helpersAmong(areas, library, options.material),
                                                {}})) {
    for (const AccessibleArea& area : areas)
        if (area.clear_of_holder) impl_->kept.push_back(area.clear_of_holder);
    impl_->settings.obstruction = [impl = impl_.get()](int helper) -> const Region& {
        return impl->obstructionOf(helper);
    };
}

SurrogateFinder::~SurrogateFinder() = default;

Lumps SurrogateFinder::lumpsOf(const AccessibleArea* m, const AccessibleArea& n) const {
    const Tolerances& tol = impl_->settings.ground.tolerances();
    Lumps lumps(n.blocked_lumps.size());
    tbb::parallel_for(std::size_t{0}, lumps.size(), [&](std::size_t i) {
        const BlockedLump& lump = n.blocked_lumps[i];
        const Region rest =
            m != nullptr ? withoutCrumbs(subtract(lump.region, m->coverable, tol), tol) : lump.region;
        if (rest.empty()) return;
        // Most lumps lie where a larger cutter does not get at all.
        const bool whole = m == nullptr || lump.area_mm2 - area(rest) <= tol.area_mm2;
        lumps[i] = whole ? *impl_->whole_lumps.get({&n, i}, [&] { return impl_->solve(n, i, lump.region); })
                         : impl_->solve(n, i, rest);
    });
    std::erase(lumps, nullptr);
    return lumps;
}

int SurrogateFinder::numberOf(const ToolAssembly& tool) const {
    const std::vector<Helper>& helpers = impl_->settings.helpers;
    const auto found = std::find_if(helpers.begin(), helpers.end(),
                                    [&](const Helper& helper) { return helper.tool == &tool; });
    return found == helpers.end() ? kNoTool : static_cast<int>(found - helpers.begin());
}

}  // namespace stepmill
