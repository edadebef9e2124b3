#include "planar/clearance_diagram_sites.h"

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill::clearance {

namespace {

// Region half-extent in grid units; leaves room in 32-bit integers.
constexpr double kRegionLimit = 1.9e9;
constexpr int kMinChordsPerCircle = 16;
constexpr double kMinChordUnits = 8;
// Shorter edges are rounding; what follows starts where they start.
constexpr double kNoEdge_mm = 4e-6;
// Graded chords at a slight kink must be long enough for the grid to keep their direction.
constexpr double kMinGradedChordMm = 1e-3;
constexpr double kLargestGradedKinkRad = 0.2;

struct Edge {
    Vec2 from, to;
    std::optional<Arc> arc;
    bool full = false;
};

bool continues(const Edge& a, const Edge& b) {
    if (a.full || b.full || a.arc.has_value() != b.arc.has_value()) return false;
    if (a.arc) return *a.arc == *b.arc;
    const Vec2 u = a.to - a.from, v = b.to - b.from;
    constexpr double kStraight_mm = 1e-12;
    return u.dot(v) > 0 && std::abs(cross(u, v)) <= kStraight_mm * std::max(u.norm(), v.norm());
}

double ccwAngle(double from, double to) {
    double sweep = std::fmod(to - from, 2 * kPi);
    return sweep < 0 ? sweep + 2 * kPi : sweep;
}

bool nearlyFull(const Vec2& from, const Segment& s) {
    return s.arc && std::abs(sweepAngle(from, s.to, *s.arc)) > kPi;
}

double angleOf(const Vec2& v) {
    return std::atan2(v.y(), v.x());
}

/// The loop's edges with pieces of one line or circle joined and zero-length ones dropped.
std::vector<Edge> mergedEdges(const Loop& loop) {
    std::vector<Edge> raw;
    Vec2 at = loop.start;
    for (const Segment& s : loop.segments) {
        const bool full = s.arc && s.to == at;
        if (!full && (s.to - at).norm() <= kNoEdge_mm && !nearlyFull(at, s)) continue;
        raw.push_back({at, s.to, s.arc, full});
        at = s.to;
    }
    if (!raw.empty() && at != loop.start) raw.back().to = raw.front().from;
    const std::size_t n = raw.size();
    if (n == 0) return {};
    std::size_t first = 0;
    while (first < n && continues(raw[(first + n - 1) % n], raw[first]))
        ++first;
    if (first == n) {
        if (!raw[0].arc) return {};
        return {{raw[0].from, raw[0].from, raw[0].arc, true}};
    }
    std::vector<Edge> merged;
    for (std::size_t k = 0; k < n; ++k) {
        const Edge& e = raw[(first + k) % n];
        if (!merged.empty() && continues(merged.back(), e))
            merged.back().to = e.to;
        else
            merged.push_back(e);
    }
    return merged;
}

Vec2 tangentOf(const Site& site, const Vec2& at) {
    if (site.kind == SiteKind::Line) return site.dir;
    const Vec2 radial = (at - site.centre).normalized();
    return site.ccw ? leftNormal(radial) : Vec2(-leftNormal(radial));
}

class Tessellator {
  public:
    Tessellator(SiteSet& set, double chord_mm) : set_(set), chord_mm_(chord_mm) {}

    void addLoop(const Loop& loop);

  private:
    using Cell = std::pair<std::int32_t, std::int32_t>;

    Cell cell(const Vec2& p) const {
        const Vec2 q = (p - set_.origin) / set_.unit_mm;
        return {static_cast<std::int32_t>(std::lround(q.x())), static_cast<std::int32_t>(std::lround(q.y()))};
    }
    double stepAngle(double radius) const;
    double gradedKink(int joint) const;
    std::vector<Vec2> arcPoints(const Site& site) const;
    void addChords(int site);
    void addChain(int site, const std::vector<Vec2>& points, int start_site, int end_site);
    int pointSite(int joint) const;
    void makeJoints(int first, int count);

    SiteSet& set_;
    double chord_mm_;
};

double Tessellator::stepAngle(double radius) const {
    const double half = std::acos(std::max(0.0, 1 - chord_mm_ / radius));
    const double count = std::max<double>(kMinChordsPerCircle, std::ceil(kPi / half));
    // A multiple of four puts vertices at the axis points, where symmetric shapes tie exactly.
    double n = 4 * std::ceil(count / 4);
    n = std::min(n, std::max(4.0, 4 * std::floor(2 * kPi * radius / (4 * kMinChordUnits * set_.unit_mm))));
    return 2 * kPi / n;
}

/// The kink angle when the chords at this joint must follow the arc's true tangent, else 0.
double Tessellator::gradedKink(int joint) const {
    if (joint < 0) return 0;
    const Joint& j = set_.joints[static_cast<std::size_t>(joint)];
    if (j.corner < 0) return 0;
    const double kink =
        std::abs(std::atan2(cross(j.tangent_in, j.tangent_out), j.tangent_in.dot(j.tangent_out)));
    return kink < kLargestGradedKinkRad ? kink : 0;
}

std::vector<Vec2> Tessellator::arcPoints(const Site& site) const {
    const double step = stepAngle(site.radius);
    const auto at = [&](double angle) {
        return Vec2(site.centre + site.radius * Vec2(std::cos(angle), std::sin(angle)));
    };
    std::vector<Vec2> points;
    if (site.full) {
        const int n = static_cast<int>(std::lround(2 * kPi / step));
        for (int k = 0; k <= n; ++k)
            points.push_back(at(step * (k % n)));
        if (!site.ccw) std::reverse(points.begin(), points.end());
        return points;
    }
    const Vec2 low = site.ccw ? site.start : site.end, high = site.ccw ? site.end : site.start;
    const int low_joint = site.ccw ? site.start_joint : site.end_joint;
    const int high_joint = site.ccw ? site.end_joint : site.start_joint;
    const double a0 = angleOf(low - site.centre);
    const double a1 = a0 + ccwAngle(a0, angleOf(high - site.centre));
    std::vector<double> angles;
    // Vertices on the global angle grid, but none close to an end point.
    constexpr double kNearEnd = 0.25;
    for (double k = std::ceil(a0 / step); k * step < a1; ++k)
        if (k * step > a0 + kNearEnd * step && k * step < a1 - kNearEnd * step) angles.push_back(k * step);
    if (angles.empty() && a1 - a0 > kNearEnd * step) angles.push_back((a0 + a1) / 2);
    const auto grade = [&](double from, double sign, double kink) {
        constexpr double kGrowth = 3;
        double offset = kink / 2;
        const double room = std::min(step, (a1 - a0) / 2);
        if (kink == 0 || offset * site.radius < kMinGradedChordMm) return;
        for (; offset < room; offset *= kGrowth)
            angles.push_back(from + sign * offset);
    };
    grade(a0, 1, gradedKink(low_joint));
    grade(a1, -1, gradedKink(high_joint));
    std::sort(angles.begin(), angles.end());
    points.push_back(low);
    for (double angle : angles)
        points.push_back(at(angle));
    points.push_back(high);
    if (!site.ccw) std::reverse(points.begin(), points.end());
    return points;
}

/// The site that the joint's point belongs to: its corner, or an arc that goes through it tangentially.
int Tessellator::pointSite(int joint) const {
    const Joint& j = set_.joints[static_cast<std::size_t>(joint)];
    if (j.corner >= 0) return j.corner;
    return set_.sites[static_cast<std::size_t>(j.in)].kind == SiteKind::Arc ? j.in : j.out;
}

void Tessellator::addChain(int site, const std::vector<Vec2>& points, int start_site, int end_site) {
    Cell last = cell(points.front());
    int last_site = start_site;
    for (std::size_t k = 1; k < points.size(); ++k) {
        const Cell next = cell(points[k]);
        const bool at_end = k + 1 == points.size();
        if (next == last) continue;
        const int next_site = at_end ? end_site : site;
        set_.chords.push_back({last.first, last.second, next.first, next.second, site, last_site, next_site});
        last = next;
        last_site = next_site;
    }
}

void Tessellator::addChords(int index) {
    const Site& site = set_.sites[static_cast<std::size_t>(index)];
    const int first = site.full ? index : pointSite(site.start_joint);
    const int last = site.full ? index : pointSite(site.end_joint);
    addChain(index, site.kind == SiteKind::Line ? std::vector<Vec2>{site.start, site.end} : arcPoints(site),
             first, last);
}

void Tessellator::makeJoints(int first, int count) {
    for (int k = 0; k < count; ++k) {
        const int in = first + k, out = first + (k + 1) % count;
        Joint joint;
        joint.point = set_.sites[static_cast<std::size_t>(in)].end;
        joint.tangent_in = tangentOf(set_.sites[static_cast<std::size_t>(in)], joint.point);
        joint.tangent_out = tangentOf(set_.sites[static_cast<std::size_t>(out)], joint.point);
        joint.in = in;
        joint.out = out;
        const double kink = std::abs(
            std::atan2(cross(joint.tangent_in, joint.tangent_out), joint.tangent_in.dot(joint.tangent_out)));
        const bool lines = set_.sites[static_cast<std::size_t>(in)].kind == SiteKind::Line &&
                           set_.sites[static_cast<std::size_t>(out)].kind == SiteKind::Line;
        if (lines || kink > kSmoothKinkRad) {
            joint.corner = static_cast<int>(set_.sites.size());
            Site corner;
            corner.kind = SiteKind::Corner;
            corner.start = corner.end = corner.centre = joint.point;
            corner.start_joint = corner.end_joint = static_cast<int>(set_.joints.size());
            set_.sites.push_back(corner);
        }
        set_.sites[static_cast<std::size_t>(in)].end_joint = static_cast<int>(set_.joints.size());
        set_.sites[static_cast<std::size_t>(out)].start_joint = static_cast<int>(set_.joints.size());
        set_.joints.push_back(joint);
    }
}

void Tessellator::addLoop(const Loop& loop) {
    const std::vector<Edge> edges = mergedEdges(loop);
    const int first = static_cast<int>(set_.sites.size());
    for (const Edge& e : edges) {
        Site site;
        site.kind = e.arc ? SiteKind::Arc : SiteKind::Line;
        site.start = e.from;
        site.end = e.to;
        site.full = e.full;
        if (e.arc) {
            site.centre = e.arc->centre;
            site.radius = e.arc->radius_mm;
            site.ccw = e.arc->ccw;
        } else {
            site.dir = (e.to - e.from).normalized();
        }
        set_.sites.push_back(site);
    }
    const int count = static_cast<int>(edges.size());
    if (count == 0) return;
    if (!edges[0].full) makeJoints(first, count);
    for (int k = 0; k < count; ++k)
        addChords(first + k);
}

}  // namespace

SiteSet makeSites(const Region& region, double chord_mm) {
    SiteSet set;
    const Box2 box = boundingBox(region);
    set.origin = snapToGrid(Vec2((box.min + box.max) / 2));
    const double extent = (box.size() / 2).maxCoeff() + 1e-3;
    constexpr double kUnitGrowth = 4;
    while (extent > kRegionLimit * set.unit_mm)
        set.unit_mm *= kUnitGrowth;
    Tessellator tessellator(set, chord_mm);
    for (const Loop& loop : region.loops)
        tessellator.addLoop(loop);
    separateChords(set);
    return set;
}

}  // namespace stepmill::clearance
