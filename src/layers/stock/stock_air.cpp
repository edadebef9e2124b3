// What earlier setups cut, seen from a setup.

#include "layers/stock/stock_air.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <span>
#include <utility>

#include "layers/indexed_region.h"
#include "layers/stock/rectangle_union.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill::layers {

namespace {

/// Level walls and ends of cuts this near to an end of a slab lie on it [mm]: levels that near are one.
constexpr double kIntoSlabMm = 1e-3;
/// Heights nearer than this are one [mm]: turned points are rounded to the grid, which tilts level walls.
constexpr double kSameZMm = 10 * kGridMm;

struct Interval {
    double from = 0;
    double to = 0;

    bool operator==(const Interval&) const = default;
};

/// Heights and weights of a quadrature on [0, 1] for sections that begin or end like a circle's: Gauss and
/// Legendre's four points in t with z = (1 - cos pi t) / 2. A half circle's area comes out to 1e-4 of it.
struct Node {
    double at;
    double weight;
};
constexpr std::array<Node, 4> kNodes = {{{0.011847712960255552, 0.059122196510775035},
                                         {0.2454921072521225, 0.4408778034892249},
                                         {0.7545078927478774, 0.440877803489225},
                                         {0.9881522870397446, 0.059122196510774994}}};

/// Gauss' two points, for sections of cuts askew to the axis: they begin and end at corners.
constexpr std::array<Node, 2> kAskewNodes = {{{0.21132486540518713, 0.5}, {0.7886751345948129, 0.5}}};

/// Cuts askew to the axis that are less than this share of all there is to remove count as uncut: each costs
/// a union a slab.
constexpr double kAskewShare = 3e-5;

/// Loops of a region, moved by an isometry of the plane.
template <typename Move>
Region moved(const Region& region, bool mirrors, const Move& move) {
    Region result;
    for (const Loop& loop : region.loops) {
        Loop copy;
        copy.start = snapToGrid(move(loop.start));
        for (Segment segment : loop.segments) {
            segment.to = snapToGrid(move(segment.to));
            if (segment.arc) {
                segment.arc->centre = snapToGrid(move(segment.arc->centre));
                segment.arc->ccw = segment.arc->ccw != mirrors;
            }
            copy.segments.push_back(std::move(segment));
        }
        // A mirrored loop runs the other way round.
        result.loops.push_back(mirrors ? reversed(copy) : std::move(copy));
    }
    return result;
}

/// The prisms cut at all their heights: what is gone between each two neighbouring ones.
std::vector<Prism> betweenHeights(const std::vector<Prism>& prisms, const Tolerances& tol) {
    std::set<double> heights;
    for (const Prism& prism : prisms)
        heights.insert({prism.top_z_mm, prism.bottom_z_mm});
    std::vector<Prism> found;
    for (auto low = heights.begin(); low != heights.end() && std::next(low) != heights.end(); ++low) {
        const double high = *std::next(low);
        if (high - *low < kSameZMm) continue;
        const double middle = (*low + high) / 2;
        std::vector<Region> gone;
        for (const Prism& prism : prisms)
            if (prism.bottom_z_mm < middle && middle < prism.top_z_mm) gone.push_back(prism.region);
        if (!gone.empty()) found.push_back({unite(gone, tol), high, *low});
    }
    return found;
}

bool isLevel(const MonotonePiece& piece) {
    return piece.high() - piece.low() < kSameZMm;
}

/// The heights of a slab, for what lies on its ends to within rounding.
struct Slab {
    double low_mm;
    double high_mm;
    double margin_mm;

    Slab(double bottom_mm, double top_mm)
        : low_mm(bottom_mm + std::min(kSameZMm, (top_mm - bottom_mm) / 4)),
          high_mm(top_mm - std::min(kSameZMm, (top_mm - bottom_mm) / 4)),
          margin_mm(std::min(kIntoSlabMm, (top_mm - bottom_mm) / 4)) {}

