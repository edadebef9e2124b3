#pragma once

#include <string>
#include <vector>

#include "stepmill/verify/verify.h"

namespace stepmill::test {

/// What fails, "line: text" one below the other.
inline std::string joined(const std::vector<ProofFailure>& failures) {
    std::string all;
    for (const ProofFailure& failure : failures)
        all += std::to_string(failure.line) + ": " + failure.text + "\n";
    return all;
}

}  // namespace stepmill::test
