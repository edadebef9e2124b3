#pragma once

#include <optional>
#include <vector>

#include "stepmill/access/form_centres.h"
#include "stepmill/planar/edge_index.h"
#include "stepmill/toolpath/shallow_ground.h"
#include "stepmill/toolpath/standing_stairs.h"
#include "stepmill/toolpath/surface_passes.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill::toolpath {

/// The passes of a form cutter with its tip at one height.
struct FormLevel {
    double tip_z_mm = 0;
    Region free_centres;
    std::vector<Path> passes;  ///< in climb direction, farthest from the walls first
};

/// How near to each other a form cutter's passes come.
struct PassSpacing {
    double step_over_mm = 0;  ///< beside a wall, on one level
    double skin_mm = 0;       ///< stairs no thicker are the surface of an earlier pass
    /// Passes of two levels leave no ridge over the scallop where they are no farther apart along the wall.
    /// 0: all levels are passed.
    double along_wall_mm = 0;
    /// Over ground that lines over the surface finish, so much is left to them.
    double over_shallow_mm = 0;
};

/// The passes of one form cutter, level by level from above. Levels lie as near to each other as the flattest
/// wall of their height asks for; a steeper one leaves out those that it can do without.
///
/// A stretch of a level's pass waits for the next level where that lies no farther along the wall from a pass
/// made above than `along_wall_mm`. On a wall the tip moves as the cutter's contact does, so that is the way
/// from tip to tip: dz down, and no more aside than from the pass above to the stretch and on to the next
/// level's boundary.
class FormPasses {
  public:
    /// Keeps `centres`, `form` and `shallow`.
    /// \param shallow  ground that lines over the surface finish
    FormPasses(const FormCentres& centres, const CutterForm& form, const PassSpacing& spacing,
               const ShallowGround& shallow, const Tolerances& tol);

    /// May there be passes at any height between these? Where not, none of them has to be asked for.
    bool mayPass(double top_z_mm, double bottom_z_mm, const StandingStairs& stairs) const;

    /// Passes along the boundary of the free centres at one height, wherever the cutter meets stairs there,
    /// and beside them at the step-over where the stairs are wider. No passes where it meets none.
    /// \param next_z_mm  of the level below that a stretch may wait for; nothing: none waits
    FormLevel at(double tip_z_mm, const StandingStairs& stairs, std::optional<double> next_z_mm);

  private:
    struct Made {
        double tip_z_mm = 0;
        EdgeIndex edges;
    };

    /// The level that a stretch may wait for, and the boundary of its free centres once it is asked for.
    struct Next {
        std::optional<double> z_mm;
        std::optional<EdgeIndex> boundary;
    };
    class Meeting;

    std::vector<Path> piecesOf(const Loop& loop, Meeting& meeting, Next& next, bool passes_shallow) const;
    void remember(double tip_z_mm, const std::vector<Path>& passes);
    /// Of each edge along a wall, 0: it is needed, but may wait.
    std::vector<char> cannotWait(const std::vector<Edge>& edges, const std::vector<char>& needed,
                                 Next& next) const;
    Region boundaryAt(double tip_z_mm) const;

    const FormCentres& centres_;
    const CutterForm& form_;
    const ShallowGround& shallow_;
    std::optional<double> shallow_passed_mm_;  ///< the last level that was passed over shallow ground
    PassSpacing spacing_;
    Tolerances tol_;
    std::vector<Made> made_;  ///< along walls, no higher than a next level may ask for
};

/// What a form cutter's moves need to know beside its passes.
struct FormTask {
    const FormGround& ground;
    double retract_z_mm = 0;
    bool plain_ways = false;  ///< no way between passes but over the retract height
};

/// A form cutter's whole path, and the ways at depth between its passes, which may cut too.
struct FormPath {
    Toolpath path;
    std::vector<LevelWays> between;
};

/// The passes of all levels, from above, and then those over the surface as one path: rapids come down over
/// what stands when form operations begin, ways at depth stay in the free centres, all else goes over the
/// retract height. No moves without passes.
FormPath formPath(const FormTask& task, const std::vector<FormLevel>& levels,
                  const std::vector<SurfaceWay>& lines, const ToolAssembly& tool, const CuttingData& cutting,
                  const Machine& machine, const Tolerances& tol);

}  // namespace stepmill::toolpath
