#pragma once

#include <set>

#include "stepmill/verify/verify.h"
#include "verify/prove_operation.h"

namespace stepmill::verify {

/// What the machine is set to at every motion of an operation: the planned tool with its length offset, the
/// planned work offset, G17, G40, G94, a path that is kept to, and at feeds the spindle and the coolant as
/// planned. Each fault is told where it shows first.
void proveStates(const ReadProgram& program, const ReadOperation& operation, const RecordedOperation& planned,
                 const Findings& findings);

/// Rapids from or to places that the program does not say stay over stock and fixtures, with the right
/// offsets; tools change and programs end there too, and at the top of the machine's travel where it has a
/// home.
void proveLeaps(const ReadProgram& program, double safe_z_mm, bool has_home,
                std::vector<ProofFailure>& failures);

/// Every tool that is named is one of the setup's: a controller refuses those its table lacks.
void proveTools(const ReadProgram& program, const std::set<int>& tools, std::vector<ProofFailure>& failures);

/// How far the tool goes along each axis over a setup's programs; a failure where that is first more than the
/// machine travels, and where its column first comes to what stands on the table.
class TravelProver {
  public:
    /// \param back_mm  how far towards +Y stock and fixtures reach
    TravelProver(const Machine& machine, double back_mm, std::vector<ProofFailure>& failures)
        : machine_(machine), back_mm_(back_mm), failures_(failures) {}

    void prove(const ReadProgram& program);

  private:
    void extend(const Vec3& place, const std::string& file, int line, const std::string& operation);
    void keepOffColumn(const Vec3& place, const std::string& file, int line, const std::string& operation);

    const Machine& machine_;
    double back_mm_;
    std::vector<ProofFailure>& failures_;
    Box3 box_;
    std::array<bool, 3> told_{};
    bool told_of_column_ = false;
};

/// It stays at the bottom of every hole, the tip at that height, as long as planned. The stays of all holes
/// add up: the reader knows their height, not their place.
void proveDwells(const ReadOperation& operation, const RecordedOperation& planned, double tip_z_mm,
                 std::size_t holes, const Findings& findings);

/// A tool for holes but a tap goes in every hole as deep as planned, in pecks no deeper than planned, and
/// stays at the bottom as long as planned.
void proveDrilling(const ReadOperation& operation, const RecordedOperation& planned,
                   const FeatureState& state, const Findings& findings);

/// A spot drill starts holes of the feature, its whole width clear of what stands over them.
void proveStarting(const ReadOperation& operation, const RecordedOperation& planned,
                   const FeatureState& state, const Findings& findings);

/// A reamer or boring head is as wide as the fit of the bore asks for, comes into bores that leave it what it
/// may take, stays over the end of a blind one, and goes down and up by feed alone.
void proveSizing(const ReadOperation& operation, const RecordedOperation& planned, const FeatureState& state,
                 const Tolerances& tol, const Findings& findings);

/// A tap cuts its thread in holes that were made for it, with the spindle's turns: at every planned place and
/// no other, down to the planned height and up again at the planned pitch, in a hole of the thread's core
/// diameter that is empty down to there and a pitch more. No other tool moves with the spindle.
/// \param fixtures  of the setup: a tap goes out of a through hole where none lies below
void proveTapping(const ReadProgram& program, const ReadOperation& operation,
                  const RecordedOperation& planned, const FeatureState& state,
                  const std::vector<Fixture>& fixtures, const Tolerances& tol, const Findings& findings);

}  // namespace stepmill::verify
