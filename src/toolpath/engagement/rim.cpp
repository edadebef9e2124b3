// Which part of a cutter's rim stands in material, from where it meets the edges around.

#include "toolpath/engagement/rim.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/units.h"

namespace stepmill::toolpath {
namespace {

constexpr double kHalfFront = kPi / 2;
/// Shorter spans are rounding [rad].
constexpr double kLeastSpanRad = 1e-9;
/// A span is asked for at this share of it: in its middle a boundary may touch the rim.
constexpr double kAskedShare = 0.37;
/// Just inside and just outside the rim: a boundary that runs along it has material on neither side of it, as
/// far as the cutter goes [mm].
constexpr double kBesideMm = 1e-5;

double widthOf(double from_rad, double to_rad) {
    return std::sin(to_rad) - std::sin(from_rad);
}

}  // namespace

Rim::Rim(const Vec2& centre, const Vec2& along, double radius_mm)
    : centre_(centre), along_(along), radius_mm_(radius_mm) {}

Vec2 Rim::at(double angle_rad) const {
    return at(angle_rad, radius_mm_);
}

Vec2 Rim::at(double angle_rad, double radius_mm) const {
    return centre_ + radius_mm * (std::cos(angle_rad) * along_ + std::sin(angle_rad) * leftOf(along_));
}

double Rim::angleOf(const Vec2& direction) const {
    return turnRad(along_, direction);
}

void Rim::addAngle(double angle_rad, std::vector<double>& into) const {
    if (angle_rad > kPi) angle_rad -= 2 * kPi;
    if (angle_rad < -kPi) angle_rad += 2 * kPi;
    if (std::abs(angle_rad) < kHalfFront) into.push_back(angle_rad);
}

void Rim::meetCircle(const Vec2& centre, double radius_mm, std::vector<double>& into) const {
    const Vec2 off = centre - centre_;
    const double distance_mm = off.norm();
    const double twice = 2 * radius_mm_ * distance_mm;
    const double above = radius_mm_ * radius_mm_ + distance_mm * distance_mm - radius_mm * radius_mm;
    if (std::abs(above) >= twice) return;
    const double middle = angleOf(off);
    const double half = std::acos(above / twice);
    addAngle(middle - half, into);
    addAngle(middle + half, into);
}

void Rim::meetLine(const Vec2& p, const Vec2& along, std::vector<double>& into) const {
    const Vec2 normal = leftOf(along);
    const double height_mm = normal.dot(p - centre_);
    if (std::abs(height_mm) >= radius_mm_) return;
    const double middle = angleOf(normal);
    const double half = std::acos(height_mm / radius_mm_);
    addAngle(middle - half, into);
    addAngle(middle + half, into);
}

void Rim::meetEdge(const Edge& edge, std::vector<double>& into) const {
    if (const std::optional<Arc>& arc = edge.segment.arc)
        meetCircle(arc->centre, arc->radius_mm, into);
    else if (edge.to() != edge.from)
        meetLine(edge.from, (edge.to() - edge.from).normalized(), into);
}

void Rim::cover(const Edge& swept, double reach_mm) {
    if (distanceTo(centre_, swept) >= radius_mm_ + reach_mm) return;
    settled_ = false;
    angles_ = {-kHalfFront, kHalfFront};
    meetCircle(swept.from, reach_mm, angles_);
    if (const std::optional<Arc>& arc = swept.segment.arc) {
        meetCircle(swept.to(), reach_mm, angles_);
        meetCircle(arc->centre, arc->radius_mm + reach_mm, angles_);
        if (arc->radius_mm > reach_mm) meetCircle(arc->centre, arc->radius_mm - reach_mm, angles_);
        meetLine(arc->centre, (swept.from - arc->centre).normalized(), angles_);
        meetLine(arc->centre, (swept.to() - arc->centre).normalized(), angles_);
    } else if (swept.to() != swept.from) {
        const Vec2 along = (swept.to() - swept.from).normalized();
        const Vec2 left = leftOf(along);
        meetCircle(swept.to(), reach_mm, angles_);
        meetLine(swept.from + reach_mm * left, along, angles_);
        meetLine(swept.from - reach_mm * left, along, angles_);
        meetLine(swept.from, left, angles_);
        meetLine(swept.to(), left, angles_);
    }
    std::sort(angles_.begin(), angles_.end());
    for (std::size_t i = 1; i < angles_.size(); ++i) {
        const double from = angles_[i - 1];
        const double to = angles_[i];
        if (to - from > kLeastSpanRad && distanceTo(at((from + to) / 2), swept) <= reach_mm)
            covered_.push_back({from, to});
    }
}

/// Turns what is covered into what is free.
void Rim::settle() {
    if (settled_) return;
    settled_ = true;
    std::sort(covered_.begin(), covered_.end(),
              [](const Span& a, const Span& b) { return a.from_rad < b.from_rad; });
    free_.clear();
    double done = -kHalfFront;
    for (const Span& span : covered_) {
        if (span.from_rad - done > kLeastSpanRad) free_.push_back({done, span.from_rad});
        done = std::max(done, span.to_rad);
    }
    if (kHalfFront - done > kLeastSpanRad) free_.push_back({done, kHalfFront});
}

bool Rim::isCovered() {
    settle();
    return free_.empty();
}

double Rim::freeWidthMm() {
    settle();
    double width = 0;
    for (const Span& span : free_)
        width += widthOf(span.from_rad, span.to_rad);
    return radius_mm_ * width;
}

bool Rim::isInside(const IndexedRegion& region, double angle_rad) const {
    return region.contains(at(angle_rad, radius_mm_ - kBesideMm)) &&
           region.contains(at(angle_rad, radius_mm_ + kBesideMm));
}

Rim::Spans Rim::freeIn(const IndexedRegion& region, const std::vector<const Edge*>& near) {
    settle();
    std::vector<double> crossings;
    const Box2 around = grown(Box2(centre_), radius_mm_);
    for (const Edge* edge : near)
        if (edge->box.intersects(around)) meetEdge(*edge, crossings);
    std::sort(crossings.begin(), crossings.end());
    Spans inside;
    for (const Span& span : free_) {
        double from = span.from_rad;
        const auto take = [&](double to) {
            if (to - from > kLeastSpanRad && isInside(region, from + kAskedShare * (to - from)))
                inside.push_back({from, to});
            from = to;
        };
        for (const double crossing : crossings)
            if (crossing > from && crossing < span.to_rad) take(crossing);
        take(span.to_rad);
    }
    return inside;
}

double Rim::freeWidthInMm(const IndexedRegion& region, const std::vector<const Edge*>& near) {
    double width = 0;
    for (const Span& span : freeIn(region, near))
        width += widthOf(span.from_rad, span.to_rad);
    return radius_mm_ * width;
}

Engaged Rim::engagedIn(const IndexedRegion& region, const std::vector<const Edge*>& near, const Spans& deep) {
    Spans stretches;
    for (const Span& span : freeIn(region, near)) {
        const bool goes_on = !stretches.empty() && stretches.back().to_rad == span.from_rad;
        if (goes_on)
            stretches.back().to_rad = span.to_rad;
        else
            stretches.push_back(span);
    }
    Engaged engaged;
    for (const Span& span : stretches) {
        const bool cuts = std::any_of(deep.begin(), deep.end(), [&](const Span& one) {
            return one.from_rad < span.to_rad && one.to_rad > span.from_rad;
        });
        if (!cuts) continue;
        engaged.width_mm += radius_mm_ * widthOf(span.from_rad, span.to_rad);
        engaged.angle_rad += span.to_rad - span.from_rad;
    }
    return engaged;
}

}  // namespace stepmill::toolpath
