#pragma once

#include <string>

#include <TopoDS_Shape.hxx>

#include "support/dice.h"
#include "support/form_solids.h"

namespace stepmill::test {

/// Where a form is cut: on a side of a block, z = 0 on it and up out of it.
struct FormRoom {
    Rounded place;          ///< with the radius of its corners, where it has any
    double deep_mm = 0;     ///< of its floor
    double through_mm = 0;  ///< of the whole block
    double length_mm = 0;   ///< of the side, along x
    double beyond_mm = 0;   ///< so far cuts reach out of the block
};

struct FormCut {
    TopoDS_Shape solid;  ///< what is taken away
    std::string about;
};

/// A pocket with draft, with a fillet around its floor, with free sides (upright or leaning) or a free floor;
/// a channel, a dimple. \throws Error(GeometryKernel) where the kernel makes none
FormCut randomForm(const FormRoom& room, Dice& dice);

}  // namespace stepmill::test
