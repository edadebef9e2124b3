#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "planar/boolean/grouped.h"
#include "stepmill/planar/edge.h"

namespace stepmill::planar {

/// An edge of an operand as it came in.
struct Curve : Edge {
    int operand = 0;  ///< 0 or 1
    int loop = 0;     ///< numbered over both operands
};

/// A stretch of a curve between two nodes that no other piece crosses. Coinciding stretches of several
/// curves are one piece, named after the first.
struct Piece {
    int begin = 0;  ///< node
    int end = 0;    ///< node
    int curve = 0;
    bool along = true;      ///< runs in the direction of the curve
    bool straight = false;  ///< so short a part of an arc that it counts as a line
    /// How many more windings operand k has on the left of the piece than on its right.
    std::array<int, 2> step{};
    int twin = -1;  ///< another curve that coincides with it; the last one of several
};

/// A piece with the winding numbers of both operands on its two sides.
struct LabelledPiece {
    Piece piece;
    std::array<int, 2> left{};
    std::array<int, 2> right{};
};

/// All boundaries of two operands cut at each other's crossings.
///
/// Points nearer to each other than the snapping distance become one node. The node lies at the first of
/// them: corners come before crossings, operand 0 before operand 1.
class Arrangement {
  public:
    Arrangement(const std::vector<Curve>& curves, double snap_mm);

    /// The same on chords, with GEOS' snap rounding: slower and true to `chord_mm` only, but the pieces
    /// never contradict each other. Equal circles have equal chords; pieces keep the name of their curve.
    static Arrangement onChords(const std::vector<Curve>& curves, double chord_mm);

    /// All pieces with what lies on their sides. O(pieces times chains between junctions).
    std::vector<LabelledPiece> labelled() const;

    /// Do the windings agree all around every junction? If not, snapping has pushed a piece across a node.
    bool consistent(const std::vector<LabelledPiece>& labels) const;

    /// The pieces between inside and outside, turned so that the inside is on their left.
    /// `inside(windings of operand 0, of operand 1)` says which points belong to the result.
    static std::vector<Piece> boundary(const std::vector<LabelledPiece>& labels,
                                       const std::function<bool(int, int)>& inside);

    const std::vector<Curve>& curves() const { return curves_; }
    /// Stretches along which two curves run in opposite directions: they cancel and bound nothing.
    const std::vector<Piece>& cancelled() const { return cancelled_; }
    const Vec2& node(int index) const { return nodes_[static_cast<std::size_t>(index)]; }
    /// How far chords may lie off their curves [mm]; 0 when the pieces are the curves' own.
    double chordMm() const { return chord_mm_; }
    /// The corner for which the node stands, before it was rounded to the grid of the chords.
    const Vec2& place(int index) const;
    /// The piece as part of its line or arc again.
    Segment onCurve(const Piece& piece) const;
    /// The piece as a segment from node(piece.begin).
    Segment segment(const Piece& piece) const;
    double lengthOf(const Piece& piece) const;
    /// The end of a piece at a node: where it begins, or where it comes in.
    struct End {
        const Piece* piece;
        bool leaves;
    };
    /// Indices of ends that share a node, counter-clockwise around it. Where two ends leave in nearly the
    /// same direction, the further course of their pieces decides, along the length of the shorter one.
    std::vector<std::size_t> counterClockwise(std::span<const End> ends) const;

  private:
    struct NodeIndex;
    class NodesInBox;
    class ChordNoder;
    class Cuts;
    /// A curve is cut at a node.
    struct Cut {
        int curve;
        double share;
        int node;
    };

    Arrangement() = default;

    void cutCurves();
    /// A curve moved to the nodes of its ends.
    struct Stretch {
        Vec2 from;
        Segment segment;
    };
    Stretch betweenNodes(const Curve& curve, int begin, int end) const;
    void addPieces(const std::vector<Cut>& cuts);
    void addPiece(int begin, int end, int curve);
    void dropDeadPieces();
    void sortIntoStrips();
    std::array<int, 2> windingsOnTheRight(const Piece& piece) const;
    std::vector<int> chains() const;
    /// From the end's node to the point so far along its piece.
    Vec2 seen(const End& end, double reach_mm) const;
    void sortAround(std::span<const End> ends, std::span<std::size_t> order) const;

    struct Strips {
        std::size_t of(double value_mm) const;

        double low_mm = 0;
        double per_mm = 0;
        std::size_t count = 1;
        std::vector<int> pieces;  // of each entry into a strip
        Grouped entries;          // by strip
    };

    std::vector<Curve> curves_;
    double snap_mm_ = 0;
    double chord_mm_ = 0;  // 0 when pieces lie on their curves
    std::vector<Vec2> nodes_;
    std::vector<Vec2> places_;  // per node; of chords only
    std::vector<Piece> pieces_;
    std::vector<Piece> cancelled_;
    std::array<Strips, 2> strips_;  // along x, along y
    std::vector<int> first_at_;     // the first piece at its lower node
    std::vector<int> next_at_;      // of each piece, the next one at its lower node
};

/// The curves of a region; arcs of more than a half circle are cut in two.
void appendCurves(const Region& region, int operand, std::vector<Curve>& curves);

}  // namespace stepmill::planar
