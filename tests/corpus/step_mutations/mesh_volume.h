#pragma once

#include <optional>
#include <string>

namespace stepmill::test {

/// Volume of everything OCCT makes of a STEP file, in mm3, from triangles: the integral of x dA_x, y dA_y and
/// z dA_z over all faces. The three are one number where the faces close and all look outwards; a face turned
/// round, missing or doubled sets them apart.
struct MeshVolume {
    double x_mm3 = 0;
    double y_mm3 = 0;
    double z_mm3 = 0;

    /// True if all three are `volume_mm3` within a share of it.
    bool agrees(double volume_mm3, double share) const;
};

/// Reads with OCCT alone: no screen, no healing of ours. Nothing when OCCT cannot read or mesh it.
std::optional<MeshVolume> meshVolume(const std::string& step_text);

}  // namespace stepmill::test
