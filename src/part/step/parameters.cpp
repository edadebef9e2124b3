// What the entities of the shape must be made of.

#include <array>
#include <numbers>

#include <fmt/format.h>

#include "part/step/checks.h"
#include "part/step/kinds.h"

namespace stepmill {
namespace {

/// A direction of less length is none: its ratios are rounding.
constexpr double kShortestDirection = 1e-9;

/// Sine of the angle between the two directions of a placement below which they count as parallel.
constexpr double kParallel = 1e-6;

/// The parameters of an entity, one letter each; after '(' a list of at least one of the letter.
///   s any text or none   n a number   + a number above 0   0 a number of 0 or more   b .T. or .F.   *
///   anything P point  D direction  d direction or none  V vector  A axis placement  I axis  C curve  S
///   surface X vertex  E edge  O oriented edge  L loop  B bound  F face  H shell
struct Rule {
    std::string_view keyword;
    std::string_view parameters;
};

constexpr auto kRules = std::to_array<Rule>({{"ADVANCED_FACE", "s(BSb"},
                                             {"AXIS1_PLACEMENT", "sPd"},
                                             {"AXIS2_PLACEMENT_2D", "sPd"},
                                             {"AXIS2_PLACEMENT_3D", "sPdd"},
                                             {"BREP_WITH_VOIDS", "sH(H"},
                                             {"CARTESIAN_POINT", "s(n"},
                                             {"CIRCLE", "sA+"},
                                             {"CLOSED_SHELL", "s(F"},
                                             {"CONICAL_SURFACE", "sA0+"},
                                             {"CYLINDRICAL_SURFACE", "sA+"},
                                             {"DEGENERATE_TOROIDAL_SURFACE", "sA++b"},
                                             {"DIRECTION", "s(n"},
                                             {"EDGE_CURVE", "sXXCb"},
                                             {"EDGE_LOOP", "s(O"},
                                             {"ELLIPSE", "sA++"},
                                             {"FACETED_BREP", "sH"},
                                             {"FACE_BOUND", "sLb"},
                                             {"FACE_OUTER_BOUND", "sLb"},
                                             {"FACE_SURFACE", "s(BSb"},
                                             {"HYPERBOLA", "sA++"},
                                             {"INTERSECTION_CURVE", "sC(**"},
                                             {"LINE", "sPV"},
                                             {"MANIFOLD_SOLID_BREP", "sH"},
                                             {"OFFSET_SURFACE", "sSn*"},
                                             {"OPEN_SHELL", "s(F"},
                                             {"ORIENTED_CLOSED_SHELL", "s*Hb"},
                                             {"ORIENTED_EDGE", "s**Eb"},
                                             {"ORIENTED_FACE", "s*Fb"},
                                             {"PARABOLA", "sA+"},
                                             {"PCURVE", "sS*"},
                                             {"PLANE", "sA"},
                                             {"POLY_LOOP", "s(P"},
                                             {"SEAM_CURVE", "sC(**"},
                                             {"SPHERICAL_SURFACE", "sA+"},
                                             {"SURFACE_CURVE", "sC(**"},
                                             {"SURFACE_OF_LINEAR_EXTRUSION", "sCV"},
                                             {"SURFACE_OF_REVOLUTION", "sCI"},
                                             {"TOROIDAL_SURFACE", "sA++"},
                                             {"TRIMMED_CURVE", "sC(*(*b*"},
                                             {"VECTOR", "sD+"},
                                             {"VERTEX_LOOP", "sX"},
                                             {"VERTEX_POINT", "sP"}});
static_assert(std::is_sorted(kRules.begin(), kRules.end(),
                             [](const Rule& a, const Rule& b) { return a.keyword < b.keyword; }));

const Rule* ruleOf(std::string_view keyword) {
    const auto found = std::lower_bound(kRules.begin(), kRules.end(), keyword,
                                        [](const Rule& a, std::string_view b) { return a.keyword < b; });
    return found != kRules.end() && found->keyword == keyword ? found : nullptr;
}

StepClass classOfLetter(char letter) {
    switch (letter) {
        case 'P':
            return StepClass::Point;
        case 'D':
        case 'd':
            return StepClass::Direction;
        case 'V':
            return StepClass::Vector;
        case 'A':
            return StepClass::Placement;
        case 'I':
            return StepClass::Axis;
        case 'C':
            return StepClass::Curve;
        case 'S':
            return StepClass::Surface;
        case 'X':
            return StepClass::Vertex;
        case 'E':
            return StepClass::Edge;
        case 'O':
            return StepClass::OrientedEdge;
        case 'L':
            return StepClass::Loop;
        case 'B':
            return StepClass::Bound;
        case 'F':
            return StepClass::Face;
        case 'H':
            return StepClass::Shell;
        default:
            return StepClass::Other;
    }
}

std::string shown(double number) {
    return fmt::format("{:g}", number);
}

/// True if angles may be in another unit than radians.
bool namesDegrees(const StepModel& model) {
    return std::any_of(model.entities().begin(), model.entities().end(), [&](const StepEntity& entity) {
        return model.record(entity, "PLANE_ANGLE_UNIT") && model.record(entity, "CONVERSION_BASED_UNIT");
    });
}

class ParameterCheck {
  public:
    explicit ParameterCheck(const StepScreen& screen)
        : screen_(screen), degrees_(namesDegrees(screen.model)) {}

    void check(const StepEntity& entity) {
        for (const StepRecord& record : screen_.model.recordsOf(entity)) {
            // In a complex entity the name stands in a record of its own.
            const Rule* rule = entity.last - entity.first == 1 ? ruleOf(record.keyword) : nullptr;
            if (!rule) continue;
            entity_ = &entity;
            checkValues(screen_.model.valuesOf(record), rule->parameters);
            checkMeaning(record.keyword, screen_.model.valuesOf(record));
        }
    }

