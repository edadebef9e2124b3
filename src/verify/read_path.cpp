#include "verify/read_path.h"

#include <algorithm>

#include "stepmill/toolpath/adaptive_cutting.h"
#include "stepmill/toolpath/cutting_model.h"

namespace stepmill::verify {
namespace {

/// Feeds are rounded when they are written: by no more than this share.
constexpr double kGlideShare = 1e-3;

}  // namespace

LinedPath LinedPath::first(std::size_t count) const {
    LinedPath part;
    part.path.start = path.start;
    part.path.moves.assign(path.moves.begin(), path.moves.begin() + static_cast<std::ptrdiff_t>(count));
    part.lines.assign(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(count));
    return part;
}

ReadOperation withGlidesAsRapids(const ReadOperation& operation, const RecordedOperation& planned,
                                 const Machine& machine) {
    ReadOperation proven = operation;
    const double cuts_at = planned.feed_mm_per_min * (planned.rating ? kMostChipThinning : 1);
    const double most = glideFeedMmPerMin(machine);
    const double sinks_at = planned.tool.isForHoles() ? most : planned.plunge_feed_mm_per_min;
    const auto isBetween = [](double feed, double slow, double fast) {
        return feed > slow * (1 + kGlideShare) && feed <= fast * (1 + kGlideShare);
    };
    Vec3 from = operation.start;
    for (ReadMove& read : proven.moves) {
        Move& move = read.fed.move;
        const bool down = move.to.head<2>() == from.head<2>() && move.to.z() < from.z();
        from = move.to;
        const bool may = move.kind == MoveKind::Feed || move.kind == MoveKind::Plunge;
        if (!may || move.arc) continue;
        const double feed = read.fed.feed_mm_per_min;
        const bool glides_level = planned.engagement_deg > 0 && isBetween(feed, cuts_at, most);
        const bool glides_down = down && sinks_at > 0 && isBetween(feed, sinks_at, most);
        if (glides_level || glides_down) move.kind = MoveKind::Rapid;
    }
    return proven;
}

LinedPath wholePath(const ReadOperation& operation) {
    LinedPath whole;
    whole.path.start = operation.start;
    for (const ReadMove& read : operation.moves) {
        whole.path.moves.push_back(read.fed.move);
        whole.lines.push_back(read.line);
        if (read.fed.move.kind != MoveKind::Plunge) continue;
        Move stay = read.fed.move;
        stay.kind = MoveKind::Feed;
        whole.path.moves.push_back(stay);
        whole.lines.push_back(read.line);
    }
    return whole;
}

LinedPath somePath(const ReadOperation& operation, double raised_mm, const Wanted& wanted) {
    LinedPath some;
    const Vec3 up(0, 0, raised_mm);
    Vec3 from = operation.start;
    for (const ReadMove& read : operation.moves) {
        if (wanted(from, read.fed.move)) {
            if (some.path.moves.empty()) some.path.start = from + up;
            Move hop;
            hop.to = from + up;
            Move move = read.fed.move;
            move.to += up;
            if (move.kind == MoveKind::Rapid) move.kind = MoveKind::Feed;
            some.path.moves.push_back(hop);
            some.path.moves.push_back(move);
            some.lines.insert(some.lines.end(), 2, read.line);
        }
        from = read.fed.move.to;
    }
    return some;
}

int firstFailingLine(const LinedPath& path, const std::function<bool(const Toolpath&)>& fails) {
    std::size_t good = 0;
    std::size_t bad = path.path.moves.size();
    while (bad - good > 1) {
        const std::size_t middle = good + (bad - good) / 2;
        (fails(path.first(middle).path) ? bad : good) = middle;
    }
    return path.lines[bad - 1];
}

}  // namespace stepmill::verify
