#include "stepmill/access/access_curve.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "access/curve_sampling.h"
#include "access/walls.h"
#include "stepmill/access/slivers.h"
#include "stepmill/access/swept.h"
#include "stepmill/core/enum_words.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

constexpr EnumWord<AccessEventKind> kAccessEvents[] = {{AccessEventKind::Neck, "neck"},
                                                       {AccessEventKind::CornerRadius, "corner radius"},
                                                       {AccessEventKind::Vanishes, "vanishes"}};

/// Where a diameter at which something happens is enclosed, in `linear_mm`. A neck counts as closed for
/// cutters up to one `linear_mm` narrower (the tie rule of ClearanceDiagram), so more room is below.
constexpr double kBelowShare = 1.65;
constexpr double kAboveShare = 0.25;

using access::Bracket;
using access::centresFor;
using access::CurveSamples;
using access::Probe;

class CurveFinder {
  public:
    CurveFinder(const FeatureGround& ground, double from_mm, double to_mm, const AccessCurveOptions& options)
        : ground_(ground),
          tol_(ground.tolerances()),
          walls_(ground),
          max_error_mm2_(std::max(options.max_error_share * ground.feature().area_mm2, tol_.area_mm2)),
          necks_(access::findNecks(walls_, to_mm, tol_)),
          arcs_(reachableArcs(to_mm)),
          samples_(access::sampleCurve(ground, startingDiameters(from_mm, to_mm, options.first_steps),
                                       max_error_mm2_)) {}

    AccessCurve curve() {
        AccessCurve curve;
        curve.max_error_mm2 = max_error_mm2_;
        const double depth_mm = ground_.feature().depth_mm();
        for (const Probe& probe : samples_.probes)
            curve.samples.push_back({probe.diameter_mm, probe.area_mm2, probe.area_mm2 * depth_mm});
        addNecks(curve.events);
        addVanishing(curve.events);
        addCorners(curve.events);
        std::sort(curve.events.begin(), curve.events.end(), [](const AccessEvent& a, const AccessEvent& b) {
            return std::tie(a.diameter_mm, a.kind) < std::tie(b.diameter_mm, b.kind);
        });
        return curve;
    }

  private:
    /// Circles of inside corners into which a cutter of the same radius gets.
    std::vector<Arc> reachableArcs(double to_mm) const {
        std::vector<Arc> arcs;
        for (const Arc& arc : walls_.insideArcs()) {
            if (2 * arc.radius_mm > to_mm || std::find(arcs.begin(), arcs.end(), arc) != arcs.end()) continue;
            if (walls_.discFits(arc.centre, arc.radius_mm, tol_.linear_mm)) arcs.push_back(arc);
        }
        std::sort(arcs.begin(), arcs.end(), [](const Arc& a, const Arc& b) {
            return std::tie(a.radius_mm, a.centre.y(), a.centre.x()) <
                   std::tie(b.radius_mm, b.centre.y(), b.centre.x());
        });
        return arcs;
    }

    /// Even steps, and either side of every diameter at which the walls say that something happens.
    std::vector<double> startingDiameters(double from_mm, double to_mm, int steps) const {
        std::vector<double> diameters;
        for (int i = 0; i <= steps; ++i)
            diameters.push_back(from_mm + (to_mm - from_mm) * i / steps);
        const auto enclose = [&](double diameter_mm) {
            diameters.push_back(diameter_mm - kBelowShare * tol_.linear_mm);
            diameters.push_back(diameter_mm + kAboveShare * tol_.linear_mm);
        };
        for (const access::Neck& neck : necks_)
            enclose(neck.width_mm);
        for (const Arc& arc : arcs_)
            enclose(2 * arc.radius_mm);
        const double widest_mm = ground_.widestCutterMm();
        if (std::isfinite(widest_mm)) enclose(widest_mm);
        std::sort(diameters.begin(), diameters.end());
        std::vector<double> kept;
        for (const double diameter : diameters) {
            if (diameter < from_mm || diameter > to_mm) continue;
            if (kept.empty() || diameter - kept.back() > tol_.linear_mm / 8) kept.push_back(diameter);
        }
        return kept;
    }

    /// The probes on either side of a diameter that the start enclosed.
    Bracket around(double diameter_mm) const {
        const auto high =
            std::upper_bound(samples_.probes.begin(), samples_.probes.end(), diameter_mm,
                             [](double value, const Probe& probe) { return value < probe.diameter_mm; });
        if (high == samples_.probes.end()) return {samples_.probes.back(), samples_.probes.back()};
        auto low = high;
        while (low != samples_.probes.begin() && low->diameter_mm > diameter_mm - 1.5 * tol_.linear_mm)
            --low;
        return {*low, *high};
    }

    void addNecks(std::vector<AccessEvent>& events) const {
        for (const access::Neck& neck : necks_) {
            if (neck.width_mm <= samples_.probes.front().diameter_mm) continue;
            addPlace(events, AccessEventKind::Neck, neck.width_mm, neck.at, around(neck.width_mm));
        }
    }

