#pragma once

#include <random>

#include "support/clearing_tasks.h"

namespace stepmill::test {

/// Up to five rounded rectangles and discs joined, with up to two islands taken out.
inline Region randomTarget(std::mt19937& random, const Tolerances& tol) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto shape = [&](double smallest, double largest) {
        const Vec2 at(between(0, 50), between(0, 40));
        if (between(0, 1) < 0.4) return makeCircle(at, between(smallest, largest) / 2);
        const Vec2 size(between(smallest, largest), between(smallest, largest));
        return makeRoundedRectangle(at - size / 2, at + size / 2,
                                    between(0, 1) < 0.5 ? 0 : between(0, 0.5) * size.minCoeff());
    };
    Region target = shape(20, 40);
    const int joined = static_cast<int>(between(0, 5));
    for (int i = 0; i < joined; ++i)
        target = unite(target, shape(10, 35), tol);
    const int islands = static_cast<int>(between(0, 3));
    for (int i = 0; i < islands; ++i)
        target = subtract(target, shape(3, 10), tol);
    return target;
}

/// A block around the target, cut away on a random half of its sides.
inline Region randomObstruction(std::mt19937& random, const Region& target, const Tolerances& tol) {
    const Box2 box = boundingBox(target);
    const Vec2 size = box.sizes();
    Region obstruction =
        subtract(makeRectangle(box.min() - Vec2(15, 15), box.max() + Vec2(15, 15)), target, tol);
    const double cut = 12;
    const Vec2 lows[4] = {{box.min().x() - 20, box.min().y() - 20},
                          {box.max().x() - cut, box.min().y() - 20},
                          {box.min().x() - 20, box.min().y() - 20},
                          {box.min().x() - 20, box.max().y() - cut}};
    const Vec2 sizes[4] = {{20 + cut, size.y() + 40},
                           {20 + cut, size.y() + 40},
                           {size.x() + 40, 20 + cut},
                           {size.x() + 40, 20 + cut}};
    for (int side = 0; side < 4; ++side)
        if (random() % 4 == 0)
            obstruction = subtract(obstruction, makeRectangle(lows[side], lows[side] + sizes[side]), tol);
    return obstruction;
}

}  // namespace stepmill::test
