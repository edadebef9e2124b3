#include "feature/form_class.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "stepmill/core/units.h"

namespace stepmill::feature {
namespace {

/// Directions as the file's numbers give them: closer than this they are parallel [rad].
constexpr double kParallelRad = 1e-5;
/// Planes closer than this are one [mm].
constexpr double kSamePlaneMm = 1e-3;

bool parallel(const Vec3& a, const Vec3& b) {
    return a.cross(b).norm() <= kParallelRad;
}
bool perpendicular(const Vec3& a, const Vec3& b) {
    return std::abs(a.dot(b)) <= kParallelRad;
}

/// A surface of the form: faces in one plane are one side.
struct Side {
    Vec3 normal;
    std::vector<int> faces;
    std::set<int> meets;        ///< sides of the form it meets in inner edges or rounds
    std::set<int> stock_sides;  ///< distinct planes of the stock's skin it borders, by least face
};

class FormNamer {
  public:
    FormNamer(const FaceGraph& graph, const std::vector<bool>& on_stock, const std::vector<int>& faces)
        : graph_(graph), on_stock_(on_stock) {
        for (const int face : faces)
            side_of_[face] = addToSide(face);
        joinSides();
    }

    void name(PartForm& form) const {
        form.sides = static_cast<int>(sides_.size());
        form.square =
            std::all_of(sides_.begin(), sides_.end(), [&](const Side& side) { return isSquare(side); });
        const int floor = floorSide();
        if (floor != kNone) {
            --form.sides;
            form.floor = sides_[floor].faces.front();
        }
        const std::vector<int> walls = wallsBeside(floor);
        form.right_angles = meetSquarely(walls);
        form.form_class = floor != kNone ? withFloor(form, floor, walls) : withoutFloor(walls);
        if (form.sides != 1 || form.form_class != FormClass::ThroughStep) return;
        // Which of two faces is the floor is not told by them: the one that runs out on three sides.
        if (form.square) return;
        const int runs_out = sides_[0].stock_sides.size() >= sides_[1].stock_sides.size() ? 0 : 1;
        form.floor = sides_[runs_out].faces.front();
    }

  private:
    static constexpr int kNone = -1;

    int addToSide(int face) {
        const FaceShape& shape = graph_.faces[face];
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            const FaceShape& first = graph_.faces[sides_[i].faces.front()];
            const bool same = first.surface == "plane" && shape.surface == "plane" &&
                              (shape.axis - first.axis).norm() <= kParallelRad &&
                              std::abs(shape.axis.dot(shape.origin - first.origin)) <= kSamePlaneMm;
            if (!same) continue;
            sides_[i].faces.push_back(face);
            return static_cast<int>(i);
        }
        sides_.push_back({shape.axis, {face}, {}, {}});
        return static_cast<int>(sides_.size()) - 1;
    }

    void joinSides() {
        std::map<int, std::vector<int>> beside_round;
        for (const FaceEdge& edge : graph_.edges) {
            for (const auto& [a, b] : {std::pair(edge.first, edge.second), {edge.second, edge.first}}) {
                const auto side = side_of_.find(a);
                if (side == side_of_.end()) continue;
                if (on_stock_[b]) sides_[side->second].stock_sides.insert(stockPlane(b));
                const auto other = side_of_.find(b);
                if (edge.bend == Bend::Concave && other != side_of_.end())
                    sides_[side->second].meets.insert(other->second);
                if (edge.bend == Bend::Smooth && other == side_of_.end() && graph_.faces[b].hollow)
                    beside_round[b].push_back(side->second);
            }
        }
        for (const auto& [round, beside] : beside_round)
            for (const int a : beside)
                for (const int b : beside)
                    if (a != b) sides_[a].meets.insert(b);
        for (std::size_t i = 0; i < sides_.size(); ++i)
            sides_[i].meets.erase(static_cast<int>(i));
    }

    /// Least face on the stock's skin in the same plane.
    int stockPlane(int face) const {
        const FaceShape& shape = graph_.faces[face];
        for (const FaceShape& other : graph_.faces) {
            if (!on_stock_[other.index] || other.surface != shape.surface) continue;
            if ((other.axis - shape.axis).norm() <= kParallelRad &&
                std::abs(shape.axis.dot(other.origin - shape.origin)) <= kSamePlaneMm)
                return other.index;
        }
        return face;
    }

    /// Parallel to some face of the stock's skin.
    bool isSquare(const Side& side) const {
        return std::any_of(graph_.faces.begin(), graph_.faces.end(), [&](const FaceShape& face) {
            return on_stock_[face.index] && face.surface == "plane" && parallel(face.axis, side.normal);
        });
    }

