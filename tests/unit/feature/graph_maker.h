#pragma once

#include "stepmill/core/units.h"
#include "stepmill/part/face_graph.h"
#include "stepmill/planar/region.h"

namespace stepmill::test {

/// Builds face graphs by hand.
class GraphMaker {
  public:
    FaceGraph graph;
    std::vector<bool> on_stock;

    /// A plane through `at`.
    /// \return its index
    int plane(const Vec3& at, const Vec3& normal, bool stock = false) {
        FaceShape face;
        face.surface = "plane";
        face.origin = at;
        face.axis = normal.normalized();
        face.samples = {{at, face.axis}};
        return add(std::move(face), stock);
    }

    /// A hollow cylinder about an axis along z, from z0 to z1.
    int bore(const Vec2& at, double radius, double z0, double z1, double angle_rad = 2 * kPi) {
        FaceShape face = round(at, "cylinder", z0, z1);
        face.radius_mm = radius;
        face.angle_rad = angle_rad;
        return add(std::move(face), false);
    }

    /// A hollow cone about an axis along z, wider at the upper end; to its apex when r0 is 0.
    int cone(const Vec2& at, double r0, double z0, double r1, double z1) {
        FaceShape face = round(at, "cone", z0, z1);
        face.half_angle_rad = std::atan2(r1 - r0, z1 - z0);
        face.origin.z() = z1 - r1 / std::tan(face.half_angle_rad);
        face.angle_rad = 2 * kPi;
        face.pointed = r0 == 0;
        if (face.pointed) face.outline.erase(face.outline.begin());
        return add(std::move(face), false);
    }

    void meet(int a, int b, Bend bend, const Vec3& at = Vec3::Zero()) {
        FaceEdge edge;
        edge.first = a;
        edge.second = b;
        edge.bend = bend;
        edge.from = edge.to = at;
        graph.edges.push_back(edge);
    }
    void inner(const std::vector<std::pair<int, int>>& pairs) {
        for (const auto& [a, b] : pairs)
            meet(a, b, Bend::Concave);
    }

  private:
    static FaceShape round(const Vec2& at, const std::string& surface, double z0, double z1) {
        FaceShape face;
        face.surface = surface;
        face.origin = {at.x(), at.y(), z0};
        face.axis = Vec3::UnitZ();
        face.hollow = true;
        face.outline = {{at.x(), at.y(), z0}, {at.x(), at.y(), z1}};
        return face;
    }

    int add(FaceShape face, bool stock) {
        face.index = static_cast<int>(graph.faces.size());
        graph.faces.push_back(std::move(face));
        on_stock.push_back(stock);
        return graph.faces.back().index;
    }
};

}  // namespace stepmill::test
