#pragma once

#include "stepmill/core/tolerances.h"

namespace stepmill::test {

/// Those of the program, which tests ask for unless a test is about others.
inline const Tolerances kTol;

}  // namespace stepmill::test
