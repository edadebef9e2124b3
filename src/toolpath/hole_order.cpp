// The order in which the holes of a group are visited.

#include <algorithm>
#include <tuple>
#include <utility>

#include "stepmill/toolpath/toolpath.h"

namespace stepmill {
namespace {

/// A change must shorten the way by more than rounding [mm].
constexpr double kShorterMm = 1e-6;
/// Rounds over all pairs of stretches; groups of common size settle in two or three.
constexpr int kMostRounds = 20;

double apart(const Vec2& a, const Vec2& b) {
    return (a - b).norm();
}

void nearestNext(std::vector<Vec2>& places) {
    const auto first = std::min_element(places.begin(), places.end(), [](const Vec2& a, const Vec2& b) {
        return std::pair(a.x() + a.y(), a.x()) < std::pair(b.x() + b.y(), b.x());
    });
    std::iter_swap(places.begin(), first);
    for (std::size_t i = 1; i < places.size(); ++i) {
        const auto begin = places.begin() + static_cast<std::ptrdiff_t>(i);
        const Vec2 here = places[i - 1];
        const auto next = std::min_element(begin, places.end(), [&](const Vec2& a, const Vec2& b) {
            return std::tuple(apart(a, here), a.x(), a.y()) < std::tuple(apart(b, here), b.x(), b.y());
        });
        std::iter_swap(begin, next);
    }
}

/// What turning the stretch from i to k round saves; the way may end anywhere.
double savedBy(const std::vector<Vec2>& places, std::size_t i, std::size_t k) {
    double saved = apart(places[i - 1], places[i]) - apart(places[i - 1], places[k]);
    if (k + 1 < places.size()) saved += apart(places[k], places[k + 1]) - apart(places[i], places[k + 1]);
    return saved;
}

bool turnStretches(std::vector<Vec2>& places) {
    bool shorter = false;
    for (std::size_t i = 1; i + 1 < places.size(); ++i)
        for (std::size_t k = i + 1; k < places.size(); ++k)
            if (savedBy(places, i, k) > kShorterMm) {
                std::reverse(places.begin() + static_cast<std::ptrdiff_t>(i),
                             places.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                shorter = true;
            }
    return shorter;
}

}  // namespace

std::vector<Vec2> shortestTour(std::vector<Vec2> places) {
    if (places.size() < 3) return places;
    nearestNext(places);
    for (int round = 0; round < kMostRounds && turnStretches(places); ++round) {
    }
    return places;
}

}  // namespace stepmill
