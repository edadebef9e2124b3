#pragma once

#include <vector>

#include "layers/mesh/solid_mesh.h"

namespace stepmill::layers {

/// A height where the section may change, and how much its exact value matters.
struct Level {
    enum class Rank { FaceEnd, Silhouette, CutPlane, Plane, StockBound };
    double z_mm = 0;
    Rank rank = Rank::FaceEnd;

    /// Slabs may be joined over it.
    bool soft() const { return rank < Rank::Plane; }
};

/// Heights of a solid: its horizontal planes, the ends of all other faces, and their silhouettes. `planes`:
/// the planes' rank; those earlier setups cut into the stock are CutPlane.
void addLevels(const SolidMesh& mesh, Level::Rank planes, std::vector<Level>& levels);

/// From the top down; levels closer than `merge_mm` to their neighbour are one, at the highest-ranking
/// height among them (of equals the highest). Levels outside [bottom, top] are left out.
std::vector<Level> mergeLevels(std::vector<Level> levels, double top_mm, double bottom_mm, double merge_mm);

}  // namespace stepmill::layers
