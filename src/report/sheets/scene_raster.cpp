#include "report/sheets/scene_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "stepmill/core/parallel.h"

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
    /// The plane that the cell's depth lies in; null where the cell shows nothing.
    const SeenPatch* plane() const { return pending_ ? plane_ : nullptr; }
    bool pending() const { return pending_; }
    bool done() const { return done_; }

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
        plane_ = from->patch;
    }

    bool leaving_;
    bool pending_ = false;
    bool done_ = false;
    SeenCell cell_;
    const SeenPatch* plane_ = nullptr;
};

/// What both pictures show along one ray, and how that was found.
struct Ray {
    std::array<SeenCell, 2> cells;  ///< arriving, leaving
    std::array<const SeenPatch*, 2> planes{};
    /// The patches it met in their order, and after those that lie together what was found so far. Depths run
    /// evenly along a row: two rays with the same story have only rays with that story between them.
    std::vector<std::pair<const SeenPatch*, int>> story;
};

/// \param hits  from the viewer on
Ray castThrough(const std::vector<Hit>& hits) {
    Ray ray;
    Inside inside;
    FirstSeen arriving(false);
    FirstSeen leaving(true);
    const Hit* from = hits.data();
    const Hit* const to = from + hits.size();
    while (from != to && !(arriving.done() && leaving.done())) {
        const Hit* next = from;
        while (next != to && from->depth_mm - next->depth_mm < kSameDepthMm) {
            inside.cross(*next->patch);
            ray.story.emplace_back((next++)->patch, 0);
        }
        arriving.step(inside, from->depth_mm, from, next);
        leaving.step(inside, from->depth_mm, from, next);
        ray.story.back().second =
            1 + arriving.pending() + 2 * arriving.done() + 4 * leaving.pending() + 8 * leaving.done();
        from = next;
    }
    ray.cells = {arriving.cell(), leaving.cell()};
    ray.planes = {arriving.plane(), leaving.plane()};
    return ray;
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

/// By insertion, since a ray has few: what is equally deep keeps the order of its patches.
void sortFromViewer(std::vector<Hit>& hits) {
    for (auto at = hits.begin(); at != hits.end(); ++at)
        std::rotate(std::upper_bound(hits.begin(), at, *at,
                                     [](const Hit& a, const Hit& b) { return a.depth_mm > b.depth_mm; }),
                    at, at + 1);
}

/// Casts the rays of a row: those at the ends of stretches that the same patches cover, and between them only
/// where these two do not tell all.
class RowCaster {
  public:
    RowCaster(const std::vector<const SeenPatch*>& patches, int row, StockImages& images)
        : y_(row + 0.5),
          columns_(images.arriving.columns),
          row_{images.arriving.cells.data() + static_cast<std::size_t>(row) * columns_,
               images.leaving.cells.data() + static_cast<std::size_t>(row) * columns_},
          spans_(spansOf(patches, y_, columns_)) {}

    void cast() {
        std::vector<int> ends;
        std::vector<std::size_t> by_first(spans_.size());
        std::iota(by_first.begin(), by_first.end(), 0);
        std::stable_sort(by_first.begin(), by_first.end(),
                         [&](std::size_t a, std::size_t b) { return spans_[a].first < spans_[b].first; });
        for (const Span& span : spans_)
            ends.insert(ends.end(), {span.first, span.end});
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        auto next = by_first.begin();
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            std::erase_if(here_, [&](std::size_t span) { return spans_[span].end <= ends[i]; });
            for (; next != by_first.end() && spans_[*next].first == ends[i]; ++next)
                here_.push_back(*next);
            std::sort(here_.begin(), here_.end());
            castStretch(ends[i], ends[i + 1] - 1);
        }
    }

  private:
    void castStretch(int first, int last) {
        const Ray from = castAt(first);
        if (first < last) fillBetween(first, from, last, castAt(last));
    }

    void fillBetween(int first, const Ray& from, int last, const Ray& to) {
        if (last - first <= 1) return;
        if (from.story == to.story) {
            for (int column = first + 1; column < last; ++column)
                for (std::size_t image = 0; image < row_.size(); ++image) {
                    SeenCell& cell = row_[image][column] = from.cells[image];
                    if (from.planes[image] != nullptr)
                        cell.depth_mm = from.planes[image]->depthAt(Vec2(column + 0.5, y_));
                }
            return;
        }
        const int middle = (first + last) / 2;
        const Ray between = castAt(middle);
        fillBetween(first, from, middle, between);
        fillBetween(middle, between, last, to);
    }

    Ray castAt(int column) {
        hits_.clear();
        for (const std::size_t span : here_)
            hits_.push_back({spans_[span].patch->depthAt(Vec2(column + 0.5, y_)), spans_[span].patch});
        sortFromViewer(hits_);
        Ray ray = castThrough(hits_);
        for (std::size_t image = 0; image < row_.size(); ++image)
            row_[image][column] = ray.cells[image];
        return ray;
    }

    double y_;
    int columns_;
    std::array<SeenCell*, 2> row_;  ///< arriving, leaving
    std::vector<Span> spans_;
    std::vector<std::size_t> here_;  ///< spans over the stretch, ascending
    std::vector<Hit> hits_;          ///< of the ray, from the viewer on
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
    parallelFor(sight.rows(), [&](int row) { RowCaster(by_row[row], row, images).cast(); });
    return images;
}

}  // namespace stepmill::report