    bool holds(const MonotonePiece& piece) const {
        const double margin = isLevel(piece) ? margin_mm : 0;
        return piece.low() < high_mm - margin && piece.high() > low_mm + margin;
    }
    bool isSpannedBy(const Prism& prism) const {
        return prism.bottom_z_mm <= low_mm + margin_mm && high_mm - margin_mm <= prism.top_z_mm;
    }
    bool isMetBy(const Prism& prism) const {
        return prism.bottom_z_mm < high_mm - margin_mm && prism.top_z_mm > low_mm + margin_mm;
    }
    bool holdsEndOf(const Prism& prism) const { return isMetBy(prism) && !isSpannedBy(prism); }
};

/// The intervals as one sequence that do not overlap.
/// \pre sorted by where they begin
std::vector<Interval> merged(const std::vector<Interval>& intervals) {
    std::vector<Interval> all;
    for (const Interval& interval : intervals) {
        if (all.empty() || interval.from > all.back().to)
            all.push_back(interval);
        else
            all.back().to = std::max(all.back().to, interval.to);
    }
    return all;
}

/// Where the vertical line through x lies inside the outline: all the way between the heights, or, not less
/// than that, somewhere on it. Who is inside elsewhere than half-way up has a wall of the slab between.
std::vector<Interval> intervalsIn(const LyingCut& cut, const Slab& slab, AtHeights which) {
    const double low = slab.low_mm;
    const double high = slab.high_mm;
    if (cut.low_mm >= high || cut.high_mm <= low) return {};
    const double middle = (low + high) / 2;
    std::vector<double> crossings;
    std::vector<Interval> walls;
    for (const MonotonePiece& piece : cut.outline) {
        if ((piece.from.y() > middle) != (piece.to.y() > middle)) crossings.push_back(piece.xAt(middle));
        if (!slab.holds(piece)) continue;
        const bool level = isLevel(piece);
        const double one = level ? piece.from.x() : piece.xAt(std::max(low, piece.low()));
        const double other = level ? piece.to.x() : piece.xAt(std::min(high, piece.high()));
        if (one != other) walls.push_back({std::min(one, other), std::max(one, other)});
    }
    std::sort(crossings.begin(), crossings.end());
    if (which == AtHeights::Some)
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            walls.push_back({crossings[i], crossings[i + 1]});
    std::sort(walls.begin(), walls.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
    if (which == AtHeights::Some) return merged(walls);
    std::vector<Interval> clear;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        double from = crossings[i];
        for (const Interval& wall : walls) {
            if (wall.to <= from || wall.from >= crossings[i + 1]) continue;
            if (wall.from > from) clear.push_back({from, wall.from});
            from = wall.to;
        }
        if (from < crossings[i + 1]) clear.push_back({from, crossings[i + 1]});
    }
    return clear;
}

}  // namespace

std::vector<Vec2> LyingCut::box(double place_from, double place_to, double reach_to) const {
    const auto corner = [&](double place, double reach) {
        return Vec2(origin + place * along + reach * sweep);
    };
    std::vector<Vec2> corners = {corner(place_from, from_mm), corner(place_to, from_mm),
                                 corner(place_to, reach_to), corner(place_from, reach_to)};
    if (along.x() * sweep.y() < along.y() * sweep.x()) std::reverse(corners.begin(), corners.end());
    return corners;
}

bool LyingCut::alongAxes() const {
    // Turned by less the far end of the longest box stays on its grid point.
    constexpr double kNotTurned = 1e-12;
    return std::min(std::abs(along.x()), std::abs(along.y())) < kNotTurned &&
           std::min(std::abs(sweep.x()), std::abs(sweep.y())) < kNotTurned;
}

StockAir::StockAir(const Setup& setup, double least_level_mm3, const Tolerances& tol)
    : tol_(tol), least_level_mm3_(least_level_mm3) {
    for (const CutPrisms& cut : setup.stock.cuts)
        add(cut, setup);
    for (const Prism& prism : upright_) {
        bends_.insert(bends_.end(), {prism.top_z_mm, prism.bottom_z_mm});
        if (prism.volume_mm3() >= least_level_mm3_)
            planes_.insert(planes_.end(), {prism.top_z_mm, prism.bottom_z_mm});
    }
    for (const AskewCut& askew : askew_)
        bends_.insert(bends_.end(), {askew.low_mm(), askew.high_mm()});
    std::sort(planes_.begin(), planes_.end());
    std::sort(bends_.begin(), bends_.end());
}

