#include "access/farthest_room.h"

#include <algorithm>
#include <numbers>
#include <queue>

#include "stepmill/planar/indexed_region.h"

namespace stepmill::access {
namespace {

/// Bounds as near to each other as this will do [mm].
constexpr double kNearMm = 0.05;
/// Squares looked at before the bounds are what they are: along an open edge all are equally far off.
constexpr int kMostSquares = 2000;

struct Square {
    Vec2 centre;
    double half_mm;
    double most_mm;  ///< no point of it lies farther off
};

class RoomSearch {
  public:
    RoomSearch(const Region& place, const Region& standing, double disc_mm)
        : place_(place), standing_(standing), disc_mm_(disc_mm) {}

    FarthestRoom run() {
        const Box2 box = place_.boundary().box();
        if (box.isEmpty()) return {};
        look({box.min() + box.sizes() / 2, box.sizes().maxCoeff() / 2, 0});
        for (int looked = 0; !open_.empty() && looked < kMostSquares; looked += 4) {
            const Square square = open_.top();
            if (square.most_mm <= reached_mm_ + kNearMm) break;
            open_.pop();
            const double half_mm = square.half_mm / 2;
            for (const double x : {-half_mm, half_mm})
                for (const double y : {-half_mm, half_mm})
                    look({square.centre + Vec2(x, y), half_mm, 0});
        }
        return {reached_mm_, open_.empty() ? reached_mm_ : std::max(reached_mm_, open_.top().most_mm)};
    }

  private:
    struct Nearer {
        bool operator()(const Square& a, const Square& b) const { return a.most_mm < b.most_mm; }
    };

    void look(Square square) {
        const double reach_mm = square.half_mm * std::numbers::sqrt2;
        const double to_edge_mm = place_.boundary().distanceTo(square.centre);
        const bool inside = place_.contains(square.centre);
        if (!inside && to_edge_mm > reach_mm) return;
        const double off_mm =
            standing_.contains(square.centre) ? 0 : standing_.boundary().distanceTo(square.centre);
        if (inside && to_edge_mm >= disc_mm_) reached_mm_ = std::max(reached_mm_, off_mm - disc_mm_);
        square.most_mm = off_mm + reach_mm;
        open_.push(square);
    }

    IndexedRegion place_;
    IndexedRegion standing_;
    double disc_mm_;
    double reached_mm_ = 0;
    std::priority_queue<Square, std::vector<Square>, Nearer> open_;
};

}  // namespace

FarthestRoom farthestRoom(const Region& place, const Region& standing, double disc_mm) {
    return RoomSearch(place, standing, disc_mm).run();
}

}  // namespace stepmill::access
