// How wide the cutter cuts along its way.

#include "toolpath/script/engagement.h"

#include <array>
#include <cmath>

#include "stepmill/core/units.h"
#include "toolpath/swept_ground.h"

namespace stepmill::toolpath {

namespace {

/// Points of the front rim, evenly across the direction of travel.
constexpr int kRimPoints = 40;
/// Points along the path, as a share of the radius.
constexpr double kStepShare = 0.2;

/// The rim ahead of the middles of equal strips across the cutter, in radii.
std::array<Vec2, kRimPoints> makeRim() {
    std::array<Vec2, kRimPoints> rim;
    for (int i = 0; i < kRimPoints; ++i) {
        const double across = -1 + (2.0 * i + 1) / kRimPoints;
        rim[static_cast<std::size_t>(i)] = Vec2(std::sqrt(1 - across * across), across);
    }
    return rim;
}

}  // namespace

Engagement::Engagement(const ClearingTask& task, double radius_mm, double step_over_mm)
    : target_(task.target),
      cleared_(task.cleared_centres),
      radius_mm_(radius_mm),
      step_over_mm_(step_over_mm) {}

bool Engagement::isMaterial(const Vec2& p, const std::vector<Edge>& swept) const {
    const double inner = radius_mm_ * (1 - kCuspShare);
    for (const Edge& edge : swept)
        if (distanceTo(p, edge) <= inner) return false;
    return target_.contains(p) && !cleared_.isNear(p, inner);
}

double Engagement::widthAt(const Vec2& at, const Vec2& along, const std::vector<Edge>& swept) const {
    static const std::array<Vec2, kRimPoints> kRim = makeRim();
    const Vec2 across = leftOf(along);
    int engaged = 0;
    for (const Vec2& rim : kRim)
        if (isMaterial(at + radius_mm_ * (rim.x() * along + rim.y() * across), swept)) ++engaged;
    return 2 * radius_mm_ * engaged / kRimPoints;
}

Path Engagement::mark(const Path& path, std::vector<bool>& wide) {
    Path marked{path.start, {}};
    wide.clear();
    for (const Edge& edge : edgesOf(path)) {
        // The ground the cutter sweeps on this edge itself lies behind it.
        std::vector<Edge> near;
        const Box2 around = grown(edge.box, 2 * radius_mm_);
        for (const Edge& other : swept_)
            if (other.box.intersects(around)) near.push_back(other);
        const double whole = length(edge);
        const int steps = std::max(1, static_cast<int>(std::ceil(whole / (kStepShare * radius_mm_))));
        std::vector<bool> wide_at;
        for (int i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const double width = widthAt(pointAt(edge, share), tangentAt(edge, share), near);
            wide_at.push_back(width > kWidestCutShare * step_over_mm_);
        }
        const auto isWide = [&](int i) {
            return wide_at[static_cast<std::size_t>(i)] || wide_at[static_cast<std::size_t>(i) + 1];
        };
        for (int i = 0, from = 0; i < steps; ++i) {
            if (i + 1 < steps && isWide(i + 1) == isWide(i)) continue;
            const std::optional<Edge> part =
                cutOut(edge, static_cast<double>(from) / steps, static_cast<double>(i + 1) / steps);
            if (part) {
                marked.segments.push_back(part->segment);
                wide.push_back(isWide(i));
            }
            from = i + 1;
        }
        swept_.push_back(edge);
    }
    return marked;
}

void Engagement::add(const Path& path) {
    for (const Edge& edge : edgesOf(path))
        swept_.push_back(edge);
}

namespace {

/// Goes through a script's steps as the cutter does.
class Marker {
  public:
    explicit Marker(Engagement& engagement) : engagement_(engagement) {}

    void operator()(ComeDown& step) { at_ = step.at; }
    void operator()(PlungeDown& step) {
        at_ = step.at;
        engagement_.add(Path{at_, {{at_, {}}}});
    }
    void operator()(RampDown& step) {
        // Its slope is full width however it is cut; only a level one leaves clear ground.
        at_ = step.from;
        if (step.level) engagement_.add(Path{step.from, {{step.to, {}}}});
    }
    void operator()(RampAlong& step) {
        at_ = step.curve.end();
        if (step.level) engagement_.add(step.curve);
    }
    void operator()(Link& step) {
        std::vector<bool> wide;
        if (!step.in_air) engagement_.mark(Path{at_, {{step.to, {}}}}, wide);
        step.wide = std::find(wide.begin(), wide.end(), true) != wide.end();
        at_ = step.to;
    }
    void operator()(Glide& step) { at_ = step.way.back(); }
    void operator()(Cut& step) {
        step.path = engagement_.mark(step.path, step.wide);
        at_ = step.path.end();
    }

  private:
    Engagement& engagement_;
    Vec2 at_ = Vec2::Zero();
};

}  // namespace

void markWideCuts(std::vector<ScriptStep>& steps, Engagement& engagement) {
    Marker marker(engagement);
    for (ScriptStep& step : steps)
        std::visit(marker, step);
}

}  // namespace stepmill::toolpath
