// Free curves as lines and arcs that never take material away.

#include "layers/section/curve_fit.h"

namespace stepmill::layers {

namespace {

Vec2 rightOf(const Vec2& direction) {
    return Vec2(direction.y(), -direction.x());
}

class Fitter {
  public:
    Fitter(const std::vector<Vec2>& points, double tolerance_mm) : true_(points), tolerance_(tolerance_mm) {
        pushOut();
    }

    std::vector<Segment> run() {
        std::vector<Segment> out;
        std::size_t from = 0;
        while (from + 1 < true_.size()) {
            std::size_t to = from + 1;
            Segment best{pushed_[to], std::nullopt};
            // Double the reach while pieces fit, then halve the step back to the farthest that does.
            for (std::size_t step = 1; step > 0;) {
                const std::size_t tried = to + step;
                if (const auto piece = tried < true_.size() ? fit(from, tried) : std::nullopt) {
                    to = tried;
                    best = *piece;
                    step *= 2;
                } else {
                    step /= 2;
                }
            }
            out.push_back(best);
            from = to;
        }
        return out;
    }

  private:
    /// Target points: on the right of the curve by half the tolerance, by nothing at both ends.
    void pushOut() {
        const std::size_t n = true_.size();
        std::vector<double> along(n, 0);
        for (std::size_t i = 1; i < n; ++i)
            along[i] = along[i - 1] + (true_[i] - true_[i - 1]).norm();
        const double taper = 0.1 * along.back();
        pushed_ = true_;
        for (std::size_t i = 1; i + 1 < n; ++i) {
            const double from_end = std::min(along[i], along.back() - along[i]);
            const double by = 0.5 * tolerance_ * std::min(1.0, from_end / taper);
            pushed_[i] += by * rightOf((true_[i + 1] - true_[i - 1]).normalized());
        }
        for (Vec2& p : pushed_)
            p = snapToGrid(p);
    }

    std::optional<Segment> fit(std::size_t i, std::size_t j) const {
        if (const auto line = fitLine(i, j)) return line;
        return fitArc(i, j);
    }

    bool accepts(double outside_mm) const {
        return outside_mm >= -0.05 * tolerance_ && outside_mm <= tolerance_;
    }

    std::optional<Segment> fitLine(std::size_t i, std::size_t j) const {
        const Vec2 chord = pushed_[j] - pushed_[i];
        if (chord.norm() < kGridMm) return std::nullopt;
        const Vec2 right = rightOf(chord.normalized());
        for (std::size_t k = i; k <= j; ++k) {
            if (!accepts((pushed_[i] - true_[k]).dot(right))) return std::nullopt;
            if (k > i && (true_[k] - true_[k - 1]).dot(chord) < 0) return std::nullopt;
        }
        return Segment{pushed_[j], std::nullopt};
    }

    std::optional<Segment> fitArc(std::size_t i, std::size_t j) const {
        const Vec2& p = pushed_[i];
        const Vec2 a = pushed_[(i + j) / 2] - p;
        const Vec2 b = pushed_[j] - p;
        const double twice_area = cross(a, b);
        // More than a third of a turn, or nearly straight: not this way.
        if (a.dot(b - a) < 0 || std::abs(twice_area) < 1e-12) return std::nullopt;
        Vec2 centre = p + Vec2(b.y() * a.squaredNorm() - a.y() * b.squaredNorm(),
                               a.x() * b.squaredNorm() - b.x() * a.squaredNorm()) /
                              (2 * twice_area);
        constexpr double kLargestRadius = 1e4;
        if ((centre - p).norm() > kLargestRadius) return std::nullopt;
        centre = snapToGrid(centre);
        const double radius = snapToGrid(((p - centre).norm() + (pushed_[j] - centre).norm()) / 2);
        const bool ccw = twice_area > 0;
        for (std::size_t k = i; k <= j; ++k) {
            const double beyond = radius - (true_[k] - centre).norm();
            if (!accepts(ccw ? beyond : -beyond)) return std::nullopt;
            if (k == i) continue;
            const double turn = cross(true_[k - 1] - centre, true_[k] - centre);
            if (ccw ? turn < 0 : turn > 0) return std::nullopt;
        }
        return Segment{pushed_[j], Arc{centre, radius, ccw}};
    }

    const std::vector<Vec2>& true_;
    std::vector<Vec2> pushed_;
    double tolerance_;
};

}  // namespace

std::vector<Segment> fitSafeSide(const std::vector<Vec2>& points, double tolerance_mm) {
    if (points.size() < 2) return {};
    return Fitter(points, tolerance_mm).run();
}

}  // namespace stepmill::layers