    /// The side that stands square to all others and meets each of them; of several the one the others
    /// surround best, then the first.
    int floorSide() const {
        int best = kNone;
        for (std::size_t i = 0; i < sides_.size() && sides_.size() > 1; ++i) {
            bool floor = sides_[i].meets.size() + 1 == sides_.size();
            for (std::size_t j = 0; j < sides_.size() && floor; ++j)
                floor = j == i || perpendicular(sides_[i].normal, sides_[j].normal);
            if (!floor) continue;
            const bool better = best == kNone || (surrounded(wallsBeside(static_cast<int>(i))) &&
                                                  !surrounded(wallsBeside(best)));
            if (better) best = static_cast<int>(i);
        }
        return best;
    }

    std::vector<int> wallsBeside(int floor) const {
        std::vector<int> walls;
        for (int i = 0; i < static_cast<int>(sides_.size()); ++i)
            if (i != floor) walls.push_back(i);
        return walls;
    }

    /// Do the walls' normals go all round, so that the walls can close a ring? Walls stand square to one
    /// direction; no gap between neighbouring normals may reach a half turn.
    bool surrounded(const std::vector<int>& walls) const {
        if (walls.size() < 3) return false;
        Vec3 axis = Vec3::Zero();
        for (const int wall : walls)
            if (axis.isZero() && !parallel(sides_[walls[0]].normal, sides_[wall].normal))
                axis = sides_[walls[0]].normal.cross(sides_[wall].normal).normalized();
        if (axis.isZero()) return false;
        const Vec3 x = sides_[walls[0]].normal;
        const Vec3 y = axis.cross(x);
        std::vector<double> angles;
        for (const int wall : walls) {
            const Vec3& n = sides_[wall].normal;
            if (!perpendicular(n, axis)) return false;
            angles.push_back(std::atan2(n.dot(y), n.dot(x)));
        }
        std::sort(angles.begin(), angles.end());
        double widest = 0;
        double before = angles[angles.size() - 1] - 2 * kPi;
        for (const double angle : angles) {
            widest = std::max(widest, angle - before);
            before = angle;
        }
        return widest < kPi - kParallelRad;
    }

    bool meetSquarely(const std::vector<int>& walls) const {
        for (const int a : walls)
            for (const int b : walls)
                if (a < b && !parallel(sides_[a].normal, sides_[b].normal) &&
                    !perpendicular(sides_[a].normal, sides_[b].normal))
                    return false;
        return true;
    }

    FormClass withFloor(const PartForm& form, int floor, const std::vector<int>& walls) const {
        if (walls.size() == 1)
            return form.square || runsThrough(floor, walls[0]) ? FormClass::ThroughStep
                                                               : FormClass::BlindStep;
        if (surrounded(walls)) return FormClass::Pocket;
        if (walls.size() == 2) {
            if (parallel(sides_[walls[0]].normal, sides_[walls[1]].normal)) return FormClass::ThroughSlot;
            return form.right_angles ? FormClass::BlindStep : FormClass::ThroughStep;
        }
        if (walls.size() == 3 && form.right_angles) return FormClass::BlindSlot;
        return FormClass::Open;
    }

    /// Of the two faces of a step the one parallel to the stock is its floor; it runs out on three sides of
    /// a step that goes through, on two of one across a corner.
    bool runsThrough(int a, int b) const {
        const Side& flat = isSquare(sides_[a]) ? sides_[a] : sides_[b];
        return flat.stock_sides.size() >= 3;
    }

    FormClass withoutFloor(const std::vector<int>& walls) const {
        if (walls.size() == 1)
            return graph_.faces[sides_[0].faces.front()].surface == "plane" && !sides_[0].normal.isZero() &&
                           !isSquare(sides_[0])
                       ? FormClass::Chamfer
                       : FormClass::Open;
        if (walls.size() == 2) return FormClass::VSlot;
        return surrounded(walls) ? FormClass::Passage : FormClass::Open;
    }

    const FaceGraph& graph_;
    const std::vector<bool>& on_stock_;
    std::vector<Side> sides_;
    std::map<int, int> side_of_;
};

}  // namespace

PartForm nameForm(const FaceGraph& graph, const std::vector<bool>& on_stock, std::vector<int> faces) {
    PartForm form;
    form.flat = std::all_of(faces.begin(), faces.end(),
                            [&](int face) { return graph.faces[face].surface == "plane"; });
    form.faces = std::move(faces);
    if (form.flat) {
        FormNamer(graph, on_stock, form.faces).name(form);
    } else {
        form.square = false;
        form.right_angles = false;
    }
    return form;
}

}  // namespace stepmill::feature
