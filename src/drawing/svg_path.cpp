#include "drawing/svg_path.h"

#include <cctype>
#include <cmath>
#include <stdexcept>

#include "drawing/svg_numbers.h"
#include "stepmill/core/units.h"

namespace stepmill::drawing {
namespace {

Stroke lineTo(const Vec2& from, const Vec2& to) {
    Stroke line;
    line.from = from;
    line.to = to;
    return line;
}

/// Draws commands one after another.
class SvgPen {
  public:
    explicit SvgPen(const std::string& data) : numbers_(data) {}

    std::vector<Stroke> draw() {
        char command = '\0';
        while (numbers_.peek() != '\0') {
            if (std::isalpha(static_cast<unsigned char>(numbers_.peek())) != 0)
                command = numbers_.take();
            else if (command == 'z' || command == 'Z' || command == '\0')
                throw std::invalid_argument("expected a path's command such as M or L");
            relative_ = std::islower(static_cast<unsigned char>(command)) != 0;
            obey(static_cast<char>(std::toupper(static_cast<unsigned char>(command))));
            if (command == 'M') command = 'L';  // more points of a move are lines
            if (command == 'm') command = 'l';
            if (strokes_.size() > kMostStrokes) throw std::invalid_argument("expected fewer lines in a path");
        }
        return std::move(strokes_);
    }

  private:
    Vec2 point() {
        const double x = numbers_.need();
        const double y = numbers_.need();
        return relative_ ? Vec2(at_ + Vec2(x, y)) : Vec2(x, y);
    }

    void obey(char command) {
        const Vec2 last_control = control_;
        const char last_command = last_;
        last_ = command;
        control_ = at_;
        switch (command) {
            case 'M':
                at_ = begin_ = point();
                return;
            case 'Z':
                line(begin_);
                return;
            case 'L':
                return line(point());
            case 'H':
                return line({numbers_.need() + (relative_ ? at_.x() : 0), at_.y()});
            case 'V':
                return line({at_.x(), numbers_.need() + (relative_ ? at_.y() : 0)});
            case 'C': {
                const Vec2 first = point();
                return cubic(first);
            }
            case 'S':
                return cubic(last_command == 'C' || last_command == 'S' ? Vec2(2 * at_ - last_control) : at_);
            case 'Q': {
                const Vec2 first = point();
                return quadratic(first);
            }
            case 'T':
                return quadratic(last_command == 'Q' || last_command == 'T' ? Vec2(2 * at_ - last_control)
                                                                            : at_);
            case 'A':
                return arc();
            default:
                throw std::invalid_argument(std::string("expected a path's command, found '") + command +
                                            "'");
        }
    }

    void line(const Vec2& to) {
        if (to != at_) strokes_.push_back(lineTo(at_, to));
        at_ = to;
    }

    void cubic(const Vec2& first) {
        const Vec2 second = point();
        const Vec2 to = point();
        strokes_.push_back(bezier({at_, first, second, to}));
        control_ = second;
        at_ = to;
    }

    void quadratic(const Vec2& first) {
        const Vec2 to = point();
        strokes_.push_back(bezier({at_, first, to}));
        control_ = first;
        at_ = to;
    }

    void arc() {
        const double rx = numbers_.need();
        const double ry = numbers_.need();
        const double turned = degToRad(numbers_.need());
        const bool large = numbers_.flag();
        const bool positive = numbers_.flag();
        const Vec2 to = point();
        for (Stroke& stroke : svgArc(at_, rx, ry, turned, large, positive, to))
            strokes_.push_back(std::move(stroke));
        at_ = to;
    }

    SvgNumbers numbers_;
    bool relative_ = false;
    Vec2 begin_ = Vec2::Zero();
    Vec2 at_ = Vec2::Zero();
    Vec2 control_ = Vec2::Zero();
    char last_ = '\0';
    std::vector<Stroke> strokes_;
};

}  // namespace

std::vector<Stroke> svgArc(const Vec2& from, double rx, double ry, double turned_rad, bool large,
                           bool positive, const Vec2& to) {
    rx = std::abs(rx);
    ry = std::abs(ry);
    if (from == to) return {};
    if (rx == 0 || ry == 0) return {lineTo(from, to)};
    // On the unit circle that the ellipse is a picture of.
    const Eigen::Rotation2Dd turn(turned_rad);
    const Vec2 half = turn.inverse() * Vec2((from - to) / 2);
    double x = half.x() / rx;
    double y = half.y() / ry;
    const double square = x * x + y * y;
    if (square > 1) {  // radii too small for the ends grow
        rx *= std::sqrt(square);
        ry *= std::sqrt(square);
        x /= std::sqrt(square);
        y /= std::sqrt(square);
    }
    const double off = std::sqrt(std::max(0.0, 1 / std::min(square, 1.0) - 1)) * (large == positive ? -1 : 1);
    const Vec2 centre(off * y, -off * x);
    const double start = std::atan2(y - centre.y(), x - centre.x());
    double sweep = std::atan2(-y - centre.y(), -x - centre.x()) - start;
    if (positive && sweep <= 0) sweep += 2 * kPi;
    if (!positive && sweep >= 0) sweep -= 2 * kPi;
    if (rx == ry) {
        Stroke arc = lineTo(from, to);
        arc.bulge = std::tan(sweep / 4);
        return {arc};
    }
    const Vec2 middle = (from + to) / 2 + turn * Vec2(rx * centre.x(), ry * centre.y());
    std::vector<Stroke> strokes = ellipseArc(middle, turn * Vec2(rx, 0), turn * Vec2(0, ry), start, sweep);
    return strokes;
}

std::vector<Stroke> svgPath(const std::string& data) {
    return SvgPen(data).draw();
}

}  // namespace stepmill::drawing
