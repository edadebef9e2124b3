#include "report/sheets/traced_lines.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "stepmill/core/error.h"

namespace stepmill::report {
namespace {

/// Faces that meet at less are drawn as one: chords of an arc do [cos].
constexpr double kSmoothCos = 0.87;
/// A surface that goes on this many cells nearer or farther than it should begins anew.
constexpr double kStepCells = 1.6;
/// How far straightened lines may leave the cells' corners [cells].
constexpr double kStraightCells = 0.95;
/// Shorter lines are crumbs of the raster [cells].
constexpr std::size_t kLeastCells = 4;

/// Most of a picture is plain: it is gone over by so many bytes at once.
constexpr std::size_t kWord = sizeof(std::uint64_t);

std::uint64_t wordAt(const std::uint8_t* at) {
    std::uint64_t word = 0;
    std::memcpy(&word, at, kWord);
    return word;
}

bool isZero(const std::uint8_t* at) {
    return wordAt(at) == 0;
}

/// Are the next cells of two rows like each other, and like the one before them?
bool areAlike(const std::uint8_t* above, const std::uint8_t* here, bool before) {
    constexpr std::uint64_t kEveryByte = 0x0101010101010101;
    return wordAt(above) == wordAt(here) && wordAt(here) == (before ? kEveryByte : 0);
}

/// A corner of cells: column and row.
using Corner = std::array<int, 2>;

/// Sides of cells, put together to lines.
class Sides {
  public:
    explicit Sides(const Image& image)
        : rows_(image.rows + 1), ways_(static_cast<std::size_t>(image.columns + 1) * rows_, 0) {}

    /// The side from a corner to the next one to the right.
    void addRight(const Corner& from) {
        ways(from) |= kRight;
        ways({from[0] + 1, from[1]}) |= kLeft;
    }
    /// The side from a corner to the next one below.
    void addDown(const Corner& from) {
        ways(from) |= kDown;
        ways({from[0], from[1] + 1}) |= kUp;
    }

    /// Closed lines alone.
    /// \pre an even number of sides meet at every corner, as around areas
    std::vector<std::vector<Corner>> loops() {
        std::vector<std::vector<Corner>> loops;
        forEachCorner([&](const Corner& corner) {
            while (ways(corner) != 0)
                loops.push_back(lineFrom(corner));
        });
        return loops;
    }

    /// Lines between corners where others meet or end, then closed ones.
    std::vector<std::vector<Corner>> lines() {
        std::vector<Corner> forks;
        forEachCorner([&](const Corner& corner) {
            const int sides = std::popcount(static_cast<unsigned>(ways(corner)));
            if (sides != 0 && sides != 2) forks.push_back(corner);
        });
        for (const Corner& fork : forks)
            ways(fork) |= kStop;
        std::vector<std::vector<Corner>> lines;
        for (const Corner& fork : forks)
            while ((ways(fork) & kSides) != 0)
                lines.push_back(lineFrom(fork));
        forEachCorner([&](const Corner& corner) {
            if ((ways(corner) & kSides) != 0) lines.push_back(lineFrom(corner));
        });
        return lines;
    }

  private:
    // In the order in which a line goes on at a crossing.
    static constexpr std::uint8_t kLeft = 1;
    static constexpr std::uint8_t kUp = 2;
    static constexpr std::uint8_t kDown = 4;
    static constexpr std::uint8_t kRight = 8;
    static constexpr std::uint8_t kSides = kLeft | kUp | kDown | kRight;
    static constexpr std::uint8_t kStop = 16;

    std::uint8_t& ways(const Corner& corner) {
        return ways_[static_cast<std::size_t>(corner[0]) * rows_ + corner[1]];
    }

    /// Column by column, each from above, those alone where sides meet.
    template <typename Visit>
    void forEachCorner(Visit visit) {
        for (std::size_t i = 0; i < ways_.size(); ++i) {
            while (i + kWord <= ways_.size() && isZero(&ways_[i]))
                i += kWord;
            if (i < ways_.size() && ways_[i] != 0)
                visit(Corner{static_cast<int>(i / rows_), static_cast<int>(i % rows_)});
        }
    }

