#include "toolpath/script/depth_progress.h"

#include <algorithm>

namespace stepmill::toolpath {

DepthProgress::DepthProgress(const std::vector<Pass>& passes, const SweptGround& ground)
    : passes_(passes),
      done_(passes.size(), false),
      spot_of_(passes.size()),
      left_(static_cast<int>(passes.size())),
      swept_(ground) {}

bool DepthProgress::isReady(int i) const {
    return std::all_of(pass(i).after.begin(), pass(i).after.end(), [&](int j) { return isDone(j); });
}

void DepthProgress::settle(int i) {
    done_[static_cast<std::size_t>(i)] = true;
    --left_;
}

Joint DepthProgress::jointWith(int i, const Vec2& from) const {
    const Path& path = pass(i).path;
    if (pass(i).closed) {
        const NearestPoint at = nearestOn(path, from);
        return {i, at.distance_mm, at, false};
    }
    const bool backwards = pass(i).reversible && (from - path.end()).norm() < (from - path.start).norm();
    const Vec2& point = backwards ? path.end() : path.start;
    const double distance = (from - point).norm();
    return {i, distance, {distance, 0, 0, point}, backwards};
}

std::vector<Joint> DepthProgress::waiting(bool ready) const {
    std::vector<Joint> joints;
    for (int i = 0; i < count(); ++i)
        if (!isDone(i) && isReady(i) == ready) joints.push_back(jointWith(i, at_));
    std::stable_sort(joints.begin(), joints.end(),
                     [](const Joint& a, const Joint& b) { return a.distance_mm < b.distance_mm; });
    return joints;
}

Path DepthProgress::from(const Joint& joint) const {
    const Pass& next = pass(joint.pass);
    if (joint.backwards) return reversed(next.path);
    return next.closed ? startingAt(next.path, joint.at.edge, joint.at.share) : next.path;
}

void DepthProgress::descend(const ScriptStep& step, const Vec2& to, bool needs_others) {
    descents_.push_back({steps_.size(), at_, to, needs_others});
    steps_.push_back(step);
    at_ = to;
}

void DepthProgress::link(const Vec2& to, bool in_air) {
    if ((to - at_).norm() < kGridMm / 2) return;
    steps_.push_back(Link{to, in_air});
    swept_.add(makeLine(at_, to));
    at_ = to;
}

void DepthProgress::cut(const Joint& joint) {
    const Path path = from(joint);
    steps_.push_back(Cut{path});
    finish(joint.pass, path);
}

void DepthProgress::addSpotTo(SweptGround& ground) const {
    for (int i = 0; i < count(); ++i)
        if (wasCut(i) && spotOf(i) + 1 == descents_.size())
            for (const Edge& edge : edgesOf(pass(i).path))
                ground.add(edge);
}

void DepthProgress::finish(int i, const Path& path) {
    for (const Edge& edge : edgesOf(path)) {
        swept_.add(edge);
        along_ = tangentAt(edge, 1);
    }
    settle(i);
    spot_of_[static_cast<std::size_t>(i)] = descents_.size() - 1;
    last_ = i;
    at_ = path.end();
}

}  // namespace stepmill::toolpath
