// Threads: where taps go, how deep, and with which pitch.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/feature/hole_group.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/tapping.h"
#include "stepmill/toolpath/swept_region.h"
#include "verify/hole_places.h"
#include "verify/prove_state.h"

namespace stepmill::verify {
namespace {

/// F words of a tap have two decimals in mm, three in inches: half the last of these [mm/min].
constexpr double kFeedRoundingMmPerMin = 0.0128;

std::string otherToolsTrouble(const ReadMove& read) {
    return fmt::format("is coupled to the spindle by {:.6g} mm a turn; planned is no thread", read.pitch_mm);
}

class TapProver {
  public:
    TapProver(const ReadProgram& program, const ReadOperation& operation, const RecordedOperation& planned,
              const FeatureState& state, const std::vector<Fixture>& fixtures, const Tolerances& tol,
              const Findings& findings)
        : program_(program),
          operation_(operation),
          planned_(planned),
          state_(state),
          fixtures_(fixtures),
          tol_(tol),
          findings_(findings),
          tapped_(planned.thread->places.size(), 0) {}

    void prove() {
        if (!isHole(state_.feature.feature_class) || state_.feature.target.empty())
            return tell(operation_.line, "taps what is no hole");
        proveHoles();
        proveDepth();
        proveShank();
        proveWays();
        for (std::size_t i = 0; i < tapped_.size(); ++i)
            if (tapped_[i] != 1)
                tell(operation_.line, fmt::format("taps {} times {}, planned is once", tapped_[i],
                                                  placeWords(planned_.thread->places[i])));
    }

  private:
    void tell(int line, const std::string& text) const { findings_.add(line, text); }

    const Thread& thread() const { return planned_.thread->thread; }

    /// The holes are cores of the thread, and nothing stands in them down to the tip.
    void proveHoles() const {
        const Feature& feature = state_.feature;
        const double hole_mm = 2 * holeRadiusMm(feature);
        const CoreRange core = coreRange(thread());
        if (!isCoreOf(thread(), hole_mm))
            tell(operation_.line,
                 fmt::format("taps {} in a hole of {:.4f} mm, its core is {:.4f} to {:.4f} mm", thread().name,
                             hole_mm, core.least_mm, core.most_mm));
        const std::vector<Vec2> axes = holeCentres(feature);
        const Region standing = state_.standingAt(std::max(planned_.z_floor_mm, feature.floor_z_mm));
        for (const Vec2& place : planned_.thread->places) {
            const bool known = std::any_of(axes.begin(), axes.end(), [&](const Vec2& axis) {
                return (axis - place).norm() <= kOnAxisMm;
            });
            if (!known) tell(operation_.line, "taps " + placeWords(place) + ", where no hole is");
            if (standing.empty()) continue;
            const Region in_hole = intersect(standing, makeCircle(place, hole_mm / 2), tol_);
            if (!toolpath::piecesBeyondSkins(in_hole, tol_).empty())
                tell(operation_.line,
                     fmt::format("taps to Z{:.4f} {}, where the hole is not made down to there before",
                                 planned_.z_floor_mm, placeWords(place)));
        }
    }

    /// Below the whole thread there is room for the tap's lead, and below the tip in a blind hole a pitch.
    void proveDepth() const {
        const double tip_z_mm = planned_.z_floor_mm;
        const Feature hole = asTapFinds(state_.feature, planned_.tool, fixtures_, tol_);
        const double deepest_z_mm = deepestTapTipZ(hole, planned_.tool, hole.floor_z_mm);
        if (tip_z_mm < deepest_z_mm - kSamePostedHeightMm)
            tell(operation_.line,
                 fmt::format("taps to Z{:.4f}, the hole lets its tip go to Z{:.4f}", tip_z_mm, deepest_z_mm));
        const double full_z_mm = planned_.thread->full_to_z_mm;
        if (full_z_mm < tip_z_mm + planned_.tool.lead_mm - kSamePostedHeightMm)
            tell(operation_.line,
                 fmt::format(
                     "its thread cannot be whole down to Z{:.4f}: the lead of {:.4f} mm ends at Z{:.4f}",
                     full_z_mm, planned_.tool.lead_mm, tip_z_mm + planned_.tool.lead_mm));
    }

