#pragma once

#include <string>
#include <vector>

#include "stepmill/catalog/fixture.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/part/part.h"
#include "stepmill/setup/prism.h"

namespace stepmill {

/// How a setup's stock can be held: a suggestion, whose jaws the plan keeps clear of.
struct Clamping {
    bool vise = false;
    /// Across the jaws, a unit vector in setup coordinates (z = 0).
    Vec3 across = Vec3::Zero();
    double opening_mm = 0;  ///< between the jaws
    double from_mm = 0;     ///< lower edge of the grip over the stock's bottom: parallels lift it that far
    double depth_mm = 0;    ///< height the jaws hold, from there up
    double length_mm = 0;   ///< of jaw that touches on both sides
    double seat_mm2 = 0;    ///< of the stock's bottom that is flat and stays: what it rests on
    /// Two jaws of an ordinary vise (150 mm wide, 40 mm thick and high), in the middle of what they hold and
    /// grown by kFixtureGrowth, but not into the stock; empty without a vise.
    std::vector<Fixture> jaws;
    /// For the setup sheet: "vise, jaws 80 mm open across x, 12 mm deep", or why none will do.
    std::string text;
};

/// Looks for two opposite, parallel, upright flat sides of the arriving stock with nothing sticking out
/// farther below them, cut nowhere along the jaws' height (grown by kFixtureGrowth), that face each other
/// over enough length. Of several pairs the one with the largest area held, and of equal ones the smaller
/// opening.
///
/// Both solids are given as planar slabs, from the top down, in setup coordinates. Slabs whose walls lean
/// stand as their hull: their sides are no flat sides and are passed over.
/// \param arriving  the stock
/// \param upright   by slab: are all the stock's walls in it upright?
/// \param removed   all the setup cuts
Clamping suggestClamping(const std::vector<Prism>& arriving, const std::vector<bool>& upright,
                         const std::vector<Prism>& removed, const Tolerances& tol);

}  // namespace stepmill
