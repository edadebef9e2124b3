#pragma once

#include <random>

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"
#include "support/grounds.h"

namespace stepmill::test {

/// Seeded random targets with obstructions as sections of parts have them: rounded walls, islands, and where
/// asked a stretch of wall cut away. The same seed gives the same ground on every machine.
class RandomGround {
  public:
    explicit RandomGround(unsigned seed) : engine_(seed) {}

    double number(double from, double to) {
        // Not std::uniform_real_distribution, whose results differ between standard libraries.
        return from + (to - from) * (static_cast<double>(engine_() - std::mt19937::min()) /
                                     (static_cast<double>(std::mt19937::max()) + 1));
    }

    Region room() {
        Region room = box(60, 40);
        const int more = 1 + static_cast<int>(number(0, 3));
        for (int i = 0; i < more; ++i)
            room = unite(room, box(40, 30), {});
        for (int i = 0; i < 2; ++i) {
            const Vec2 at(number(10, 60), number(10, 40));
            room = subtract(room, makeCircle(at, number(2, 8)), {});
        }
        return room;
    }

    Feature closed() { return closedPocket(room()); }

    /// The room cut off by a straight edge of the stock: what lies beyond it is free.
    Feature open() {
        const Region room_region = room();
        const Box2 box = boundingBox(room_region);
        const double edge_mm = box.min().x() + number(0.2, 0.5) * box.sizes().x();
        const Box2 reach = grown(box, 30);
        const Region stock = makeRectangle({edge_mm, reach.min().y()}, reach.max());
        const Region target = intersect(room_region, stock, {});
        double open_mm = 0;
        for (const auto& [from, segment] : eachEdge(target)) {
            const Vec2 middle = pointAt(from, segment, 0.5);
            if (std::abs(middle.x() - edge_mm) < 1e-6) open_mm += length(from, segment);
        }
        return makeFeature(target, subtract(stock, room_region, {}), open_mm);
    }

  private:
    Region box(double width_mm, double height_mm) {
        const Vec2 at(number(0, 40), number(0, 30));
        const Vec2 size(number(0.4, 1) * width_mm, number(0.4, 1) * height_mm);
        return makeRoundedRectangle(snapToGrid(at), snapToGrid(Vec2(at + size)), snapToGrid(number(1, 6)));
    }

    std::mt19937 engine_;
};

}  // namespace stepmill::test