    /// Takes a side away.
    /// \return its other end
    Corner take(const Corner& from) {
        std::uint8_t& here = ways(from);
        const auto way = static_cast<std::uint8_t>(here & kSides & -here);
        here &= static_cast<std::uint8_t>(~way);
        const int across = way == kRight ? 1 : way == kLeft ? -1 : 0;
        const int down = way == kDown ? 1 : way == kUp ? -1 : 0;
        const Corner to{from[0] + across, from[1] + down};
        const std::uint8_t back = way == kRight ? kLeft : way == kLeft ? kRight : way == kDown ? kUp : kDown;
        ways(to) &= static_cast<std::uint8_t>(~back);
        return to;
    }

    std::vector<Corner> lineFrom(const Corner& start) {
        std::vector<Corner> line{start};
        while ((ways(line.back()) & kSides) != 0) {
            line.push_back(take(line.back()));
            if ((ways(line.back()) & kStop) != 0) break;
        }
        return line;
    }

    std::size_t rows_;
    std::vector<std::uint8_t> ways_;  ///< of every corner: its sides, and whether lines stop there
};

/// Middles of the sides, which lie nearer to a slanting line than the corners do; ends stay.
std::vector<Vec2> middlesOf(const std::vector<Corner>& line) {
    const bool closed = line.front() == line.back();
    std::vector<Vec2> points;
    if (!closed) points.emplace_back(line.front()[0], line.front()[1]);
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        points.emplace_back((line[i][0] + line[i + 1][0]) / 2.0, (line[i][1] + line[i + 1][1]) / 2.0);
    if (closed)
        points.push_back(points.front());
    else
        points.emplace_back(line.back()[0], line.back()[1]);
    return points;
}

double offLine(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double length = along.norm();
    return length > 0 ? std::abs(cross(along, p - a)) / length : (p - a).norm();
}

/// Keeps the points that the straight line between two kept ones would miss, the farthest first.
void keepBetween(const std::vector<Vec2>& points, std::size_t from, std::size_t to, std::vector<bool>& kept) {
    double farthest = kStraightCells;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
        const double off = offLine(points[i], points[from], points[to]);
        if (off <= farthest) continue;
        farthest = off;
        at = i;
    }
    if (at == from) return;
    kept[at] = true;
    keepBetween(points, from, at, kept);
    keepBetween(points, at, to, kept);
}

std::vector<Vec2> straightened(const std::vector<Vec2>& points) {
    std::vector<bool> kept(points.size(), false);
    kept.front() = kept.back() = true;
    keepBetween(points, 0, points.size() - 1, kept);
    std::vector<Vec2> line;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (kept[i]) line.push_back(points[i]);
    return line;
}

std::string pathOf(const std::vector<std::vector<Corner>>& lines, std::size_t least_corners) {
    std::string data;
    for (const std::vector<Corner>& corners : lines) {
        if (corners.size() <= least_corners) continue;
        const std::vector<Vec2> line = straightened(middlesOf(corners));
        for (std::size_t i = 0; i < line.size(); ++i)
            fmt::format_to(std::back_inserter(data), "{}{:.1f} {:.1f}", i == 0 ? "M" : "L", line[i].x(),
                           line[i].y());
    }
    return data;
}

/// How the line between two neighbouring cells is drawn.
enum class Stroke : std::uint8_t { None, Edge, Fixture, Cut };

/// Which lines an image has between its cells.
class Neighbours {
  public:
    Neighbours(const Image& image, double cell_mm) : image_(image), cell_mm_(cell_mm) {}

