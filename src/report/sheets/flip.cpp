#include "report/sheets/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "stepmill/core/units.h"

namespace stepmill::report {
namespace {

/// Directions closer than this are the same [about a thousandth of a degree].
constexpr double kSameDirection = 1e-5;

/// Quarter turns about an axis of the machine, right-handed.
struct Turn {
    int axis = 0;
    int quarters = 1;

    Eigen::Matrix3d matrix() const {
        return Eigen::AngleAxisd(quarters * kPi / 2, Vec3(Vec3::Unit(axis))).toRotationMatrix();
    }
};

bool isSame(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
    return (a - b).cwiseAbs().maxCoeff() < kSameDirection;
}

std::vector<Turn> allTurns() {
    std::vector<Turn> turns;
    for (const int quarters : {2, 1, 3})
        for (int axis = 0; axis < 3; ++axis)
            turns.push_back({axis, quarters});
    return turns;
}

/// One turn or two that together are the rotation; nothing where it is no matter of quarters.
std::optional<std::vector<Turn>> turnsOf(const Eigen::Matrix3d& rotation) {
    if (isSame(rotation, Eigen::Matrix3d::Identity())) return std::vector<Turn>{};
    for (const Turn& turn : allTurns())
        if (isSame(rotation, turn.matrix())) return std::vector<Turn>{turn};
    for (const Turn& first : allTurns())
        for (const Turn& second : allTurns())
            if (isSame(rotation, second.matrix() * first.matrix())) return std::vector<Turn>{first, second};
    return std::nullopt;
}

std::string turnWords(const Turn& turn) {
    static constexpr const char* kAxes = "XYZ";
    /// By axis: the first quarter, the third.
    static constexpr std::array<std::array<const char*, 2>, 3> kWays{
        {{"the top comes to the front", "the top goes to the back"},
         {"the top goes to the right", "the top goes to the left"},
         {"counter-clockwise from above", "clockwise from above"}}};
    const char axis = kAxes[turn.axis];
    if (turn.quarters == 2) return fmt::format("half a turn about {}", axis);
    return fmt::format("a quarter turn about {} ({})", axis, kWays[turn.axis][turn.quarters == 1 ? 0 : 1]);
}

std::string turnsWords(const std::optional<std::vector<Turn>>& turns, const Eigen::Matrix3d& rotation) {
    if (!turns) {
        const Eigen::AngleAxisd turn(rotation);
        return fmt::format("{:.2f}° about ({:.4f}, {:.4f}, {:.4f}): a sine vise or a rotary axis",
                           radToDeg(turn.angle()), turn.axis().x(), turn.axis().y(), turn.axis().z());
    }
    if (turns->empty()) return "no turn";
    std::string words = turnWords(turns->front());
    if (turns->size() > 1) words += ", then " + turnWords(turns->back());
    return words;
}

}  // namespace

std::string sideWords(const Vec3& direction) {
    static constexpr std::array<const char*, 3> kAhead{"at the right", "at the back", "on top"};
    static constexpr std::array<const char*, 3> kBehind{"at the left", "at the front", "underneath"};
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(direction[axis] - 1) < kSameDirection) return kAhead[axis];
        if (std::abs(direction[axis] + 1) < kSameDirection) return kBehind[axis];
    }
    return {};
}

bool isSquare(const Setup& setup) {
    return turnsOf(setup.part_to_setup.linear()).has_value();
}

std::string tiltWords(const Setup& setup) {
    Eigen::Index nearest = 0;
    const double along = setup.axis.cwiseAbs().maxCoeff(&nearest);
    return fmt::format("{:.2f}° off its {}{}", radToDeg(std::acos(std::min(1.0, along))),
                       setup.axis[nearest] > 0 ? '+' : '-', "xyz"[nearest]);
}

std::string flipWords(const Setup& before, const Setup& now) {
    const Eigen::Matrix3d rotation = now.part_to_setup.linear() * before.part_to_setup.linear().transpose();
    std::string words = turnsWords(turnsOf(rotation), rotation) + ".";
    const std::string was_down = sideWords(rotation * -Vec3::UnitZ());
    const std::string was_up = sideWords(rotation * Vec3::UnitZ());
    if (!was_down.empty())
        words += fmt::format(" The face that was down in {} is {}, the one that was up is {}.", before.id,
                             was_down, was_up);
    words[0] = static_cast<char>(std::toupper(words[0]));
    return words;
}

}  // namespace stepmill::report
