#include "sequence/surrogates/surrogates.h"

#include <algorithm>

#include "sequence/surrogates/lump_solver.h"
#include "stepmill/core/parallel.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {

struct SurrogateFinder::Impl {
    std::shared_ptr<const SurrogateTools> tools;
    Shelf<std::string, Region> residuals;  ///< of each tool: what it and its surrogates do not clear
    /// By tool and number: lumps of which no other tool has cleared anything.
    Shelf<std::pair<std::string, std::size_t>, std::shared_ptr<const SolvedLump>> whole_lumps;

    /// What is not cleared when the lump's turn comes: the tool's residual, and its other lumps.
    std::vector<Region> standingAround(const std::string& tool_id, const WithSurrogates& use,
                                       std::size_t lump) const {
        std::vector<Region> standing;
        for (std::size_t i = 0; i < use.lumps.size(); ++i)
            if (i != lump) standing.push_back(use.lumps[i].region);
        const SequenceJob& job = tools->job();
        standing.push_back(residuals.get(tool_id, [&] {
            const Region rest = subtract(job.feature().target, use.together.coverable, job.tolerances());
            return withoutCrumbs(rest, job.tolerances());
        }));
        return standing;
    }

    std::shared_ptr<const SolvedLump> solve(const std::string& tool_id, const WithSurrogates& use,
                                            std::size_t lump, const Region& rest) const {
        return std::make_shared<const SolvedLump>(
            std::make_unique<LumpSolver>(tools, rest, standingAround(tool_id, use, lump), tool_id));
    }
};

SurrogateFinder::SurrogateFinder(std::shared_ptr<const SequenceJob> job,
                                 const std::vector<ToolReach>& reaches)
    : impl_(std::make_unique<Impl>()) {
    impl_->tools = std::make_shared<const SurrogateTools>(std::move(job), reaches);
}

SurrogateFinder::~SurrogateFinder() = default;

Lumps SurrogateFinder::lumpsOf(const CutterArea* m, const ToolReach& n) const {
    const WithSurrogates* use = n.surrogates();
    if (use == nullptr) return {};
    const Tolerances& tol = impl_->tools->job().tolerances();
    Lumps lumps(use->lumps.size());
    parallelFor(lumps.size(), [&](std::size_t i) {
        const BlockedLump& lump = use->lumps[i];
        const Region rest =
            m != nullptr ? withoutCrumbs(subtract(lump.region, m->coverable, tol), tol) : lump.region;
        if (rest.empty()) return;
        // Most lumps lie where a larger cutter does not get at all.
        const bool whole = m == nullptr || lump.area_mm2 - area(rest) <= tol.area_mm2;
        lumps[i] = whole ? impl_->whole_lumps.get(
                               {n.tool_id, i}, [&] { return impl_->solve(n.tool_id, *use, i, lump.region); })
                         : impl_->solve(n.tool_id, *use, i, rest);
    });
    std::erase(lumps, nullptr);
    return lumps;
}

int SurrogateFinder::numberOf(const ToolAssembly& tool) const {
    const std::vector<Surrogate>& surrogates = impl_->tools->all();
    const auto found = std::find_if(surrogates.begin(), surrogates.end(),
                                    [&](const Surrogate& surrogate) { return surrogate.tool == &tool; });
    return found == surrogates.end() ? kNoTool : static_cast<int>(found - surrogates.begin());
}

}  // namespace stepmill
