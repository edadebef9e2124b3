// Form operations of a posted program against what must stand.

#include "verify/prove_form.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/access/collision.h"
#include "stepmill/access/form_floor.h"
#include "stepmill/catalog/cutter_form.h"
#include "stepmill/planar/edge_index.h"

namespace stepmill::verify {
namespace {

/// Distances beyond so many radii are all alike.
constexpr double kFarRadii = 4;
/// Sections are looked for at least so far beyond the cutter [mm].
constexpr double kLeastLookMm = 0.01;

/// Sections that moves are held against, one after the other.
class Sections {
  public:
    explicit Sections(const std::vector<Obstacle>& bands)
        : bands_(bands), last_outside_(bands.size(), kNever) {
        for (const Obstacle& band : bands)
            edges_.emplace_back(band.section);
    }

    const std::vector<Obstacle>& bands() const { return bands_; }

    /// Distance from the way of move `number` to a section, 0 inside. A way that begins outside and meets no
    /// edge stays outside.
    double distance(std::size_t band, const Edge& way, std::size_t number, double far_mm) {
        if (edges_[band].empty()) return far_mm;
        const double found = edges_[band].distanceTo(way, far_mm);
        const bool from_outside = number > 0 && last_outside_[band] == number - 1;
        const bool inside = found <= 0 || (!from_outside && contains(bands_[band].section, way.segment.to));
        if (inside) return 0;
        last_outside_[band] = number;
        return found;
    }

  private:
    static constexpr std::size_t kNever = static_cast<std::size_t>(-2);
    const std::vector<Obstacle>& bands_;
    std::vector<EdgeIndex> edges_;
    std::vector<std::size_t> last_outside_;
};

class FormProver {
  public:
    FormProver(const RecordedOperation& planned, const FormGround& ground, const Tolerances& tol,
               const Findings& findings)
        : planned_(planned),
          tol_(tol),
          findings_(findings),
          form_(planned.tool),
          window_(ground.window),
          window_edges_(ground.window),
          must_stand_(ground.must_stand),
          obstacles_(ground.obstacles) {}

    void prove(const ReadOperation& operation) {
        Vec3 from = operation.start;
        for (const ReadMove& read : operation.moves) {
            if (failed_) return;
            line_ = read.line;
            proveMove(from, read.fed.move);
            from = read.fed.move.to;
        }
    }

  private:
    void proveMove(const Vec3& from, const Move& move) {
        // Straight up it leaves the way it came.
        const bool leaves = from.head<2>() == move.to.head<2>() && move.to.z() >= from.z();
        const Edge way = edgeOf(from, move);
        const double rise_mm = move.to.z() - from.z();
        const bool slopes = !move.arc && way.from != way.to();
        const int pieces =
            slopes ? std::max(1, static_cast<int>(std::ceil(std::abs(rise_mm) / kSlopeRiseMm))) : 1;
        Vec3 begin = from;
        for (int i = 1; i <= pieces && !failed_; ++i) {
            const Vec3 end = i == pieces ? move.to : Vec3(from + (move.to - from) * i / pieces);
            const double low_mm = std::min(begin.z(), end.z());
            const Edge piece = pieces == 1 ? way : makeLine(begin.head<2>(), end.head<2>());
            ++piece_;
            proveDepth(low_mm);
            proveCutter(piece, low_mm, piece_);
            proveHolder(piece, low_mm, piece_);
            if (move.kind == MoveKind::Rapid && !leaves) proveRapid(piece, low_mm, piece_);
            begin = end;
        }
    }

    void fail(const std::string& text) {
        if (!failed_) findings_.add(line_, text);
        failed_ = true;
    }

    double farMm() const { return kFarRadii * form_.fullRadiusMm(); }

    void proveDepth(double low_mm) {
        if (low_mm < planned_.z_floor_mm - kSamePostedHeightMm)
            fail(fmt::format("goes down to Z{:.4f}, planned is Z{:.4f}", low_mm, planned_.z_floor_mm));
    }