    /// \param columns, rows  from `a` to `b`
    Stroke between(const SeenCell& a, const SeenCell& b, int columns, int rows) const {
        // Most neighbours are pieces of one plane, or of nothing.
        if (a.what == b.what && a.surface == b.surface) return Stroke::None;
        const bool fixture_a = a.what == Shown::Fixture;
        const bool fixture_b = b.what == Shown::Fixture;
        if (a.what == Shown::Nothing || b.what == Shown::Nothing)
            return a.what == b.what ? Stroke::None : fixture_a || fixture_b ? Stroke::Fixture : Stroke::Edge;
        if (fixture_a != fixture_b) return Stroke::Edge;
        if (!isOneSurface(a, b, columns, rows)) return fixture_a ? Stroke::Fixture : Stroke::Edge;
        return a.what == b.what ? Stroke::None : Stroke::Cut;
    }

  private:
    bool isOneSurface(const SeenCell& a, const SeenCell& b, int columns, int rows) const {
        if (image_.normalOf(a).dot(image_.normalOf(b)) < kSmoothCos) return false;
        const double most_mm = kStepCells * cell_mm_;
        return std::abs(goesOnTo(a, columns, rows) - b.depth_mm) < most_mm ||
               std::abs(goesOnTo(b, -columns, -rows) - a.depth_mm) < most_mm;
    }

    /// Where the surface of `a` would be, as deep as it goes on, beside by (columns, rows).
    double goesOnTo(const SeenCell& a, int columns, int rows) const {
        const Vec3& normal = image_.normalOf(a);
        return a.depth_mm + (-normal.x() * columns + normal.y() * rows) / normal.z() * cell_mm_;
    }

    const Image& image_;
    double cell_mm_;
};

}  // namespace

Strokes strokesOf(const Image& image, double cell_mm) {
    // By Stroke; nothing is added for None.
    std::array<Sides, 4> sides{Sides(image), Sides(image), Sides(image), Sides(image)};
    const Neighbours neighbours(image, cell_mm);
    for (int row = 0; row < image.rows; ++row)
        for (int column = 0; column < image.columns; ++column) {
            const SeenCell& cell = image.at(column, row);
            if (column + 1 < image.columns) {
                const Stroke stroke = neighbours.between(cell, image.at(column + 1, row), 1, 0);
                if (stroke != Stroke::None)
                    sides[static_cast<std::size_t>(stroke)].addDown({column + 1, row});
            }
            if (row + 1 < image.rows) {
                const Stroke stroke = neighbours.between(cell, image.at(column, row + 1), 0, 1);
                if (stroke != Stroke::None)
                    sides[static_cast<std::size_t>(stroke)].addRight({column, row + 1});
            }
        }
    const auto drawn = [&](Stroke stroke) {
        return pathOf(sides[static_cast<std::size_t>(stroke)].lines(), kLeastCells);
    };
    return {drawn(Stroke::Edge), drawn(Stroke::Fixture), drawn(Stroke::Cut)};
}

std::string areaOf(const Image& image, const CellMask& mask) {
    STEPMILL_CHECK(mask.size() == image.cells.size(), "a mask has all cells of its image");
    Sides sides(image);
    const std::vector<std::uint8_t> outside(static_cast<std::size_t>(image.columns), 0);
    const auto rowOf = [&](int row) {
        const bool within = row >= 0 && row < image.rows;
        return within ? mask.data() + static_cast<std::size_t>(row) * image.columns : outside.data();
    };
    for (int row = 0; row <= image.rows; ++row) {
        const std::uint8_t* const above = rowOf(row - 1);
        const std::uint8_t* const here = rowOf(row);
        bool before = false;
        for (int column = 0; column < image.columns; ++column) {
            while (column + static_cast<int>(kWord) <= image.columns &&
                   areAlike(above + column, here + column, before))
                column += kWord;
            if (column == image.columns) break;
            const bool in = here[column] != 0;
            if (before != in) sides.addDown({column, row});
            if ((above[column] != 0) != in) sides.addRight({column, row});
            before = in;
        }
        if (before) sides.addDown({image.columns, row});
    }
    return pathOf(sides.loops(), 0);
}

}  // namespace stepmill::report
