#pragma once

#include <string>

#include "sample_parts.h"
#include "support/dice.h"

namespace stepmill::test {

/// A plate of 50 to 120 mm, 14 to 24 mm thick, with rounded corners, which are cut down beside all its sides,
/// one or two windows and one or two through holes. `about` lists them.
SamplePart randomPlate(const std::string& name, Dice& dice);

}  // namespace stepmill::test