    void addCorners(std::vector<AccessEvent>& events) const {
        for (const Arc& arc : arcs_) {
            const double diameter_mm = 2 * arc.radius_mm;
            if (diameter_mm <= samples_.probes.front().diameter_mm) continue;
            const bool is_known = std::any_of(events.begin(), events.end(), [&](const AccessEvent& event) {
                return event.kind != AccessEventKind::CornerRadius &&
                       std::abs(event.diameter_mm - diameter_mm) <= 2 * tol_.linear_mm &&
                       event.area_before_mm2 - event.area_after_mm2 > max_error_mm2_ &&
                       std::any_of(event.at.begin(), event.at.end(),
                                   [&](const Vec2& at) { return (at - arc.centre).norm() < arc.radius_mm; });
            });
            if (!is_known)
                addPlace(events, AccessEventKind::CornerRadius, diameter_mm, arc.centre, around(diameter_mm));
        }
    }

    /// Rooms of the last centres before a bracket in which no centre is left after it.
    void addVanishing(std::vector<AccessEvent>& events) const {
        for (const Bracket& bracket : samples_.jumps) {
            if (bracket.drop_mm2() <= tol_.area_mm2) continue;
            const Region before = centresFor(ground_, bracket.low.diameter_mm / 2);
            const Region after = centresFor(ground_, bracket.high.diameter_mm / 2);
            for (const Region& room : components(before)) {
                const bool lives_on = std::any_of(after.loops.begin(), after.loops.end(), [&](const Loop& l) {
                    return contains(room, l.start) || distanceToBoundary(room, l.start) < tol_.linear_mm;
                });
                if (lives_on) continue;
                const Box2 box = boundingBox(room);
                const Vec2 middle = (box.min() + box.max()) / 2;
                const double diameter_mm = exactDiameter(bracket, middle);
                if (!betweenWalls(events, bracket, room))
                    addPlace(events, AccessEventKind::Vanishes, diameter_mm, middle, bracket);
            }
        }
    }

    /// A slot between parallel walls that vanishes as a whole is a neck and is named as such.
    bool betweenWalls(const std::vector<AccessEvent>& events, const Bracket& bracket,
                      const Region& room) const {
        return std::any_of(events.begin(), events.end(), [&](const AccessEvent& event) {
            return event.kind == AccessEventKind::Neck &&
                   event.diameter_mm > bracket.low.diameter_mm - tol_.linear_mm &&
                   event.diameter_mm < bracket.high.diameter_mm + tol_.linear_mm &&
                   std::any_of(event.at.begin(), event.at.end(), [&](const Vec2& at) {
                       return contains(room, at) || distanceToBoundary(room, at) < 2 * tol_.linear_mm;
                   });
        });
    }

    /// Twice the clearance where the room vanishes, when that lies in the bracket or so little above it that
    /// rounding took the last centre; else the bracket's middle.
    double exactDiameter(const Bracket& bracket, const Vec2& at) const {
        const double diameter_mm = 2 * walls_.clearance(at);
        const bool inside = diameter_mm >= bracket.low.diameter_mm &&
                            diameter_mm <= bracket.high.diameter_mm + tol_.linear_mm;
        return inside ? diameter_mm : (bracket.low.diameter_mm + bracket.high.diameter_mm) / 2;
    }

    void addPlace(std::vector<AccessEvent>& events, AccessEventKind kind, double diameter_mm, const Vec2& at,
                  const Bracket& bracket) const {
        for (AccessEvent& event : events) {
            if (event.kind != kind || std::abs(event.diameter_mm - diameter_mm) > tol_.linear_mm) continue;
            event.at.push_back(at);
            std::sort(event.at.begin(), event.at.end(), [](const Vec2& a, const Vec2& b) {
                return std::tie(a.y(), a.x()) < std::tie(b.y(), b.x());
            });
            return;
        }
        events.push_back({diameter_mm, kind, {at}, bracket.low.area_mm2, bracket.high.area_mm2});
    }

    const FeatureGround& ground_;
    const Tolerances& tol_;
    access::Walls walls_;
    double max_error_mm2_;
    std::vector<access::Neck> necks_;
    std::vector<Arc> arcs_;
    CurveSamples samples_;
};

template <typename Value>
double interpolated(const std::vector<AccessSample>& samples, double diameter_mm, Value value) {
    const auto after =
        std::upper_bound(samples.begin(), samples.end(), diameter_mm,
                         [](double d, const AccessSample& sample) { return d < sample.diameter_mm; });
    if (after == samples.begin()) return value(samples.front());
    if (after == samples.end()) return value(samples.back());
    const auto before = std::prev(after);
    const double share = (diameter_mm - before->diameter_mm) / (after->diameter_mm - before->diameter_mm);
    return value(*before) + share * (value(*after) - value(*before));
}

}  // namespace

std::string toString(AccessEventKind kind) {
    return wordOf(kAccessEvents, kind);
}

double AccessCurve::areaAt(double diameter_mm) const {
    return interpolated(samples, diameter_mm, [](const AccessSample& s) { return s.area_mm2; });
}

double AccessCurve::volumeAt(double diameter_mm) const {
    return interpolated(samples, diameter_mm, [](const AccessSample& s) { return s.volume_mm3; });
}

AccessCurve accessCurve(const FeatureGround& ground, double from_mm, double to_mm,
                        const AccessCurveOptions& options) {
    STEPMILL_CHECK(0 <= from_mm && from_mm < to_mm, "a range of diameters");
    STEPMILL_CHECK(options.first_steps > 0 && options.max_error_share > 0, "options of a curve");
    return CurveFinder(ground, from_mm, to_mm, options).curve();
}

}  // namespace stepmill
