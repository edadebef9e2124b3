#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "drawing_options.h"
#include "stepmill/verify/verify.h"

namespace stepmill {

/// The files a plan was made from, as far as verify is given them.
struct ClaimOptions {
    std::string part_file;
    std::string tools_file;
    std::string machine_file;
    std::string stock_file;
    std::string fixtures_file;
    DrawingWords drawing;  ///< of a part that is drawn
};
void addClaimOptions(CLI::App& verify, ClaimOptions& options);

/// The plan itself against these files; what differs is added to the failures.
/// \throws Error(Usage) naming an option whose file is not the one that was planned with, or is missing
void verifyClaim(const ClaimOptions& options, const RecordedPlan& plan, std::uintmax_t max_bytes,
                 const Tolerances& tol, Verification& verification);

}  // namespace stepmill
