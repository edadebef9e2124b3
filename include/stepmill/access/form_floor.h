#pragma once

#include <vector>

#include "stepmill/catalog/cutter_form.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/core/deadline.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/feature/form_ground.h"
#include "stepmill/planar/walk_inside.h"

namespace stepmill {

/// A tip that goes up or down along a way is proven in pieces over which it rises no more than this, as if it
/// were at the lower end of each [mm].
inline constexpr double kSlopeRiseMm = 0.005;

/// How low the tip of a form cutter may be over a place: the reverse of FormCentres, for ways that go up and
/// down with the ground. Safe to share between threads.
class FormFloor {
  public:
    /// Keeps `ground` and `tool`.
    /// \param deadline  of all that is asked of it
    FormFloor(const FormGround& ground, const ToolAssembly& tool, const Tolerances& tol,
              const Deadline& deadline = {});

    /// The lowest heights of the tip at which neither cutter nor shank nor holder touches anything, for each
    /// of the pieces of a straight way between these points: all along it, and with the guard of paths. Errs
    /// upwards as FormCentres errs inwards. No lower than the bands that must stand are known. One long way
    /// costs less than its parts.
    /// \pre the way keeps inside the window by the cutter's radius; the points follow each other along it
    /// \throws Error(TimedOut) after the deadline
    std::vector<double> over(const std::vector<Vec2>& way) const;

  private:
    struct Stretch;
    std::vector<WalkInside> walks() const;
    Stretch stretchOver(const Edge& stretch, std::vector<WalkInside>& walks) const;
    double lowestOver(const Edge& piece, const Stretch& stretch, std::vector<WalkInside>& walks) const;
    double holderOver(const Edge& stretch, double tip_mm) const;

    const FormGround& ground_;
    const ToolAssembly& tool_;
    CutterForm form_;
    double guard_mm_;
    Deadline deadline_;
    std::vector<IndexedRegion> bands_;
    std::vector<IndexedRegion> obstacles_;
};

/// The ends of the equal pieces of a straight way, its own included.
/// \pre pieces > 0
std::vector<Vec2> equalPieces(const Vec2& from, const Vec2& to, int pieces);

}  // namespace stepmill
