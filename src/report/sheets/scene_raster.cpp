#include "report/sheets/scene_raster.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <oneapi/tbb/parallel_for.h>

namespace stepmill::report {
namespace {

/// Surfaces nearer to each other along a ray are one.
constexpr double kSameDepthMm = 1e-3;
/// What is thinner along a ray is a skin between chords.
constexpr double kThinnestMm = 0.05;
/// Patches seen more on edge than this cover no cell.
constexpr double kOnEdge = 1e-6;

/// A patch as the viewer sees it, in cells.
struct SeenPatch {
    BodyKind kind = BodyKind::Raw;
    int surface = 0;  ///< of an image's normals
    std::vector<std::vector<Vec2>> loops;
    Vec3 normal;
    double depth_mm = 0;  ///< at the frame's corner, ...
    Vec2 slope;           ///< ... and how it grows by cell
    double top = 0;
    double bottom = 0;

    double depthAt(const Vec2& p) const { return depth_mm + slope.dot(p); }
};

std::optional<SeenPatch> seenPatch(BodyKind kind, const Patch& patch, const Sight& sight) {
    SeenPatch seen;
    seen.kind = kind;
    seen.normal = sight.turned(patch.normal);
    if (std::abs(seen.normal.z()) < kOnEdge || patch.loops.empty() || patch.loops.front().empty())
        return std::nullopt;
    // In cells y runs down.
    seen.slope = Vec2(-seen.normal.x(), seen.normal.y()) / seen.normal.z() * sight.cell_mm();
    seen.top = 1e300;
    seen.bottom = -1e300;
    for (const std::vector<Vec3>& loop : patch.loops) {
        std::vector<Vec2>& corners = seen.loops.emplace_back();
        for (const Vec3& p : loop) {
            corners.push_back(sight.seen(p).head<2>());
            seen.top = std::min(seen.top, corners.back().y());
            seen.bottom = std::max(seen.bottom, corners.back().y());
        }
    }
    const Vec3 first = sight.seen(patch.loops.front().front());
    seen.depth_mm = first.z() - seen.slope.dot(first.head<2>());
    return seen;
}

/// Where a row's middle line crosses the patch, from left to right.
std::vector<double> crossings(const SeenPatch& patch, double y) {
    std::vector<double> at;
    for (const std::vector<Vec2>& loop : patch.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            Vec2 a = loop[i];
            Vec2 b = loop[(i + 1) % loop.size()];
            // The same from either side, so that neighbours leave no gap.
            if (a.y() > b.y() || (a.y() == b.y() && a.x() > b.x())) std::swap(a, b);
            if (a.y() <= y && y < b.y())
                at.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
    std::sort(at.begin(), at.end());
    return at;
}

struct Hit {
    double depth_mm = 0;
    const SeenPatch* patch = nullptr;
};

/// What surrounds a point of a ray on its way from the viewer.
class Inside {
  public:
    void cross(const SeenPatch& patch) {
        int& count = counts_[static_cast<std::size_t>(patch.kind)];
        count += patch.normal.z() > 0 ? 1 : -1;
    }
    bool in(BodyKind kind) const { return counts_[static_cast<std::size_t>(kind)] > 0; }

  private:
    std::array<int, 4> counts_{};
};

/// The first surface of one picture along a ray.
class FirstSeen {
  public:
    explicit FirstSeen(bool leaving) : leaving_(leaving) {}

    /// \param from, to  hits at about this depth, crossed already
    void step(const Inside& inside, double depth_mm, const Hit* from, const Hit* to) {
        if (done_) return;
        const bool stock = inside.in(BodyKind::Raw) && !inside.in(BodyKind::Cut) &&
                           !(leaving_ && inside.in(BodyKind::CutHere));
        const bool fixture = inside.in(BodyKind::Fixture);
        if (pending_ && !stock && !fixture) {
            if (cell_.depth_mm - depth_mm < kThinnestMm)
                pending_ = false;
            else
                done_ = true;
        } else if (!pending_ && (stock || fixture)) {
            begin(inside, depth_mm, fixture, from, to);
        }
    }

    SeenCell cell() const { return pending_ ? cell_ : SeenCell{}; }

  private:
    void begin(const Inside& inside, double depth_mm, bool fixture, const Hit* from, const Hit* to) {
        pending_ = true;
        const SeenPatch* surface = from->patch;
        for (const Hit* hit = from; hit != to; ++hit) {
            const bool counts = (hit->patch->kind == BodyKind::Fixture) == fixture &&
                                (leaving_ || hit->patch->kind != BodyKind::CutHere);
            const bool counted = (surface->kind == BodyKind::Fixture) == fixture &&
                                 (leaving_ || surface->kind != BodyKind::CutHere);
            if (counts && (!counted || std::abs(hit->patch->normal.z()) > std::abs(surface->normal.z())))
                surface = hit->patch;
        }
        const bool here = leaving_ ? surface->kind == BodyKind::CutHere : inside.in(BodyKind::CutHere);
        cell_.what = fixture ? Shown::Fixture : here ? Shown::CutHere : Shown::Stock;
        cell_.depth_mm = depth_mm;
        cell_.surface = surface->surface;
    }

    bool leaving_;
    bool pending_ = false;
    bool done_ = false;
    SeenCell cell_;
};

/// What both pictures show along one ray.
/// \param from, to  its hits, from the viewer on
std::pair<SeenCell, SeenCell> along(const Hit* from, const Hit* to) {
    Inside inside;
    FirstSeen arriving(false);
    FirstSeen leaving(true);
    while (from != to) {
        const Hit* next = from;
        while (next != to && from->depth_mm - next->depth_mm < kSameDepthMm)
            inside.cross(*(next++)->patch);
        arriving.step(inside, from->depth_mm, from, next);
        leaving.step(inside, from->depth_mm, from, next);
        from = next;
    }
    return {arriving.cell(), leaving.cell()};
}

/// The cells of a row whose middles a patch covers: first to end, none where they are equal.
struct Span {
    int first = 0;
    int end = 0;
    const SeenPatch* patch = nullptr;
};

std::vector<Span> spansOf(const std::vector<const SeenPatch*>& patches, double y, int columns) {
    std::vector<Span> spans;
    for (const SeenPatch* patch : patches) {
        const std::vector<double> at = crossings(*patch, y);
        for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
            const int first = std::max(0, static_cast<int>(std::ceil(std::max(-1.0, at[i] - 0.5))));
            const int end = static_cast<int>(std::ceil(std::min<double>(columns, at[i + 1] - 0.5)));
            if (first < end) spans.push_back({first, end, patch});
        }
    }
    return spans;
}

/// The hits of all rays of a row.
class RowHits {
  public:
    RowHits(const std::vector<const SeenPatch*>& patches, int row, int columns) : ends_(columns + 1, 0) {
        const double y = row + 0.5;
        const std::vector<Span> spans = spansOf(patches, y, columns);
        // Sorted by counting: a ray has few hits, a row has thousands.
        for (const Span& span : spans)
            for (int column = span.first; column < span.end; ++column)
                ++ends_[column + 1];
        for (int column = 0; column < columns; ++column)
            ends_[column + 1] += ends_[column];
        hits_.resize(ends_.back());
        std::vector<std::size_t> next(ends_.begin(), ends_.end() - 1);
        for (const Span& span : spans)
            for (int column = span.first; column < span.end; ++column)
                hits_[next[column]++] = {span.patch->depthAt(Vec2(column + 0.5, y)), span.patch};
        for (int column = 0; column < columns; ++column)
            sortFromViewer(hits_.begin() + ends_[column], hits_.begin() + ends_[column + 1]);
    }

