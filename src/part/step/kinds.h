#pragma once

#include <cstdint>
#include <string_view>

namespace stepmill {

/// Entities that make up the shape: numbers in them must be plausible, references must not dangle.
bool isShapeEntity(std::string_view keyword);

/// Entities that claim to be solids.
bool isSolidBody(std::string_view keyword);

/// What an entity of the shape may stand for.
enum class StepClass : std::uint8_t {
    Other,
    Point,
    Direction,
    Vector,
    Placement,
    Axis,
    Curve,
    Surface,
    Vertex,
    Edge,
    OrientedEdge,
    Loop,
    Bound,
    Face,
    Shell,
    Solid
};

StepClass classOf(std::string_view keyword);

/// "a CARTESIAN_POINT", "a curve", ... for messages.
std::string_view nameOf(StepClass kind);

}  // namespace stepmill
