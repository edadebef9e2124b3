#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/core/error.h"

namespace stepmill::test {

/// How planning a part of the corpus ends today.
enum class Outcome {
    Planned,  ///< exit code 0
    Gaps,     ///< exit code 1: a plan that leaves something and says what
    Refused,  ///< exit code 2, with a reason
    TooSlow   ///< gets a plan, but not within its budget
};

/// A row of tests/corpus/expected_outcomes.json.
struct ExpectedOutcome {
    std::string part;  ///< "nist/nist_ctc_01_asme1_rd.stp", as in the table
    std::string path;  ///< of the file; "" where the folder of parts is not beside this checkout
    Outcome outcome = Outcome::Planned;
    /// Planning may take this much processor time [s]: about three times of what it takes.
    double cpu_s = 0;
    std::optional<ErrorCode> refusal;  ///< why the file is not even read; nothing: it is
    int solids = 1;                    ///< in the file, repeats counted
    bool slow = false;         ///< for `make test-all` alone: in suites named Slow, which CI leaves out
    bool slow_proofs = false;  ///< the same of its proofs with finishing passes or in all dialects

    bool hasPlan() const { return outcome == Outcome::Planned || outcome == Outcome::Gaps; }
};

/// Tests are named by the part, not by the bytes of its row.
void PrintTo(const ExpectedOutcome& expected, std::ostream* out);

/// All rows, patterns resolved, in the table's order.
const std::vector<ExpectedOutcome>& expectedOutcomes();

/// The rows of these parts ("nist/nist_ctc_01_asme1_rd.stp"), in the table's order.
std::vector<ExpectedOutcome> expectedRows(const std::vector<std::string>& parts);

/// The rows of these folders ("step_parts", "nist", ...) that get a plan and are not slow.
std::vector<ExpectedOutcome> expectedPlans(const std::vector<std::string>& folders);
/// All rows that get a plan and are slow.
std::vector<ExpectedOutcome> slowPlans();

/// Of some rows those that are, or are not, slow to prove with finishing passes or in all dialects.
std::vector<ExpectedOutcome> withSlowProofs(std::vector<ExpectedOutcome> rows, bool slow);

/// The rows of a folder.
std::vector<ExpectedOutcome> expectedOf(const std::string& folder);

/// The part as a gtest name: letters, digits and underscores.
std::string testName(const ExpectedOutcome& expected);

/// Folder that the table's parts lie in; empty where it is missing.
std::string folderOfParts(const std::string& folder);

}  // namespace stepmill::test

/// Skips a test of a part whose file is not there.
#define STEPMILL_NEEDS_PART(expected) \
    if ((expected).path.empty()) GTEST_SKIP() << "the folder of STEP parts is not beside this checkout"
