#pragma once

#include <memory>
#include <vector>

#include "stepmill/planar/indexed_region.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill::toolpath {

/// Material thinner than this share of the disc's radius counts as none: cusps between passes.
/// A share of the radius, since cusps grow with it.
inline constexpr double kCuspShare = 0.01;

/// The part of a task's target that a disc has swept. It answers whether a way lies wholly in it.
///
/// Answers are proofs, not samples: squares are halved until each lies beside the way, beside the target or
/// within one disc that has been there. They err towards "not cleared", and by cusps of kCuspShare or as
/// asked.
class SweptGround {
  public:
    SweptGround(const ClearingTask& task, double radius_mm);

    void add(const Edge& edge) { swept_.push_back(edge); }

    /// Does the disc meet no material on the straight way from a to b?
    bool isClear(const Vec2& a, const Vec2& b) const { return isClear(makeLine(a, b)); }
    /// Does it along an edge?
    bool isClear(const Edge& way) const { return isClear(way, kCuspShare * radius_mm_); }
    /// The same but for cusps of that thickness.
    bool isClear(const Edge& way, double cusp_mm) const;
    /// Does a disc of another radius meet no material at a place or along a straight way, but for cusps?
    bool isClearFor(double disc_mm, const Vec2& a, const Vec2& b) const;

  private:
    bool isClear(const Edge& way, double disc_mm, double cusp_mm) const;

    /// Of the target and the cleared centres; copies share them.
    struct Boundaries {
        IndexedRegion target;
        IndexedRegion cleared;
    };
    std::shared_ptr<const Boundaries> boundaries_;
    double radius_mm_;
    std::vector<Edge> swept_;
};

}  // namespace stepmill::toolpath
