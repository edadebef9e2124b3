#include "report/page/chart_parts.h"

#include <cmath>

#include "report/page/words.h"

namespace stepmill::report {

double niceStep(double range, int most) {
    const double rough = range / most;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough) return factor * power;
    return 10 * power;
}

Element lineFrom(Tag tag, const Vec2& from, const Vec2& to) {
    return Element(tag)
        .with("x1", fixed(from.x(), 2))
        .with("y1", fixed(from.y(), 2))
        .with("x2", fixed(to.x(), 2))
        .with("y2", fixed(to.y(), 2));
}

Element textAt(Tag tag, const Vec2& at, const std::string& words) {
    return Element(tag, words).with("x", fixed(at.x(), 2)).with("y", fixed(at.y(), 2));
}

}  // namespace stepmill::report