  private:
    [[noreturn]] void refuse(const std::string& message) const {
        screen_.refuse(ErrorCode::StepDamaged, *entity_, message);
    }

    void checkValues(const StepValues& values, std::string_view letters) {
        std::size_t place = 0;
        for (std::size_t i = 0; i < letters.size(); ++i, ++place) {
            if (letters[i] == '(')
                checkList(values, place, letters[++i]);
            else
                checkValue(values[place], letters[i], place);
        }
        if (values.size() != place)
            refuse(fmt::format("has {} parameters; {} expected", values.size(), place));
    }

    void checkList(const StepValues& values, std::size_t place, char letter) {
        const StepValues items = values.list(place);
        if (items.empty()) refuse(fmt::format("parameter {}: a list of at least one expected", place + 1));
        const std::size_t count = letter == '*' ? 0 : items.size();
        if (letter == 'n') return checkNumbers(items, place);
        // Walks once: a shell may list thousands of faces.
        std::size_t checked = 0;
        for (const std::uint32_t id : items.references()) {
            checkTarget(id, classOfLetter(letter), place);
            ++checked;
        }
        if (checked < count) refuse(fmt::format("parameter {}: references expected", place + 1));
    }

    void checkNumbers(const StepValues& items, std::size_t place) {
        if (items.numbers().size() != items.size() || items.size() > 3)
            refuse(fmt::format("parameter {}: two or three numbers expected", place + 1));
    }

    void checkValue(const StepValue& value, char letter, std::size_t place) {
        const auto expected = [&](const std::string& what) {
            refuse(fmt::format("parameter {}: {} expected{}", place + 1, what,
                               value.is(StepValue::Kind::Number) ? ", found " + shown(value.number) : ""));
        };
        const bool number = value.is(StepValue::Kind::Number);
        if (letter == '*') return;
        if (letter == 's') {
            if (!value.is(StepValue::Kind::Text) && !value.is(StepValue::Kind::Omitted)) expected("a name");
        } else if (letter == 'n') {
            if (!number) expected("a number");
        } else if (letter == '+') {
            if (!number || !(value.number > 0)) expected("a number above 0");
        } else if (letter == '0') {
            if (!number || !(value.number >= 0)) expected("a number of 0 or more");
        } else if (letter == 'b') {
            if (!value.isTrue() && !value.isFalse()) expected(".T. or .F.");
        } else if (value.is(StepValue::Kind::Reference)) {
            checkTarget(value.word, classOfLetter(letter), place);
        } else if (letter != 'd' || !value.is(StepValue::Kind::Omitted)) {
            expected(std::string(nameOf(classOfLetter(letter))));
        }
    }

    /// A complex entity is of every class its records are of.
    void checkTarget(std::uint32_t id, StepClass wanted, std::size_t place) {
        const StepEntity* target = screen_.model.find(id);
        if (wanted == StepClass::Other || !target || target->first == target->last) return;
        for (const StepRecord& record : screen_.model.recordsOf(*target))
            if (classOf(record.keyword) == wanted) return;
        refuse(fmt::format("parameter {}: {} expected, found {}", place + 1, nameOf(wanted),
                           screen_.nameOf(*target)));
    }

    void checkMeaning(std::string_view keyword, const StepValues& values) {
        if (keyword == "DIRECTION") {
            checkDirection(values.list(1).numbers());
        } else if (keyword == "AXIS2_PLACEMENT_3D") {
            checkAxes(directionOf(values[2]), directionOf(values[3]));
        } else if (keyword == "CONICAL_SURFACE") {
            checkConeAngle(values[3].number);
        }
    }

    void checkDirection(const std::vector<double>& ratios) {
        double square = 0;
        for (const double ratio : ratios)
            square += ratio * ratio;
        if (ratios.size() < 2 || !(std::sqrt(square) > kShortestDirection))
            refuse(fmt::format("has no direction: its length is {:g}", std::sqrt(square)));
    }

    std::optional<Eigen::Vector3d> directionOf(const StepValue& value) const {
        if (!value.is(StepValue::Kind::Reference)) return std::nullopt;
        const StepEntity* target = screen_.model.find(value.word);
        const StepRecord* record = target ? screen_.model.record(*target, "DIRECTION") : nullptr;
        if (!record) return std::nullopt;
        const std::vector<double> ratios = screen_.model.valuesOf(*record).list(1).numbers();
        if (ratios.size() != 3) refuse("has a direction in the plane; one in space expected");
        return Eigen::Vector3d(ratios[0], ratios[1], ratios[2]);
    }

    void checkAxes(const std::optional<Eigen::Vector3d>& axis,
                   const std::optional<Eigen::Vector3d>& reference) {
        if (!axis || !reference) return;
        const double lengths = axis->norm() * reference->norm();
        if (!(axis->cross(*reference).norm() > kParallel * lengths))
            refuse("has an axis and a reference direction that are parallel");
    }

    void checkConeAngle(double angle) {
        const double right_angle = degrees_ ? 90 : std::numbers::pi / 2;
        if (!(angle < right_angle))
            refuse(fmt::format("has a half angle of {:g}; below {:g} expected", angle, right_angle));
    }

    const StepScreen& screen_;
    bool degrees_;
    const StepEntity* entity_ = nullptr;
};

}  // namespace

void checkParameters(const StepScreen& screen) {
    ParameterCheck check(screen);
    for (const StepEntity& entity : screen.model.entities())
        check.check(entity);
}

}  // namespace stepmill
