#pragma once

#include <string>

#include "part/step/model.h"
#include "part/step/text.h"

namespace stepmill {

/// What the checks of a file's entities share.
struct StepScreen {
    const StepModel& model;
    const std::string& file;

    /// "line 12: #168 VECTOR <message>".
    [[noreturn]] void refuse(ErrorCode code, const StepEntity& entity, const std::string& message) const;
    /// "#168 VECTOR".
    std::string nameOf(const StepEntity& entity) const;
};

/// References lead somewhere, no entity contains itself, none is nested too deep for a reader that recurses.
/// Dangling references outside the shape are a remark.
/// \throws Error(StepDamaged)
void checkReferences(const StepScreen& screen, StepText& text);

/// The entities of the shape have the parameters their schema asks for: their number, kind and, of
/// references, what they refer to; lengths, radii and angles are those of real curves and surfaces.
/// \throws Error(StepDamaged)
void checkParameters(const StepScreen& screen);

/// Knots increase, multiplicities, control points and weights agree in number, weights are positive.
/// \throws Error(StepDamaged)
void checkSplines(const StepScreen& screen);

/// Loops run from vertex to vertex and every edge of a closed shell is used once in each direction.
/// Notes the solids and what they hold; faces turned against their neighbours are a doubt.
/// \throws Error(StepDamaged, OpenShell)
void checkShells(const StepScreen& screen, StepText& text);

/// Units that are not what their names say, an uncertainty no part has, solids without a representation
/// (so without units) are doubts.
void checkContext(const StepScreen& screen, StepText& text);

}  // namespace stepmill
