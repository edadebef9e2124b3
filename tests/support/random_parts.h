#pragma once

#include <string>
#include <vector>

#include "sample_parts.h"
#include "support/dice.h"

namespace stepmill::test {

/// A block of 40 to 160 mm with what shops cut into blocks, from one to three sides: pockets (closed, open,
/// nested, with islands, some with drafted walls), windows, slots, steps, bosses, holes (blind, through,
/// pointed, in pocket floors, beside walls, across other cuts). Features may meet and cross; what would leave
/// no single solid is left out. `about` lists what was cut.
SamplePart randomPart(const std::string& name, Dice& dice);

}  // namespace stepmill::test
