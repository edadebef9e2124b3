// Heights at which sections can change.

#include "layers/slab/levels.h"

namespace stepmill::layers {

void addLevels(const SolidMesh& mesh, Level::Rank planes, std::vector<Level>& levels) {
    for (const MeshFace& face : mesh.faces()) {
        if (face.horizontal) {
            levels.push_back({face.offset_mm * (face.normal.z() > 0 ? 1 : -1), planes});
        } else {
            levels.push_back({face.z_max_mm, Level::Rank::FaceEnd});
            levels.push_back({face.z_min_mm, Level::Rank::FaceEnd});
        }
    }
    for (const double z : mesh.silhouettes())
        levels.push_back({z, Level::Rank::Silhouette});
}

std::vector<Level> mergeLevels(std::vector<Level> levels, double top_mm, double bottom_mm, double merge_mm) {
    std::erase_if(levels, [&](const Level& level) {
        return level.z_mm >= top_mm - merge_mm || level.z_mm <= bottom_mm + merge_mm;
    });
    std::sort(levels.begin(), levels.end(), [](const Level& a, const Level& b) {
        return a.z_mm != b.z_mm ? a.z_mm > b.z_mm : a.rank > b.rank;
    });
    std::vector<Level> merged{{top_mm, Level::Rank::StockBound}};
    for (std::size_t i = 0; i < levels.size();) {
        std::size_t end = i + 1;
        Level best = levels[i];
        while (end < levels.size() && levels[end - 1].z_mm - levels[end].z_mm <= merge_mm) {
            if (levels[end].rank > best.rank) best = levels[end];
            ++end;
        }
        merged.push_back(best);
        i = end;
    }
    merged.push_back({bottom_mm, Level::Rank::StockBound});
    return merged;
}

}  // namespace stepmill::layers
