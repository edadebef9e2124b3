#include "toolpath/script/needless_passes.h"

#include <algorithm>

#include "stepmill/toolpath/swept_region.h"

namespace stepmill::toolpath {

NeedlessPasses::NeedlessPasses(const DepthTask& task, DepthProgress& progress)
    : task_(task), progress_(progress), looked_at_(progress.passes().size(), false) {}

/// The ground of the passes still to be cut, without one of them.
SweptGround NeedlessPasses::groundOfPasses(int without) const {
    SweptGround ground = task_.untouched;
    for (int i = 0; i < progress_.count(); ++i) {
        if (progress_.isDone(i) || i == without) continue;
        for (const Edge& edge : edgesOf(progress_.pass(i).path))
            ground.add(edge);
    }
    return ground;
}

bool NeedlessPasses::isInnermost(const Pass& pass) const {
    return pass.closed && !pass.neighbours.empty() &&
           std::all_of(pass.neighbours.begin(), pass.neighbours.end(),
                       [&](int j) { return progress_.pass(j).level < pass.level; });
}

/// Would the pass take skins alone?
bool NeedlessPasses::isNeedless(const SweptGround& ground, const Path& path) const {
    const std::vector<Edge> edges = edgesOf(path);
    return std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
        return ground.isClear(edge, kSkinSlivers * task_.tol.sliver_mm);
    });
}

void NeedlessPasses::dropInnermost() {
    for (int i = 0; i < progress_.count(); ++i) {
        const Pass& pass = progress_.pass(i);
        if (isInnermost(pass) && isNeedless(groundOfPasses(i), pass.path)) progress_.settle(i);
    }
}

void NeedlessPasses::dropCleared() {
    for (int i = 0; i < progress_.count(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        if (progress_.isDone(i) || looked_at_[index] || !progress_.isReady(i)) continue;
        looked_at_[index] = true;
        if (isNeedless(progress_.swept(), progress_.pass(i).path)) progress_.settle(i);
    }
}

}  // namespace stepmill::toolpath