void StockAir::add(const CutPrisms& cut, const Setup& setup) {
    const Eigen::Isometry3d to_setup = setup.part_to_setup * cut.part_to_setup.inverse();
    const double cosine = to_setup.linear()(2, 2);
    if (std::abs(cosine) < tol_.angular_rad) return addLying(cut, to_setup);
    if (1 - std::abs(cosine) > tol_.angular_rad * tol_.angular_rad) {
        for (const Prism& prism : betweenHeights(cut.prisms, tol_))
            if (prism.volume_mm3() >= kAskewShare * setup.removable_mm3) {
                AskewCut askew(prism, to_setup);
                if (!askew.empty()) askew_.push_back(std::move(askew));
            }
        return;
    }
    for (const Prism& prism : cut.prisms) {
        const double one = (to_setup * Vec3(0, 0, prism.top_z_mm)).z();
        const double other = (to_setup * Vec3(0, 0, prism.bottom_z_mm)).z();
        const auto move = [&](const Vec2& p) { return Vec2((to_setup * Vec3(p.x(), p.y(), 0)).head<2>()); };
        upright_.push_back(
            {moved(prism.region, cosine < 0, move), std::max(one, other), std::min(one, other)});
    }
}

void StockAir::addLying(const CutPrisms& cut, const Eigen::Isometry3d& to_setup) {
    // In the cut's own plane: up here, and along the slab.
    const Vec2 up = Vec2(to_setup.linear().row(2).head<2>()).normalized();
    const Vec2 level(up.y(), -up.x());
    const double raised = to_setup.translation().z();
    const auto seen = [&](const Vec2& p) { return Vec2(level.dot(p), up.dot(p) + raised); };
    const int number = lying_.empty() ? 0 : lying_.back().cut + 1;
    for (const Prism& prism : betweenHeights(cut.prisms, tol_)) {
        LyingCut lying;
        lying.cut = number;
        lying.origin = to_setup.translation().head<2>();
        lying.along = (to_setup.linear() * Vec3(level.x(), level.y(), 0)).head<2>();
        lying.sweep = to_setup.linear().col(2).head<2>();
        lying.from_mm = prism.bottom_z_mm;
        lying.to_mm = prism.top_z_mm;
        for (const Loop& loop : moved(prism.region, false, seen).loops) {
            const std::size_t first = lying.outline.size();
            for (const auto& [from, segment] : eachEdge(loop))
                addPieces(from, segment, lying.outline);
            const bool parts_slabs =
                std::abs(signedArea(loop)) * (lying.to_mm - lying.from_mm) >= least_level_mm3_;
            addHeights({lying.outline.begin() + static_cast<std::ptrdiff_t>(first), lying.outline.end()},
                       parts_slabs, lying);
        }
        lying_.push_back(std::move(lying));
    }
}

void StockAir::addHeights(const std::vector<MonotonePiece>& loop, bool parts_slabs, LyingCut& lying) {
    double low_mm = 1e300;
    double high_mm = -1e300;
    for (const MonotonePiece& piece : loop) {
        low_mm = std::min(low_mm, piece.low());
        high_mm = std::max(high_mm, piece.high());
        bends_.push_back(piece.from.y());
        if (parts_slabs && !piece.arc && isLevel(piece)) planes_.push_back(piece.from.y());
    }
    if (parts_slabs) planes_.insert(planes_.end(), {low_mm, high_mm});
    bends_.insert(bends_.end(), {low_mm, high_mm});
    lying.low_mm = std::min(lying.low_mm, low_mm);
    lying.high_mm = std::max(lying.high_mm, high_mm);
}

double StockAir::bendNearMiddle(double bottom_mm, double top_mm) const {
    const double middle = (bottom_mm + top_mm) / 2;
    double best = middle;
    double nearest = (top_mm - bottom_mm) / 4;
    for (const double bend : bends_) {
        if (std::abs(bend - middle) >= nearest) continue;
        nearest = std::abs(bend - middle);
        best = bend;
    }
    return best;
}

AirParts StockAir::partsBetween(double bottom_mm, double top_mm, AtHeights which) const {
    const Slab slab(bottom_mm, top_mm);
    AirParts air;
    for (std::size_t i = 0; i < upright_.size(); ++i) {
        const bool there =
            which == AtHeights::All ? slab.isSpannedBy(upright_[i]) : slab.isMetBy(upright_[i]);
        if (there) air.upright.push_back(static_cast<int>(i));
    }
    addLyingBoxes(bottom_mm, top_mm, which, air);
    return air;
}

Region StockAir::uprightUnion(const std::vector<int>& numbers) const {
    if (numbers.empty()) return {};
    {
        const std::lock_guard lock(unions_->mutex);
        const auto known = unions_->by_numbers.find(numbers);
        if (known != unions_->by_numbers.end()) return known->second;
    }
    std::vector<Region> regions;
    for (const int number : numbers)
        regions.push_back(upright_[static_cast<std::size_t>(number)].region);
    Region all = unite(regions, tol_);
    const std::lock_guard lock(unions_->mutex);
    return unions_->by_numbers.emplace(numbers, std::move(all)).first->second;
}