    /// Heights of the tip are rounded: the tip counts as that much higher.
    void proveCutter(const Edge& way, double low_mm, std::size_t number) {
        const std::vector<Obstacle>& bands = must_stand_.bands();
        const double tip_mm = low_mm + kSamePostedHeightMm;
        if (bands.empty() || tip_mm >= bands.back().top_z_mm) return;
        if (!contains(window_, way.segment.to) ||
            window_edges_.distanceTo(way, farMm()) < form_.fullRadiusMm() - tol_.gouge_mm)
            return fail("leaves the ground that the plan tells of");
        for (std::size_t i = bands.size(); i-- > 0 && bands[i].top_z_mm > tip_mm;) {
            const double radius_mm = form_.radiusAt(bands[i].top_z_mm - tip_mm);
            // Farther than the nearest so far is as good as any.
            const double far_mm =
                std::min(farMm(), radius_mm + std::max(kLeastLookMm, findings_.proof.clearance_mm));
            const double clearance = must_stand_.distance(i, way, number, far_mm) - radius_mm;
            findings_.proof.clearance_mm = std::min(findings_.proof.clearance_mm, clearance);
            if (clearance < -tol_.gouge_mm)
                return fail(fmt::format("cuts into what must stay, between Z{:.4f} and Z{:.4f}, by {:.4f} mm",
                                        bands[i].bottom_z_mm, bands[i].top_z_mm, -clearance));
        }
    }

    void proveHolder(const Edge& way, double low_mm, std::size_t number) {
        for (const HolderCylinder& cylinder : access::cylindersOf(planned_.tool)) {
            const double kept_mm = access::clearanceAround(planned_.tool, cylinder);
            const double clearance =
                overhead(way, low_mm + cylinder.bottom_mm, cylinder.diameter_mm / 2 - kept_mm, number);
            findings_.proof.holder_clearance_mm = std::min(findings_.proof.holder_clearance_mm, clearance);
            if (clearance < kept_mm - tol_.gouge_mm)
                return fail(
                    fmt::format("shank or holder ({:.4g} mm wide from {:.4g} mm over the tip{}) comes "
                                "into material by {:.4f} mm",
                                cylinder.diameter_mm, cylinder.bottom_mm, clearanceWords(planned_.tool),
                                kept_mm - clearance));
        }
    }

    void proveRapid(const Edge& way, double low_mm, std::size_t number) {
        if (overhead(way, low_mm, form_.fullRadiusMm(), number) >= -tol_.gouge_mm) return;
        findings_.proof.rapids_clear = false;
        fail("a rapid meets material that is still there");
    }

    /// Least distance from a cylinder that stands up from that height to what stands there or above.
    double overhead(const Edge& way, double z_mm, double radius_mm, std::size_t number) {
        const auto over = access::obstacleAbove(obstacles_.bands(), z_mm, kSamePostedHeightMm);
        if (!over) return std::numeric_limits<double>::infinity();
        const double far_mm = std::max(farMm(), 2 * radius_mm);
        return obstacles_.distance(*over, way, number, far_mm) - radius_mm;
    }

    const RecordedOperation& planned_;
    const Tolerances& tol_;
    const Findings& findings_;
    CutterForm form_;
    const Region& window_;
    EdgeIndex window_edges_;
    Sections must_stand_;
    Sections obstacles_;
    int line_ = 0;
    std::size_t piece_ = 0;  ///< of all moves, counted from 1
    bool failed_ = false;
};

}  // namespace

void proveFormMoves(const ReadOperation& operation, const RecordedOperation& planned,
                    const FormGround& ground, const Tolerances& tol, const Findings& findings) {
    FormProver(planned, ground, tol, findings).prove(operation);
}

void proveFormCut(const ReadOperation& operation, const RecordedOperation& planned, const Tolerances& tol,
                  StandingStairs& stairs, const Findings& findings) {
    double counted_mm3 = planned.breaks_mm3;
    for (const ReasonVolume& entry : planned.takes)
        counted_mm3 += entry.volume_mm3;
    const double before_mm3 = stairs.volumeMm3();
    std::vector<Move> moves;
    for (const ReadMove& read : operation.moves)
        moves.push_back(read.fed.move);
    for (const LevelWays& level : levelWays(operation.start, moves))
        stairs.cut(level, CutterForm(planned.tool));
    stairs.cut(surfaceWays(operation.start, moves), CutterForm(planned.tool));
    const double taken_mm3 = before_mm3 - stairs.volumeMm3();
    if (taken_mm3 < counted_mm3 * (1 - tol.volume_share) - kVolumeRoundingMm3)
        findings.add(operation.line,
                     fmt::format("takes {:.4f} mm3 off {}, the plan counts on {:.4f}", taken_mm3,
                                 planned.breaks_mm3 > 0 ? "edges" : "leaning walls", counted_mm3));
}

}  // namespace stepmill::verify