    void proveShank() const {
        const std::string trouble = tapShankTrouble(state_.feature, planned_.tool, planned_.z_floor_mm);
        if (!trouble.empty()) tell(operation_.line, trouble);
    }

    /// Into the holes and out of them the tap goes by its pitch alone, across over all that stands.
    void proveWays() {
        Vec3 from = operation_.start;
        bool told = false;
        for (const ReadMove& read : operation_.moves) {
            const std::string trouble = troubleWith(from, read);
            if (!trouble.empty() && !told) tell(read.line, trouble);
            told = told || !trouble.empty();
            from = read.fed.move.to;
        }
    }

    double top() const { return state_.feature.top_z_mm; }

    /// What is wrong with a move; empty: nothing.
    std::string troubleWith(const Vec3& from, const ReadMove& read) {
        const Move& move = read.fed.move;
        const double low_z_mm = std::min(from.z(), move.to.z());
        const bool below = low_z_mm < top() - kSamePostedHeightMm;
        const bool across = !isOver(move.to, from.head<2>());
        if (move.kind == MoveKind::Rapid && below)
            return fmt::format("a rapid goes to Z{:.4f}, into the hole", low_z_mm);
        if (across && low_z_mm < state_.safe_z_mm - kSamePostedHeightMm)
            return fmt::format("goes across at Z{:.4f}, below the top of stock and fixtures", low_z_mm);
        if (move.kind == MoveKind::Rapid) return {};
        if (read.pitch_mm <= 0) return "feeds without the spindle's turns: it would strip the thread";
        if (move.arc || across) return "taps at a slant";
        if (std::string wrong = wrongPitch(read); !wrong.empty()) return wrong;
        if (std::max(from.z(), move.to.z()) < top() - kSamePostedHeightMm)
            return "turns round in the hole: the thread would be cut twice";
        return move.to.z() < from.z() ? wrongHole(move.to) : std::string();
    }

    std::string wrongPitch(const ReadMove& read) const {
        const double speed_rpm = program_.states[read.state].speed_rpm;
        const double off_mm_per_min = std::abs(read.pitch_mm - thread().pitch_mm) * speed_rpm;
        if (speed_rpm > 0 && off_mm_per_min <= kFeedRoundingMmPerMin) return {};
        return fmt::format("goes {:.6f} mm a turn at S{:.0f}, the pitch of {} is {:.6f} mm", read.pitch_mm,
                           speed_rpm, thread().name, thread().pitch_mm);
    }

    /// \param to  the end of the way down
    std::string wrongHole(const Vec3& to) {
        const std::vector<Vec2>& places = planned_.thread->places;
        const auto place =
            std::find_if(places.begin(), places.end(), [&](const Vec2& axis) { return isOver(to, axis); });
        if (place == places.end()) return "taps " + placeWords(to.head<2>()) + ", which is not planned";
        ++tapped_[static_cast<std::size_t>(place - places.begin())];
        if (std::abs(to.z() - planned_.z_floor_mm) <= kSamePostedHeightMm) return {};
        return fmt::format("taps to Z{:.4f}, planned is Z{:.4f}", to.z(), planned_.z_floor_mm);
    }

    const ReadProgram& program_;
    const ReadOperation& operation_;
    const RecordedOperation& planned_;
    const FeatureState& state_;
    const std::vector<Fixture>& fixtures_;
    const Tolerances& tol_;
    const Findings& findings_;
    std::vector<int> tapped_;  ///< how often each place is tapped
};

}  // namespace

void proveTapping(const ReadProgram& program, const ReadOperation& operation,
                  const RecordedOperation& planned, const FeatureState& state,
                  const std::vector<Fixture>& fixtures, const Tolerances& tol, const Findings& findings) {
    if (planned.thread) return TapProver(program, operation, planned, state, fixtures, tol, findings).prove();
    for (const ReadMove& read : operation.moves)
        if (read.pitch_mm > 0) return findings.add(read.line, otherToolsTrouble(read));
}

}  // namespace stepmill::verify