    const Hit* begin(int column) const { return hits_.data() + ends_[column]; }
    const Hit* end(int column) const { return hits_.data() + ends_[column + 1]; }

  private:
    using Place = std::vector<Hit>::iterator;

    /// By insertion: what is equally deep keeps the order of its patches.
    static void sortFromViewer(Place from, Place to) {
        for (Place at = from; at != to; ++at)
            std::rotate(std::upper_bound(from, at, *at,
                                         [](const Hit& a, const Hit& b) { return a.depth_mm > b.depth_mm; }),
                        at, at + 1);
    }

    std::vector<std::size_t> ends_;  ///< of a column's hits; one place later
    std::vector<Hit> hits_;
};

}  // namespace

Sight::Sight(const Vec3& towards_viewer, const Vec3& right, const Box3& shown, int cells) {
    axes_.row(0) = right.normalized();
    axes_.row(1) = towards_viewer.cross(right).normalized();
    axes_.row(2) = towards_viewer.normalized();
    Box2 frame;
    for (int corner = 0; corner < 8; ++corner)
        frame.extend(Vec2((axes_ * shown.corner(static_cast<Box3::CornerType>(corner))).head<2>()));
    cell_mm_ = std::max(1e-6, frame.sizes().maxCoeff() / cells);
    columns_ = std::max(1, static_cast<int>(std::ceil(frame.sizes().x() / cell_mm_)));
    rows_ = std::max(1, static_cast<int>(std::ceil(frame.sizes().y() / cell_mm_)));
    upper_left_ = Vec2(frame.min().x(), frame.max().y());
}

Vec3 Sight::seen(const Vec3& p) const {
    const Vec3 at = axes_ * p;
    return {(at.x() - upper_left_.x()) / cell_mm_, (upper_left_.y() - at.y()) / cell_mm_, at.z()};
}

StockImages stockImages(const std::vector<Body>& bodies, const Sight& sight) {
    std::vector<SeenPatch> patches;
    std::vector<Vec3> normals{Vec3::Zero()};
    for (const Body& body : bodies)
        for (const Patch& patch : body.patches)
            if (std::optional<SeenPatch> seen = seenPatch(body.kind, patch, sight)) {
                seen->surface = static_cast<int>(normals.size());
                normals.push_back(seen->normal.z() < 0 ? Vec3(-seen->normal) : seen->normal);
                patches.push_back(std::move(*seen));
            }
    std::vector<std::vector<const SeenPatch*>> by_row(sight.rows());
    for (const SeenPatch& patch : patches) {
        const int last = std::min<int>(sight.rows() - 1, static_cast<int>(std::floor(patch.bottom)));
        for (int row = std::max(0, static_cast<int>(std::floor(patch.top))); row <= last; ++row)
            by_row[row].push_back(&patch);
    }
    StockImages images;
    for (Image* image : {&images.arriving, &images.leaving}) {
        image->columns = sight.columns();
        image->rows = sight.rows();
        image->cells.resize(static_cast<std::size_t>(image->columns) * image->rows);
        image->normals = normals;
    }
    tbb::parallel_for(0, sight.rows(), [&](int row) {
        const RowHits hits(by_row[row], row, sight.columns());
        const std::size_t first = static_cast<std::size_t>(row) * sight.columns();
        for (int column = 0; column < sight.columns(); ++column)
            std::tie(images.arriving.cells[first + column], images.leaving.cells[first + column]) =
                along(hits.begin(column), hits.end(column));
    });
    return images;
}

}  // namespace stepmill::report
