// The arrangement on chords: GEOS rounds it to a grid on which nothing can go wrong any more.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>

#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/PrecisionModel.h>
#include <geos/noding/NodedSegmentString.h>
#include <geos/noding/snapround/SnapRoundingNoder.h>

#include "planar/boolean/arrangement.h"
#include "planar/segment.h"
#include "stepmill/core/units.h"

namespace stepmill::planar {

namespace {

using geos::noding::NodedSegmentString;
using geos::noding::SegmentString;

/// Points along the curve. Those of an arc lie at multiples of one angle about its centre, so that arcs
/// of the same circle have the same chords wherever they start.
std::vector<Vec2> chordsOf(const Curve& curve, double chord_mm) {
    std::vector<Vec2> points{curve.from};
    if (const std::optional<Arc>& arc = curve.segment.arc) {
        const double step = 2 * kPi / stepsForSweep(2 * kPi, arc->radius_mm, chord_mm);
        const double sweep = sweepAngle(curve.from, curve.segment.to, *arc);
        const Vec2 u = curve.from - arc->centre;
        const double begin = std::atan2(u.y(), u.x()) / step;
        const double end = begin + sweep / step;
        const int way = arc->ccw ? 1 : -1;
        // The grid points strictly between both ends.
        const auto first = static_cast<std::int64_t>(arc->ccw ? std::floor(begin) + 1 : std::ceil(begin) - 1);
        for (std::int64_t k = first; way * (end - static_cast<double>(k)) > 0; k += way) {
            const double angle = static_cast<double>(k) * step;
            points.emplace_back(arc->centre + arc->radius_mm * Vec2(std::cos(angle), std::sin(angle)));
        }
    }
    points.push_back(curve.segment.to);
    return points;
}

/// Nodes and pieces from what GEOS' noder hands back.
class ChordNoder {
  public:
    ChordNoder(Arrangement& result, double grid_mm) : result_(result), per_mm_(1 / grid_mm) {}

    void run() {
        const geos::geom::PrecisionModel grid(per_mm_);
        geos::noding::snapround::SnapRoundingNoder noder(&grid);
        std::vector<std::unique_ptr<NodedSegmentString>> strings = chords();
        std::vector<SegmentString*> borrowed;
        borrowed.reserve(strings.size());
        for (const auto& string : strings)
            borrowed.push_back(string.get());
        noder.computeNodes(&borrowed);
        const std::unique_ptr<std::vector<SegmentString*>> noded(noder.getNodedSubstrings());
        std::vector<std::unique_ptr<SegmentString>> owned;
        for (SegmentString* string : *noded)
            owned.emplace_back(string);
        // In the order of the curves, whatever order the noder has them in.
        std::stable_sort(owned.begin(), owned.end(),
                         [&](const auto& a, const auto& b) { return curveOf(*a) < curveOf(*b); });
        for (const auto& string : owned)
            for (std::size_t i = 1; i < string->size(); ++i)
                addChord(string->getCoordinate(i - 1), string->getCoordinate(i), curveOf(*string));
        nameCorners();
    }

  private:
    std::vector<std::unique_ptr<NodedSegmentString>> chords() const {
        std::vector<std::unique_ptr<NodedSegmentString>> strings;
        for (const Curve& curve : result_.curves) {
            std::vector<geos::geom::Coordinate> points;
            for (const Vec2& p : chordsOf(curve, result_.chord_mm))
                points.emplace_back(p.x(), p.y());
            auto* sequence = new geos::geom::CoordinateArraySequence(std::move(points));  // the string's
            strings.push_back(std::make_unique<NodedSegmentString>(sequence, &curve));
        }
        return strings;
    }

    int curveOf(const SegmentString& string) const {
        return static_cast<int>(static_cast<const Curve*>(string.getData()) - result_.curves.data());
    }

    static std::uint64_t key(std::uint64_t a, std::uint64_t b) { return a << 32 ^ (b & 0xFFFFFFFFU); }

    std::uint64_t cell(double x, double y) const {
        return key(static_cast<std::uint64_t>(std::llround(x * per_mm_)),
                   static_cast<std::uint64_t>(std::llround(y * per_mm_)));
    }

    int nodeAt(const geos::geom::Coordinate& c) {
        const auto [found, is_new] = nodes_.emplace(cell(c.x, c.y), static_cast<int>(result_.nodes.size()));
        if (is_new) result_.nodes.emplace_back(c.x, c.y);
        return found->second;
    }

    void addChord(const geos::geom::Coordinate& from, const geos::geom::Coordinate& to, int curve) {
        const int begin = nodeAt(from);
        const int end = nodeAt(to);
        if (begin == end) return;
        const auto ends = key(static_cast<std::uint64_t>(std::min(begin, end)),
                              static_cast<std::uint64_t>(std::max(begin, end)));
        const auto [found, is_new] = pieces_.emplace(ends, result_.pieces.size());
        if (is_new) result_.pieces.push_back({begin, end, curve, true, true, {}, -1});
        Piece& piece = result_.pieces[found->second];
        const auto operand =
            static_cast<std::size_t>(result_.curves[static_cast<std::size_t>(curve)].operand);
        piece.step[operand] += piece.begin == begin ? 1 : -1;
    }

    /// Corners of the operands go back to where they were before they were rounded to the coarse grid.
    void nameCorners() {
        result_.places = result_.nodes;
        std::vector<bool> named(result_.nodes.size(), false);
        for (const Curve& curve : result_.curves) {
            const auto found = nodes_.find(cell(curve.from.x(), curve.from.y()));
            if (found == nodes_.end() || named[static_cast<std::size_t>(found->second)]) continue;
            named[static_cast<std::size_t>(found->second)] = true;
            result_.places[static_cast<std::size_t>(found->second)] = curve.from;
        }
    }

    Arrangement& result_;
    double per_mm_;
    std::unordered_map<std::uint64_t, int> nodes_;
    std::unordered_map<std::uint64_t, std::size_t> pieces_;
};

}  // namespace

Arrangement arrangeOnChords(const std::vector<Curve>& curves, double chord_mm) {
    Arrangement result;
    result.curves = curves;
    result.chord_mm = chord_mm;
    ChordNoder(result, chord_mm).run();
    result.setCancelledApart();
    return result;
}

}  // namespace stepmill::planar
