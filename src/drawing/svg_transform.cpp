#include "drawing/svg_transform.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "drawing/svg_numbers.h"
#include "stepmill/core/units.h"

namespace stepmill::drawing {
namespace {

using Affine = Eigen::Affine2d;

Affine fromMatrix(const std::vector<double>& v) {
    Affine affine;
    affine.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0, 0, 1;
    return affine;
}

Affine fromWord(const std::string& word, const std::vector<double>& v) {
    const std::size_t n = v.size();
    if (word == "matrix" && n == 6) return fromMatrix(v);
    if (word == "translate" && (n == 1 || n == 2)) return fromMatrix({1, 0, 0, 1, v[0], n == 2 ? v[1] : 0});
    if (word == "scale" && (n == 1 || n == 2)) return fromMatrix({v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0});
    if (word == "rotate" && (n == 1 || n == 3)) {
        const double c = std::cos(degToRad(v[0]));
        const double s = std::sin(degToRad(v[0]));
        const double x = n == 3 ? v[1] : 0;
        const double y = n == 3 ? v[2] : 0;
        return fromMatrix({c, s, -s, c, x - c * x + s * y, y - s * x - c * y});
    }
    if (word == "skewX" && n == 1) return fromMatrix({1, 0, std::tan(degToRad(v[0])), 1, 0, 0});
    if (word == "skewY" && n == 1) return fromMatrix({1, std::tan(degToRad(v[0])), 0, 1, 0, 0});
    throw std::invalid_argument(
        "expected matrix, translate, scale, rotate or skew with its numbers, found '" + word.substr(0, 20) +
        "'");
}

}  // namespace

Affine svgTransform(const std::string& text) {
    Affine all = Affine::Identity();
    SvgNumbers rest(text);
    while (rest.peek() != '\0') {
        std::string word;
        while (rest.peek() != '(' && rest.peek() != '\0')
            word += rest.take();
        rest.take();
        std::vector<double> values;
        while (const std::optional<double> value = rest.number())
            values.push_back(*value);
        if (rest.take() != ')') throw std::invalid_argument("expected ')' behind a transform's numbers");
        all = all * fromWord(word, values);
    }
    return all;
}

}  // namespace stepmill::drawing
