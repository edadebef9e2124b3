#pragma once

#include <limits>
#include <string>
#include <vector>

#include "stepmill/record/plan_files.h"

namespace stepmill {

/// What checking one operation of a posted program gave.
struct OperationProof {
    std::string operation;
    std::string feature;
    std::string tool;
    std::string file;
    int line = 0;  ///< of the operation's comment
    /// Least distance between cutter and what must stay; negative is a gouge. Infinite beyond three radii.
    double clearance_mm = std::numeric_limits<double>::infinity();
    /// Area of the feature's target that neither this nor an earlier operation has swept, and that the plan
    /// does not name as staying [mm2].
    double left_mm2 = 0;
    bool rapids_clear = true;
    /// Least distance between shank or holder and material; infinite where they stay over all of it.
    double holder_clearance_mm = std::numeric_limits<double>::infinity();
    /// No pass of a mill goes deeper than this below what was cut there before; 0 for drills.
    double depth_of_cut_mm = 0;
    /// Highest feed, as a share of what the plan allows there.
    double feed_share = 0;
};

/// A proof that fails, and where.
struct ProofFailure {
    std::string file;
    int line = 0;
    std::string operation;  ///< empty: of the whole file
    std::string text;
};

/// What a feature's operations leave of its target and the plan does not name; a failure too.
struct Leftover {
    std::string setup;
    std::string feature;
    Region region;
    double area_mm2 = 0;
    double height_mm = 0;
    double target_mm2 = 0;
};

/// A file of the job folder that is not as it was written, or that no proof is about.
struct FileRemark {
    enum class Kind { Changed, Missing, NotRead };
    std::string file;
    Kind kind = Kind::Changed;
};

struct Verification {
    std::vector<OperationProof> operations;  ///< in machining order
    std::vector<ProofFailure> failures;      ///< empty: all is proven
    std::vector<Leftover> leftovers;         ///< each is among the failures
    std::vector<ReasonVolume> left;          ///< what the plan says stays, beyond rounding
    int threads_missing = 0;                 ///< holes without thread or fit, as the plan says
    std::vector<FileRemark> remarks;         ///< about the folder; no failures

    bool proven() const { return failures.empty(); }
};

/// Does anything stay by the plan's own books that was not asked to, as roughing's allowance is?
bool leavesUnasked(const PlanRecord& record, const Tolerances& tol);

/// Proves posted programs against the plan they belong to: reads them as the controller will and checks for
/// every operation, from lines and arcs themselves,
/// - that the cutter keeps off the feature's obstruction (within `tol.gouge_mm`) and off the floor below,
/// - that nothing of the target stays but what the plan names,
/// - that a mill goes nowhere deeper than the planned step-down below what it or others cut there before,
/// - that rapids meet no material that is still there when they run,
/// - that shank and holder keep off material that is still there,
/// - that drills go as deep as planned, in pecks no deeper than planned, and stay at the bottom as planned,
/// - that the machine is set as planned at every motion: tool, length offset, work offset, modes, spindle,
///   coolant; that tools change over stock and fixtures and all is within the machine's travel,
/// - that feeds, speeds, tools and the order of operations are the plan's.
///
/// Nothing of how paths were made is used. Skins thinner than two `tol.sliver_mm` count as cut.
/// \throws Error(InvalidCatalog) for a plan.json or a program that cannot be read.
/// \see docs/adr/0006-proof-from-the-files.md for what the regions themselves rest on
Verification verifyRecorded(const RecordedPlan& plan, const Tolerances& tol);

/// The same of a plan.json that is not read yet.
Verification verifyPlan(const PlanFiles& files, const Tolerances& tol);

/// The same for the programs of one setup; adds to `into`.
void verifySetup(const PlanRecord& record, const RecordedSetup& setup,
                 const std::vector<ReadProgram>& programs, const Tolerances& tol, Verification& into);

/// For the terminal: a line an operation, then what fails.
std::string verificationText(const Verification& verification);
/// The same for programs, checked against schemas/verify.schema.json before it leaves.
/// \throws Error(Internal) if it breaks the schema
std::string verificationJson(const Verification& verification);

}  // namespace stepmill
