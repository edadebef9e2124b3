#pragma once

#include "stepmill/verify/verify.h"

namespace stepmill::verify {

/// Heights closer than this are one: two that were equal before each was rounded to a last decimal of an inch
/// [mm].
inline constexpr double kSamePostedHeightMm = 3e-4;

/// Depths of cuts are told to this: heights are rounded twice [mm].
inline constexpr double kDepthRoundingMm = 2e-3;

/// What of a feature's target stands above a height: all that no operation has cleared down to there.
struct StandingAbove {
    double z_mm = 0;
    Region region;
};

/// A feature while the program runs: what of it is still there.
struct FeatureState {
    Feature feature;  ///< below what its ancestors left, beside the fixtures [plan/reduced_feature.h]
    /// At every height that operations of the feature go down to, from below; the first is what stands over
    /// the floor. Each holds the ones above it.
    std::vector<StandingAbove> standing;
    /// The same as the ways that were gone; nothing where no operation of the feature has a rating or
    /// a planned angle.
    std::optional<CutGround> ground;
    double safe_z_mm = 0;  ///< nothing stands higher in the setup, neither stock nor fixture

    /// What may stand at that height.
    const Region& standingAt(double z_mm) const;
};

/// Where an operation's checks report to.
struct Findings {
    const std::string& file;
    OperationProof& proof;
    std::vector<ProofFailure>& failures;

    void add(int line, const std::string& text) const {
        failures.push_back({file, line, proof.operation, text});
    }
};

/// Cutter against obstruction and floor, rapids against what stands.
void proveMoves(const ReadOperation& operation, const RecordedOperation& planned, const FeatureState& state,
                const Tolerances& tol, const Findings& findings);

/// Shank and holder against what stands over the floor, the feature's own material included until it is cut.
void proveHolder(const ReadOperation& operation, const RecordedOperation& planned, const FeatureState& state,
                 const Tolerances& tol, const Findings& findings);

/// A mill's passes go nowhere deeper than the planned step-down below what this operation cut there before,
/// or below the feature's top; ground that earlier operations cleared is free. So every depth of cut covers
/// what the next one does, and with what stays at the floor every level is covered.
void proveDepths(const ReadOperation& operation, const RecordedOperation& planned, const FeatureState& state,
                 const Tolerances& tol, const Findings& findings);

/// Feeds no higher than planned; where the spindle turns slower, so much less. An operation with a rating may
/// go faster in thin cuts, by kMostChipThinning at most: proveCuts() says where.
void proveFeeds(const ReadProgram& program, const ReadOperation& operation, const RecordedOperation& planned,
                double max_feed_mm_per_min, const Findings& findings);

/// Every move of an operation with a rating cuts no faster than its width and depth allow: the tool's rated
/// removal, its slot step-down, the spindle's power and torque. Widths and depths are those of the posted
/// moves, in what the setup's operations before them have left of the feature.
void proveCuts(const ReadProgram& program, const ReadOperation& operation, const RecordedOperation& planned,
               const CutGround& ground, const Material& material, const Machine& machine,
               const Findings& findings);

/// No cut at depth of an adaptive operation engages more of the cutter's rim than planned, but for grazes
/// (kGrazeShare). Slopes and what they have left of themselves are ways in, not cuts at depth.
/// \param top_z_mm  of the feature
void proveEngagement(const ReadOperation& operation, const RecordedOperation& planned,
                     const CutGround& ground, double top_z_mm, const Findings& findings);

/// How deep the tip may go: a drill's where the feature ends below its floor, else the operation's floor.
double lowestZ(const RecordedOperation& planned, const Feature& feature);

/// What the operation clears down to clearedDownTo(); below that a drill's point leaves some of it.
Region cleared(const ReadOperation& operation, const RecordedOperation& planned, const Feature& feature,
               const Tolerances& tol);
double clearedDownTo(const RecordedOperation& planned, const Feature& feature);

}  // namespace stepmill::verify
