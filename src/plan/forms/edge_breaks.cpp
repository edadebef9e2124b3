#include "stepmill/plan/edge_breaks.h"

#include <algorithm>
#include <cmath>

#include "stepmill/feature/heights.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/path_parts.h"
#include "stepmill/toolpath/swept_region.h"

namespace stepmill {
namespace {

/// An edge of a level face and the wall's footprint are each fitted within the curve tolerance.
double sameEdgeMm(const Tolerances& tol) {
    return 2 * tol.curve_fit_mm;
}

/// The upright wall that falls from the face's edge; null where something else lies there. Elsewhere it may
/// go higher: the side of a flight of steps is one face.
const FaceTrace* wallBelow(const LayerStack& layers, const FaceTrace& floor, const Edge& edge,
                           const Tolerances& tol) {
    const Vec2 middle = pointAt(edge, 0.5);
    for (const FaceNeighbour& neighbour : floor.neighbours) {
        const FaceTrace& wall = layers.traces[static_cast<std::size_t>(neighbour.face)];
        const bool falls = neighbour.bend == Bend::Convex && wall.stand == FaceStand::Wall &&
                           wall.top_z_mm >= floor.top_z_mm - kSameWrittenHeightMm &&
                           wall.bottom_z_mm < floor.top_z_mm - kSameWrittenHeightMm;
        if (falls && distanceTo(middle, wall.footprint) <= sameEdgeMm(tol)) return &wall;
    }
    return nullptr;
}

/// Appends an edge to the last stretch where that ends at its start.
void append(const Edge& edge, std::vector<Path>& stretches) {
    if (stretches.empty() || stretches.back().end() != edge.from) stretches.push_back({edge.from, {}});
    stretches.back().segments.push_back(edge.segment);
}

/// A loop's first and last stretch are one where they meet.
void closeUp(std::vector<Path>& stretches) {
    if (stretches.size() < 2 || stretches.back().end() != stretches.front().start) return;
    append(stretches.back(), stretches.front());
    stretches.erase(stretches.begin());
}

}  // namespace

SharpStretch sharpStretch(const Path& edge, double z_mm, std::string why) {
    const double length_mm = length(edge);
    const Vec2 middle = firstPart(edge, length_mm / 2).end();
    return {{middle.x(), middle.y(), z_mm}, length_mm, std::move(why)};
}

EdgeBreaks::EdgeBreaks(const LayerStack& layers, double width_mm, const Tolerances& tol)
    : width_mm_(width_mm), tol_(tol) {
    for (const FaceTrace& floor : layers.traces)
        if (floor.stand == FaceStand::Floor) addFace(layers, floor);
    std::stable_sort(faces_.begin(), faces_.end(),
                     [](const FaceEdges& a, const FaceEdges& b) { return a.z_mm < b.z_mm; });
}

void EdgeBreaks::addFace(const LayerStack& layers, const FaceTrace& floor) {
    FaceEdges found{floor.top_z_mm, floor.region, {}};
    for (const Loop& loop : floor.region.loops) {
        std::vector<Path> high;
        std::vector<Path> low;
        for (const Edge& edge : edgesOf(loop)) {
            const FaceTrace* wall = wallBelow(layers, floor, edge, tol_);
            if (wall == nullptr) continue;
            const double height_mm = floor.top_z_mm - wall->bottom_z_mm;
            append(edge, height_mm + kSameWrittenHeightMm >= width_mm_ ? high : low);
        }
        closeUp(high);
        closeUp(low);
        std::move(high.begin(), high.end(), std::back_inserter(found.edges));
        for (const Path& edge : low)
            low_walls_.push_back(sharpStretch(edge, found.z_mm, "the wall below is lower than the break"));
    }
    if (!found.edges.empty()) faces_.push_back(std::move(found));
}

Region EdgeBreaks::mayGo(double bottom_mm, double top_mm) const {
    return stripsAt(top_mm, bottom_mm, top_mm);
}

Region EdgeBreaks::goesHalfWay(double bottom_mm, double top_mm) const {
    return stripsAt((bottom_mm + top_mm) / 2, bottom_mm, top_mm);
}

/// The strips at one height of the edges whose breaks hold all of the band.
Region EdgeBreaks::stripsAt(double z_mm, double bottom_mm, double top_mm) const {
    std::vector<Region> strips;
    for (const FaceEdges& face : faces_) {
        const double foot_mm = face.z_mm - width_mm_;
        if (top_mm > face.z_mm + kSameWrittenHeightMm || bottom_mm < foot_mm - kSameWrittenHeightMm) continue;
        const Region swept = toolpath::sweptRegion(face.edges, std::min(z_mm - foot_mm, width_mm_), tol_);
        strips.push_back(intersect(swept, face.face, tol_));
    }
    return strips.empty() ? Region{} : unite(strips, tol_);
}

}  // namespace stepmill
