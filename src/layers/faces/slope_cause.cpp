// Why a leaning face leans: what a machinist would call it.

#include "layers/faces/trace_faces.h"
#include "stepmill/core/units.h"

namespace stepmill::layers {

namespace {

/// Heights closer than that are the same [mm].
constexpr double kSameMeshMm = 2e-3;
/// Leaning that much or less from the vertical is draft.
const double kDraftNormal = std::sin(degToRad(20));
/// Steeper than that from the horizontal, a bevel is a chamfer rather than a nearly level face.
const double kChamferNormal = std::sin(degToRad(80));

class Namer {
  public:
    Namer(const SolidMesh& mesh, std::vector<FaceTrace>& traces) : mesh_(mesh), traces_(traces) {}

    void run() {
        for (FaceTrace& trace : traces_)
            if (leans(trace)) trace.cause = firstGuess(trace);
        // Balls and saddles in the corners of fillets touch the floor in a point, not along an edge.
        for (bool again = true; again;) {
            again = false;
            for (FaceTrace& trace : traces_)
                if (trace.cause == SlopeCause::FreeForm && trace.stand == FaceStand::Leaning)
                    again = joinsFillet(trace) || again;
        }
    }

  private:
    static bool leans(const FaceTrace& trace) {
        return trace.stand == FaceStand::Leaning || trace.stand == FaceStand::Overhang ||
               trace.stand == FaceStand::Turning;
    }

    static bool isFlank(const FaceTrace& trace) {
        return trace.surface == SurfaceKind::Plane ||
               (trace.surface == SurfaceKind::Cone && trace.axis_point.has_value());
    }

    /// A hollow cylinder or cone about another axis than the tool's.
    static bool isAcross(const FaceTrace& trace) {
        return trace.hollow && !trace.axis_point &&
               (trace.surface == SurfaceKind::Cylinder || trace.surface == SurfaceKind::Cone);
    }

    /// The lower or upper half of a hole that the file splits lengthwise.
    bool isHalfOfHole(const FaceTrace& trace) const {
        if (!isAcross(trace)) return false;
        return std::any_of(
            trace.neighbours.begin(), trace.neighbours.end(), [&](const FaceNeighbour& neighbour) {
                const FaceTrace& other = traces_[neighbour.face];
                return neighbour.bend == Bend::Smooth && isAcross(other) &&
                       std::abs(other.radius_mm - trace.radius_mm) < kSameMeshMm &&
                       (trace.stand == FaceStand::Overhang) != (other.stand == FaceStand::Overhang);
            });
    }

    SlopeCause firstGuess(const FaceTrace& trace) const {
        if (isHalfOfHole(trace)) return SlopeCause::AcrossAxis;
        if (trace.stand == FaceStand::Overhang) return SlopeCause::Overhang;
        if (trace.stand == FaceStand::Turning)
            return isAcross(trace) ? SlopeCause::AcrossAxis : SlopeCause::FreeForm;
        if (closesToPoint(trace)) return SlopeCause::DrillPoint;
        if (trace.greatest_normal_z <= kDraftNormal) return SlopeCause::Draft;
        if (isFlank(trace)) return isChamfer(trace) ? SlopeCause::Chamfer : SlopeCause::SlantedFace;
        if (meets(trace, Bend::Smooth, FaceStand::Floor, trace.bottom_z_mm) && flattensBelow(trace))
            return SlopeCause::FloorFillet;
        if (meets(trace, Bend::Smooth, FaceStand::Floor, trace.top_z_mm) && !flattensBelow(trace))
            return SlopeCause::EdgeFillet;
        return SlopeCause::FreeForm;
    }

    bool closesToPoint(const FaceTrace& trace) const {
        return trace.surface == SurfaceKind::Cone && trace.axis_point && trace.hollow &&
               mesh_.faces()[trace.face].radiusAt(trace.bottom_z_mm, 0) < kSameMeshMm;
    }

    /// A bevel from a floor's outer edge down to a vertical wall's.
    bool isChamfer(const FaceTrace& trace) const {
        if (trace.greatest_normal_z > kChamferNormal) return false;
        bool wall = false;
        for (const FaceNeighbour& neighbour : trace.neighbours) {
            const FaceTrace& other = traces_[neighbour.face];
            wall = wall || (other.stand == FaceStand::Wall && neighbour.bend == Bend::Convex &&
                            other.top_z_mm < trace.top_z_mm - kSameMeshMm / 2);
        }
        return wall && meets(trace, Bend::Convex, FaceStand::Floor, trace.top_z_mm);
    }

    bool meets(const FaceTrace& trace, Bend bend, FaceStand stand, double z_mm) const {
        return std::any_of(trace.neighbours.begin(), trace.neighbours.end(),
                           [&](const FaceNeighbour& neighbour) {
                               const FaceTrace& other = traces_[neighbour.face];
                               return neighbour.bend == bend && other.stand == stand &&
                                      std::abs(other.top_z_mm - z_mm) < kSameMeshMm;
                           });
    }

    /// Is the face more level at its foot than at its top?
    bool flattensBelow(const FaceTrace& trace) const {
        double low = 1e300;
        double high = -1e300;
        double normal_low = 0;
        double normal_high = 0;
        for (const int t : mesh_.trianglesOfFace()[trace.face]) {
            const MeshTriangle& triangle = mesh_.triangles()[t];
            for (int k = 0; k < 3; ++k) {
                const double z = mesh_.nodes()[triangle.node[k]].z();
                if (z < low) normal_low = triangle.normal_z[k];
                if (z > high) normal_high = triangle.normal_z[k];
                low = std::min(low, z);
                high = std::max(high, z);
            }
        }
        return normal_low > normal_high;
    }

    bool joinsFillet(FaceTrace& trace) const {
        for (const FaceNeighbour& neighbour : trace.neighbours) {
            const FaceTrace& other = traces_[neighbour.face];
            if (neighbour.bend != Bend::Smooth || !other.cause) continue;
            const bool floor = *other.cause == SlopeCause::FloorFillet && flattensBelow(trace) &&
                               std::abs(other.bottom_z_mm - trace.bottom_z_mm) < kSameMeshMm;
            const bool edge = *other.cause == SlopeCause::EdgeFillet && !flattensBelow(trace) &&
                              std::abs(other.top_z_mm - trace.top_z_mm) < kSameMeshMm;
            if (!floor && !edge) continue;
            trace.cause = *other.cause;
            return true;
        }
        return false;
    }

    const SolidMesh& mesh_;
    std::vector<FaceTrace>& traces_;
};

}  // namespace

void nameCauses(const SolidMesh& mesh, std::vector<FaceTrace>& traces) {
    Namer(mesh, traces).run();
}

}  // namespace stepmill::layers
