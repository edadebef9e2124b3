#pragma once

#include <string>

#include "stepmill/setup/setup.h"

namespace stepmill::report {

/// How the part is turned from one setup to the next in plain words: "Half a turn about X. The face that was
/// down in S1 is on top." X, Y and Z are the machine's.
std::string flipWords(const Setup& before, const Setup& now);

/// A direction along an axis as the operator in front of the machine sees it: "on top", "at the front"; empty
/// for one that is askew.
std::string sideWords(const Vec3& direction);

/// Do the part's axes lie along the setup's?
bool isSquare(const Setup& setup);

/// How the tool stands to a part that is tilted in its setup: "30.00° off its +z".
std::string tiltWords(const Setup& setup);

}  // namespace stepmill::report
