// Knots, multiplicities, control points and weights of b-spline curves and surfaces.

#include <fmt/format.h>

#include "part/step/checks.h"

namespace stepmill {
namespace {

/// What geometry kernels take.
constexpr double kHighestDegree = 25;

class SplineCheck {
  public:
    explicit SplineCheck(const StepScreen& screen) : screen_(screen) {}

    void check(const StepEntity& entity) {
        entity_ = &entity;
        if (const StepRecord* knots = find("B_SPLINE_CURVE_WITH_KNOTS")) checkCurve(*knots);
        if (const StepRecord* knots = find("B_SPLINE_SURFACE_WITH_KNOTS")) checkSurface(*knots);
    }

  private:
    [[noreturn]] void refuse(const std::string& message) const {
        screen_.refuse(ErrorCode::StepDamaged, *entity_, message);
    }

    const StepRecord* find(std::string_view keyword) const { return screen_.model.record(*entity_, keyword); }

    /// Parameters of the record that holds degree and control points, from the degree on: a simple entity
    /// has the name first, a complex one keeps them in a record of their own. `knots` is where in the knots'
    /// record multiplicities begin.
    std::pair<StepValues, std::size_t> split(const StepRecord& record, std::string_view base,
                                             std::size_t base_size, std::size_t& first) const {
        const StepRecord* own = find(base);
        first = own ? 0 : 1;
        return {screen_.model.valuesOf(own ? *own : record), own ? 0 : 1 + base_size};
    }

    void checkCurve(const StepRecord& record) {
        constexpr std::size_t kCurveParameters = 5;
        std::size_t first = 0;
        const auto [base, at] = split(record, "B_SPLINE_CURVE", kCurveParameters, first);
        const std::size_t points = base.list(first + 1).size();
        const StepValues knots = screen_.model.valuesOf(record);
        checkKnots(base[first].number, points, knots.list(at), knots.list(at + 1));
        if (const StepRecord* weights = find("RATIONAL_B_SPLINE_CURVE"))
            checkWeights(screen_.model.valuesOf(*weights).list(0), points);
    }

    void checkSurface(const StepRecord& record) {
        constexpr std::size_t kSurfaceParameters = 7;
        std::size_t first = 0;
        const auto [base, at] = split(record, "B_SPLINE_SURFACE", kSurfaceParameters, first);
        const StepValues rows = base.list(first + 2);
        const std::size_t count = rows.size();
        const std::size_t columns = rows.list(0).size();
        for (std::size_t i = 0; i < count; ++i)
            if (rows.list(i).size() != columns) refuse("has rows of control points of unlike length");
        const StepValues knots = screen_.model.valuesOf(record);
        checkKnots(base[first].number, count, knots.list(at), knots.list(at + 2));
        checkKnots(base[first + 1].number, columns, knots.list(at + 1), knots.list(at + 3));
        const StepRecord* weights = find("RATIONAL_B_SPLINE_SURFACE");
        if (!weights) return;
        const StepValues weight_rows = screen_.model.valuesOf(*weights).list(0);
        if (weight_rows.size() != count) refuse("has not one row of weights for each of control points");
        for (std::size_t i = 0; i < count; ++i)
            checkWeights(weight_rows.list(i), columns);
    }

    void checkKnots(double degree, std::size_t points, const StepValues& multiplicities,
                    const StepValues& knots) {
        if (!(degree >= 1) || degree > kHighestDegree || degree != std::floor(degree))
            refuse(fmt::format("has degree {:g}; 1 to {:g} expected", degree, kHighestDegree));
        const std::vector<double> counts = multiplicities.numbers();
        const std::vector<double> places = knots.numbers();
        if (counts.size() != places.size() || counts.size() < 2)
            refuse(fmt::format("has {} knots and {} multiplicities", places.size(), counts.size()));
        double sum = 0;
        for (const double count : counts) {
            if (!(count >= 1) || count > degree + 1 || count != std::floor(count))
                refuse(fmt::format("has a knot of multiplicity {:g}; 1 to {:g} expected", count, degree + 1));
            sum += count;
        }
        for (std::size_t i = 1; i < places.size(); ++i)
            if (!(places[i] > places[i - 1]))
                refuse(
                    fmt::format("has knots that do not increase: {:g} after {:g}", places[i], places[i - 1]));
        const double wanted = static_cast<double>(points) + degree + 1;
        if (sum != wanted)
            refuse(fmt::format("has {} control points of degree {:g} and knots for {:g}", points, degree,
                               sum - degree - 1));
    }

    void checkWeights(const StepValues& list, std::size_t points) {
        const std::vector<double> weights = list.numbers();
        if (weights.size() != points)
            refuse(fmt::format("has {} weights for {} control points", weights.size(), points));
        for (const double weight : weights)
            if (!(weight > 0)) refuse(fmt::format("has the weight {:g}; above 0 expected", weight));
    }

    const StepScreen& screen_;
    const StepEntity* entity_ = nullptr;
};

}  // namespace

void checkSplines(const StepScreen& screen) {
    SplineCheck check(screen);
    for (const StepEntity& entity : screen.model.entities())
        check.check(entity);
}

}  // namespace stepmill