/// What upright prisms have cut at all heights of the slab that end within it: one goes on where another
/// ends.
Region StockAir::stackedUnion(double bottom_mm, double top_mm) const {
    const Slab slab(bottom_mm, top_mm);
    std::vector<int> ending;
    std::set<double> heights{bottom_mm, top_mm};
    for (std::size_t i = 0; i < upright_.size(); ++i) {
        const Prism& prism = upright_[i];
        if (!slab.holdsEndOf(prism)) continue;
        ending.push_back(static_cast<int>(i));
        heights.insert({std::max(bottom_mm, prism.bottom_z_mm), std::min(top_mm, prism.top_z_mm)});
    }
    if (ending.empty()) return {};
    std::optional<Region> stacked;
    for (auto low = heights.begin(); std::next(low) != heights.end(); ++low) {
        const double high_mm = *std::next(low);
        if (high_mm - *low < kSameZMm) continue;
        const Slab between(*low, high_mm);
        std::vector<int> there = ending;
        std::erase_if(there,
                      [&](int i) { return !between.isSpannedBy(upright_[static_cast<std::size_t>(i)]); });
        if (there.empty()) return {};
        const Region here = uprightUnion(there);
        stacked = stacked ? intersect(*stacked, here, tol_) : here;
        if (stacked->empty()) return {};
    }
    return stacked.value_or(Region{});
}

Region StockAir::between(double bottom_mm, double top_mm) const {
    return unite(air(bottom_mm, top_mm, AtHeights::All, std::nullopt), tol_);
}

Region StockAir::subtractedFrom(const Region& ground, double bottom_mm, double top_mm,
                                AtHeights which) const {
    if (ground.empty() || empty()) return ground;
    return subtract(ground, air(bottom_mm, top_mm, which, boundingBox(ground)), tol_);
}

/// As regions that may overlap. Outside of `near`, if it is given, there may be less.
std::vector<Region> StockAir::air(double bottom_mm, double top_mm, AtHeights which,
                                  const std::optional<Box2>& near) const {
    AirParts parts = partsBetween(bottom_mm, top_mm, which);
    if (near) {
        std::erase_if(parts.boxes, [&](const Box2& box) { return !box.intersects(*near); });
        std::erase_if(parts.turned,
                      [&](const Region& turned) { return !boundingBox(turned).intersects(*near); });
    }
    std::vector<Region> air = std::move(parts.turned);
    air.push_back(uprightUnion(parts.upright));
    if (which == AtHeights::All) air.push_back(stackedUnion(bottom_mm, top_mm));
    air.push_back(RectangleUnion(parts.boxes, tol_.linear_mm).outline());
    const Slab slab(bottom_mm, top_mm);
    for (const AskewCut& cut : askew_) {
        if (which == AtHeights::All) {
            air.push_back(cut.between(slab.low_mm, slab.high_mm, tol_, near));
            continue;
        }
        std::vector<Region> some = cut.somewhere(slab.low_mm, slab.high_mm, near);
        std::move(some.begin(), some.end(), std::back_inserter(air));
    }
    return air;
}

void StockAir::addLyingBoxes(double bottom_mm, double top_mm, AtHeights which, AirParts& air) const {
    /// A box that may go on through the next cut.
    struct Run {
        const LyingCut* lying = nullptr;
        Interval place;
        double to_mm = 0;
    };
    std::vector<Run> runs;
    const auto finish = [&](const std::vector<Run>& done) {
        for (const Run& run : done) {
            const std::vector<Vec2> corners = run.lying->box(run.place.from, run.place.to, run.to_mm);
            if (run.lying->alongAxes())
                air.boxes.emplace_back(corners[0].cwiseMin(corners[2]), corners[0].cwiseMax(corners[2]));
            else
                air.turned.push_back(makePolygon(corners));
        }
    };
    const Slab slab(bottom_mm, top_mm);
    for (const LyingCut& lying : lying_) {
        std::vector<Run> going_on;
        for (const Interval& place : intervalsIn(lying, slab, which)) {
            if (place.to - place.from <= tol_.linear_mm) continue;
            const auto same = std::find_if(runs.begin(), runs.end(), [&](const Run& run) {
                return run.lying->cut == lying.cut && run.place == place &&
                       std::abs(run.to_mm - lying.from_mm) < kSameZMm;
            });
            if (same == runs.end()) {
                going_on.push_back({&lying, place, lying.to_mm});
            } else {
                going_on.push_back({same->lying, place, lying.to_mm});
                runs.erase(same);
            }
        }
        finish(runs);
        runs = std::move(going_on);
    }
    finish(runs);
}

