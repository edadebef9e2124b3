#include "stepmill/part/square_up.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <BRepBuilderAPI_Transform.hxx>
#include <gp_Trsf.hxx>

#include "part/measure.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

using Turn = Eigen::Matrix3d;

/// Faces turned by less lie along an axis: what layers take for upright and level [rad].
constexpr double kAlongRad = 1e-6;
/// Directions closer than this are one: more than rounding in files, less than any draft [rad].
constexpr double kSameRad = 1e-4;
/// A direction counts that has at least this share of what the largest has.
constexpr double kWorthShare = 1e-3;
/// A part that has one axis already is turned about it where its frame holds this share of all that lies
/// across: of a hexagon no side is worth more than another, nor of two flats that taper.
constexpr double kFrameShare = 0.6;
/// Turns by less are none [sine].
constexpr double kNoTurn = 1e-12;

/// A line that faces look or turn along, whichever way.
struct Lie {
    Vec3 along;
    double area_mm2 = 0;
    double largest_mm2 = 0;  ///< of its faces: that one says where it points
};

bool isAlong(const Vec3& a, const Vec3& b, double angle_rad) {
    return a.cross(b).norm() < angle_rad;
}

bool isAcross(const Vec3& a, const Vec3& b, double angle_rad) {
    return std::abs(a.dot(b)) < angle_rad;
}

/// By falling area.
std::vector<Lie> liesOf(const TopoDS_Shape& solid) {
    std::vector<Lie> lies;
    for (const TopoDS_Face& face : facesOf(solid)) {
        const std::optional<Vec3> along = axisOf(face);
        if (!along) continue;
        const double mm2 = areaOf(face);
        auto known = std::find_if(lies.begin(), lies.end(),
                                  [&](const Lie& lie) { return isAlong(lie.along, *along, kSameRad); });
        if (known == lies.end()) known = lies.insert(lies.end(), Lie{*along, 0, 0});
        known->area_mm2 += mm2;
        if (mm2 <= known->largest_mm2) continue;
        known->largest_mm2 = mm2;
        known->along = *along;
    }
    std::stable_sort(lies.begin(), lies.end(),
                     [](const Lie& a, const Lie& b) { return a.area_mm2 > b.area_mm2; });
    if (!lies.empty())
        std::erase_if(lies, [&, least = kWorthShare * lies.front().area_mm2](const Lie& lie) {
            return lie.area_mm2 < least;
        });
    return lies;
}

int axesWithFaces(const std::vector<Lie>& lies) {
    int axes = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto is_along = [&](const Lie& lie) { return isAlong(lie.along, Vec3::Unit(axis), kAlongRad); };
        axes += std::any_of(lies.begin(), lies.end(), is_along) ? 1 : 0;
    }
    return axes;
}

/// Rows: what goes to x, y and z. Of all ways to lie along the axes the one that turns least.
Turn leastTurn(const Vec3& first, const Vec3& second) {
    const std::array<Vec3, 3> frame{first, second, first.cross(second)};
    Turn best = Turn::Identity();
    double most = -4;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            for (const double sign_x : {1.0, -1.0})
                for (const double sign_y : {1.0, -1.0}) {
                    if (x == y) continue;
                    Turn turn;
                    turn.row(0) = sign_x * frame[x];
                    turn.row(1) = sign_y * frame[y];
                    turn.row(2) = turn.row(0).cross(turn.row(1));
                    if (turn.trace() <= most + kNoTurn) continue;
                    most = turn.trace();
                    best = turn;
                }
    return best;
}

/// A direction alone is taken to the axis next to it.
Turn shortestTurn(const Vec3& along) {
    int axis = 0;
    along.cwiseAbs().maxCoeff(&axis);
    const Vec3 to = (along[axis] < 0 ? -1 : 1) * Vec3::Unit(axis);
    return Eigen::Quaterniond::FromTwoVectors(along, to).toRotationMatrix();
}

/// Does most of what lies across the first direction lie along the second or across both?
bool isMostlySquare(const std::vector<Lie>& lies, const Vec3& first, const Vec3& second) {
    double across_mm2 = 0;
    double square_mm2 = 0;
    for (const Lie& lie : lies) {
        if (!isAcross(lie.along, first, kSameRad)) continue;
        across_mm2 += lie.area_mm2;
        if (isAlong(lie.along, second, kSameRad) || isAcross(lie.along, second, kSameRad))
            square_mm2 += lie.area_mm2;
    }
    return square_mm2 >= kFrameShare * across_mm2;
}

TopoDS_Shape turned(const TopoDS_Shape& solid, const Turn& turn) {
    gp_Trsf by;
    by.SetValues(turn(0, 0), turn(0, 1), turn(0, 2), 0, turn(1, 0), turn(1, 1), turn(1, 2), 0, turn(2, 0),
                 turn(2, 1), turn(2, 2), 0);
    return BRepBuilderAPI_Transform(solid, by, Standard_True).Shape();
}

/// Would the blank be larger? An outline with tangent flats at a slant lies well already.
bool enlargesBox(const Turn& turn, const TopoDS_Shape& solid) {
    return boxOf(turned(solid, turn)).volume() > boxOf(solid).volume();
}

std::optional<Turn> squaringTurn(const TopoDS_Shape& solid) {
    const std::vector<Lie> lies = liesOf(solid);
    const int axes = axesWithFaces(lies);
    if (lies.empty() || axes > 1) return std::nullopt;
    const Vec3 first = lies.front().along.normalized();
    const auto across = std::find_if(lies.begin(), lies.end(),
                                     [&](const Lie& lie) { return isAcross(lie.along, first, kSameRad); });
    Turn turn = shortestTurn(first);
    if (across != lies.end()) {
        const Vec3 second = (across->along - across->along.dot(first) * first).normalized();
        if (axes == 1 && !isMostlySquare(lies, first, second)) return std::nullopt;
        turn = leastTurn(first, second);
    }
    if ((turn - Turn::Identity()).norm() < kNoTurn) return std::nullopt;
    if (axes == 1 && enlargesBox(turn, solid)) return std::nullopt;
    return turn;
}

/// \param in_all  from coordinates of the file
void turn(Part& part, const Turn& by, const Turn& in_all) {
    guardOcct(ErrorCode::InvalidSolid, part.file, [&] {
        std::vector<std::string> names;
        for (const PartFace& face : part.faces)
            names.push_back(face.step_name);
        describeShape(part, turned(part.shape->solid, by));
        for (PartFace& face : part.faces)
            face.step_name = names[static_cast<std::size_t>(face.index)];
        part.shape = std::make_shared<const PartShape>(PartShape{part.shape->solid, in_all});
    });
}

}  // namespace

Part squaredUp(Part part) {
    std::optional<Turn> by;
    guardOcct(ErrorCode::InvalidSolid, part.file, [&] { by = squaringTurn(part.shape->solid); });
    if (!by) return part;
    turn(part, *by, *by * part.shape->turned);
    const auto row = [&](int i) {
        return fmt::format("{:.6g},{:.6g},{:.6g}", (*by)(i, 0), (*by)(i, 1), (*by)(i, 2));
    };
    part.remarks.push_back(
        {kTurned,
         fmt::format(
             "the part stands askew in its file and is turned to lie along the axes: its x, y and z are "
             "{}, {} and {} of the file",
             row(0), row(1), row(2))});
    return part;
}

Part turnedLike(Part other, const Part& part) {
    const Turn& is = other.shape->turned;
    const Turn& wanted = part.shape->turned;
    if (is != wanted) turn(other, wanted * is.transpose(), wanted);
    return other;
}

}  // namespace stepmill
