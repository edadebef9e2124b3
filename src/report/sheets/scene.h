#pragma once

#include <cstdint>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "stepmill/part/part.h"
#include "stepmill/setup/prism.h"
#include "stepmill/setup/setup.h"

namespace stepmill::report {

/// What a body is to the stock of a picture.
enum class BodyKind : std::uint8_t {
    Raw,      ///< the raw stock
    Cut,      ///< taken from it before
    CutHere,  ///< taken from it in this setup
    Fixture   ///< what holds it
};

/// A flat piece of a body's surface: loops whose insides count by turns, all in one plane.
struct Patch {
    std::vector<std::vector<Vec3>> loops;
    Vec3 normal = Vec3::UnitZ();  ///< out of the body
};

/// A closed body in setup coordinates [mm].
struct Body {
    BodyKind kind = BodyKind::Raw;
    std::vector<Patch> patches;
};

/// A prism as a body, its arcs as chords no farther off than that; `placed` takes its coordinates to the
/// setup's.
Body prismBody(BodyKind kind, const Prism& prism, const Eigen::Isometry3d& placed, double chord_mm);

/// The facets of a solid as a body.
/// \param solid  with facets
Body facetBody(BodyKind kind, const TopoDS_Shape& solid, const Eigen::Isometry3d& placed);

/// The stock as it arrives in a setup: its raw solid, and all that was cut from it before.
/// \param chord_mm  chords and facets are no farther off than that
std::vector<Body> arrivingStock(const Setup& setup, double chord_mm);

}  // namespace stepmill::report