bool StockAir::isUpright(double bottom_mm, double top_mm) const {
    const Slab slab(bottom_mm, top_mm);
    const auto ends = [&](const Prism& prism) { return slab.holdsEndOf(prism); };
    const auto leans = [&](const MonotonePiece& piece) {
        return piece.from.x() != piece.to.x() && slab.holds(piece);
    };
    const auto askew = [&](const AskewCut& cut) {
        return cut.low_mm() < slab.high_mm && cut.high_mm() > slab.low_mm;
    };
    return std::none_of(askew_.begin(), askew_.end(), askew) &&
           std::none_of(upright_.begin(), upright_.end(), ends) &&
           std::none_of(lying_.begin(), lying_.end(), [&](const LyingCut& lying) {
               return std::any_of(lying.outline.begin(), lying.outline.end(), leans);
           });
}

/// Areas of air over one region.
class StockAir::Meter {
  public:
    Meter(const StockAir& air, const Region& over)
        : air_(air), over_(over), over_mm2_(area(over)), rest_(over), rest_mm2_(over_mm2_) {}

    /// Of what is air at all heights between, lying and upright cuts only [mm2].
    double between(double bottom_mm, double top_mm) {
        return areaOf(air_.partsBetween(bottom_mm, top_mm), {});
    }
    double at(double z_mm) {
        std::vector<BandedPolygon> askew;
        for (const AskewCut& cut : air_.askew_)
            if (cut.low_mm() < z_mm && z_mm < cut.high_mm()) askew.push_back(cut.at(z_mm));
        return areaOf(air_.partsBetween(z_mm, z_mm), std::move(askew));
    }

  private:
    double areaOf(const AirParts& parts, std::vector<BandedPolygon> polygons) {
        leaveOut(parts.upright);
        const std::vector<Box2> boxes = RectangleUnion(parts.boxes, air_.tol_.linear_mm).apart();
        double area_mm2 = over_mm2_ - rest_mm2_;
        if (polygons.empty() && parts.turned.empty()) {
            for (const Box2& box : boxes)
                area_mm2 += rest_.areaIn(box);
            return area_mm2;
        }
        for (const Box2& box : boxes)
            polygons.push_back(banded(box));
        for (const Region& turned : parts.turned)
            polygons.push_back(banded(turned));
        return area_mm2 + scannedArea(rest_, polygons);
    }
    /// Upright prisms span many heights: what they leave of the region is cut once.
    void leaveOut(const std::vector<int>& upright) {
        if (upright == left_out_) return;
        const Region rest = subtract(over_, air_.uprightUnion(upright), air_.tol_);
        left_out_ = upright;
        rest_mm2_ = area(rest);
        rest_ = IndexedRegion(rest);
    }

    const StockAir& air_;
    const Region& over_;
    double over_mm2_;
    std::vector<int> left_out_;
    IndexedRegion rest_;
    double rest_mm2_;
};

double StockAir::areaIn(const Region& over, double z_mm) const {
    return over.empty() || empty() ? 0 : Meter(*this, over).at(z_mm);
}

double StockAir::volumeIn(const Region& over, double bottom_mm, double top_mm, int most_stretches) const {
    if (over.empty() || empty()) return 0;
    std::vector<double> ends{bottom_mm};
    const double apart = std::max(kIntoSlabMm, (top_mm - bottom_mm) / most_stretches);
    for (auto bend = std::upper_bound(bends_.begin(), bends_.end(), bottom_mm);
         bend != bends_.end() && *bend < top_mm - apart; ++bend)
        if (*bend > ends.back() + apart) ends.push_back(*bend);
    ends.push_back(top_mm);
    Meter meter(*this, over);
    double volume_mm3 = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double height = ends[i + 1] - ends[i];
        if (isUpright(ends[i], ends[i + 1])) {
            volume_mm3 += meter.between(ends[i], ends[i + 1]) * height;
            continue;
        }
        const std::span<const Node> nodes =
            askew_.empty() ? std::span<const Node>(kNodes) : std::span<const Node>(kAskewNodes);
        for (const Node& node : nodes)
            volume_mm3 += node.weight * height * meter.at(ends[i] + node.at * height);
    }
    return volume_mm3;
}

}  // namespace stepmill::layers
