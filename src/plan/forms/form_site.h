#pragma once

#include <optional>
#include <vector>

#include "stepmill/core/deadline.h"
#include "stepmill/feature/form_ground.h"
#include "stepmill/layers/hole_cone.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/setup/prism.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// What a setup's form ground is made of.
struct FormSources {
    const Setup& setup;  ///< with its fixtures
    const LayerStack& layers;
    const Stock& after;               ///< as the setup's flat operations leave it
    const Stock& at_end;              ///< as those of all setups leave it
    std::vector<Prism> drilled = {};  ///< around the points of blind holes that drills make as they are
};

/// A form ground, and how its walls lean.
struct FormSite {
    FormGround ground;
    /// Of each band that must stand the leans of its faces that look up, as sines from upright, ascending.
    std::vector<std::vector<double>> leans;
    std::vector<double> feet_mm;  ///< where layers with stairs end below, ascending
    std::vector<HoleCone> cones;  ///< of holes, as far as the walls are the part's own
};

/// The stairs that flat layers leave in a setup, with what must stand beside them, cut so fine that a band's
/// height times the sine of its wall's lean is no more than `skin_mm`.
/// \param widest_mm  radius of the widest cutter that may come
/// \return nothing where no leaning wall keeps material
/// \throws Error(TimedOut) soon after the deadline
std::optional<FormSite> formSite(const FormSources& sources, double skin_mm, double widest_mm,
                                 const Tolerances& tol, const Deadline& deadline);

}  // namespace stepmill
