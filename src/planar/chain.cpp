// Ways that go on from each other as one.

#include "stepmill/planar/chain.h"

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"

namespace stepmill {
namespace {

/// Pieces of an arc are put together up to here: a whole turn ends where it begins, and is none.
constexpr double kLongestArcRad = 1.9 * kPi;

void extend(Path& chain, const Segment& segment) {
    const std::size_t count = chain.segments.size();
    const Vec2 from = count > 1 ? chain.segments[count - 2].to : chain.start;
    if (count > 0 && goesOn(from, chain.segments.back(), segment)) {
        chain.segments.back().to = segment.to;
    } else {
        chain.segments.push_back(segment);
    }
}

}  // namespace

bool goesOn(const Vec2& from, const Segment& first, const Segment& second) {
    if (first.arc != second.arc) return false;
    if (first.arc) {
        return std::abs(sweepAngle(from, first.to, *first.arc)) +
                   std::abs(sweepAngle(first.to, second.to, *second.arc)) <
               kLongestArcRad;
    }
    const Vec2 way = second.to - from;
    return way.dot(first.to - from) > 0 && way.dot(second.to - first.to) > 0 &&
           distanceTo(first.to, makeLine(from, second.to)) <= kGridMm;
}

std::vector<Path> chained(const std::vector<Path>& ways) {
    std::vector<Path> chains;
    for (const Path& way : ways) {
        if (chains.empty() || way.segments.empty() || chains.back().end() != way.start) {
            chains.push_back(way);
        } else {
            extend(chains.back(), way.segments.front());
        }
    }
    return chains;
}

}  // namespace stepmill
