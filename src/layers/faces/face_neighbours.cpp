// Which faces meet, and whether the edge between them is an inner or an outer one.

#include <algorithm>
#include <map>
#include <utility>

#include "layers/faces/trace_faces.h"
#include "stepmill/core/units.h"

namespace stepmill::layers {

namespace {

/// Faces whose normals turn by less at their edge run on smoothly for a cutter [rad]: fillets of files are
/// tangent to their neighbours only about as well as that.
constexpr double kSmoothRad = degToRad(1);

}  // namespace

std::vector<std::vector<FaceNeighbour>> neighboursOf(const std::vector<FaceEdge>& edges, std::size_t faces) {
    std::map<std::pair<int, int>, const FaceEdge*> longest;
    for (const FaceEdge& edge : edges) {
        const FaceEdge*& known = longest[std::minmax(edge.first, edge.second)];
        if (known == nullptr || edge.length_mm > known->length_mm) known = &edge;
    }
    std::vector<std::vector<FaceNeighbour>> neighbours(faces);
    for (const auto& [pair, edge] : longest) {
        const Bend bend = edge->turn_rad < kSmoothRad ? Bend::Smooth : edge->bend;
        neighbours[pair.first].push_back({pair.second, bend});
        neighbours[pair.second].push_back({pair.first, bend});
    }
    for (std::vector<FaceNeighbour>& of_face : neighbours)
        std::sort(of_face.begin(), of_face.end(),
                  [](const FaceNeighbour& a, const FaceNeighbour& b) { return a.face < b.face; });
    return neighbours;
}

}  // namespace stepmill::layers
