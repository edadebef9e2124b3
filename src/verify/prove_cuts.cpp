// Feeds against what each move really cuts.

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "verify/prove_operation.h"

namespace stepmill::verify {
namespace {

/// Widths are taken for so much less, as a share of the diameter: between two positions looked at, and by
/// rounding, the rim meets more or less.
constexpr double kWidthRounding = 0.02;
/// Feeds may be this much higher, as a share.
constexpr double kCutFeedRounding = 5e-3;
/// Speeds closer than this are one [1/min].
constexpr double kSameSpeedRpm = 1;

class CutProver {
  public:
    CutProver(const ReadProgram& program, const RecordedOperation& planned, const Material& material,
              const Machine& machine, const Findings& findings)
        : program_(program), planned_(planned), material_(material), machine_(machine), findings_(findings) {}

    void prove(const ReadOperation& operation, const CutGround& ground) {
        CutFollower follower(ground, planned_.tool.radius_mm(), planned_.step_down_mm, kProofCuspShare);
        Vec3 from = operation.start;
        for (const ReadMove& read : operation.moves) {
            const MoveCut cut = follower.next(from, read.fed.move);
            from = read.fed.move.to;
            if (cut.depth_mm > 0 && !check(read, cut)) return;
        }
    }

  private:
    /// False where the move is too fast; that is told once.
    bool check(const ReadMove& read, const MoveCut& cut) {
        const CuttingModel* model = modelAt(program_.states[read.state].speed_rpm);
        if (model == nullptr) return true;  // told elsewhere
        const double width_mm = cut.widest_mm - kWidthRounding * planned_.tool.diameter_mm;
        const LimitedFeed allowed =
            model->feedFor(std::max(0.0, width_mm), std::max(0.0, cut.depth_mm - kDepthRoundingMm));
        if (read.fed.feed_mm_per_min <= allowed.feed_mm_per_min * (1 + kCutFeedRounding)) return true;
        findings_.add(read.line,
                      fmt::format("feeds at {:.1f} mm/min in a cut {:.2f} mm wide and {:.2f} mm deep; "
                                  "{:.1f} are allowed ({})",
                                  read.fed.feed_mm_per_min, cut.widest_mm, cut.depth_mm,
                                  allowed.feed_mm_per_min, toString(allowed.limit)));
        return false;
    }

    /// At a speed below the planned one the spindle gives less.
    const CuttingModel* modelAt(double speed_rpm) {
        if (speed_rpm <= 0 || speed_rpm > planned_.speed_rpm + kSameSpeedRpm) return nullptr;
        const bool slower = speed_rpm < planned_.speed_rpm - kSameSpeedRpm;
        const double run_rpm = slower ? speed_rpm : planned_.speed_rpm;
        const auto known = models_.find(run_rpm);
        if (known != models_.end()) return &known->second;
        RecordedOperation as_run = planned_;
        as_run.speed_rpm = run_rpm;
        const std::optional<CuttingModel> model = cuttingModelOf(as_run, material_, machine_);
        return model ? &models_.emplace(run_rpm, *model).first->second : nullptr;
    }

    const ReadProgram& program_;
    const RecordedOperation& planned_;
    const Material& material_;
    const Machine& machine_;
    const Findings& findings_;
    std::map<double, CuttingModel> models_;  ///< by speed
};

}  // namespace

void proveCuts(const ReadProgram& program, const ReadOperation& operation, const RecordedOperation& planned,
               const CutGround& ground, const Material& material, const Machine& machine,
               const Findings& findings) {
    CutProver(program, planned, material, machine, findings).prove(operation, ground);
}

}  // namespace stepmill::verify
