#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "stepmill/catalog/tool.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/feature/form_ground.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {

/// One component of a form ground's window, with the clearance diagrams of its bands, which all cutters
/// share. They are made when they are first asked for; not safe to share between threads.
class FormRoom {
  public:
    /// Keeps `ground`.
    /// \param sections  of the bands that must stand, as far as they lie in the window
    FormRoom(const FormGround& ground, Region window, std::vector<Region> sections, const Tolerances& tol);

    const Region& window() const { return window_; }
    /// Heights between which there are stairs in the room.
    double stairsBottomMm() const { return stairs_bottom_mm_; }
    double stairsTopMm() const { return stairs_top_mm_; }
    /// The section of must_stand[band], grown. Empty for an empty one.
    Region grown(std::size_t band, double by_mm) const;
    /// All that must stand in that band and above it, grown.
    Region grownAbove(std::size_t band, double by_mm) const;
    /// Does the band hold the same section as the one above it?
    bool goesOn(std::size_t band) const { return goes_on_[band] != 0; }

  private:
    using Diagrams = std::map<std::size_t, ClearanceDiagram>;
    const ClearanceDiagram& shadow(std::size_t band) const;
    void findStairs(const FormGround& ground);

    Region window_;
    std::vector<Region> sections_;
    Tolerances tol_;
    std::vector<char> goes_on_;
    double stairs_bottom_mm_ = 0;
    double stairs_top_mm_ = 0;
    mutable Diagrams bands_;
    mutable Diagrams shadows_;
};

/// A form ground as the rooms of its window.
class FormBands {
  public:
    /// Keeps `ground`.
    FormBands(const FormGround& ground, const Tolerances& tol);

    const FormGround& ground() const { return ground_; }
    const Tolerances& tolerances() const { return tol_; }
    const std::vector<FormRoom>& rooms() const { return rooms_; }
    /// The section of obstacles[index], grown, as far as it reaches into the room.
    const Region& obstacleGrown(std::size_t index, double by_mm, std::size_t room) const;

  private:
    const FormGround& ground_;
    Tolerances tol_;
    std::vector<FormRoom> rooms_;
    mutable std::map<std::size_t, ClearanceDiagram> obstacles_;
    mutable std::map<std::tuple<std::size_t, double, std::size_t>, Region> obstacles_grown_;
};

/// Where the axis of a form cutter may stand while its tip is at a height.
///
/// The cutter is a stack of discs, one for each band that must stand: of the cutter's largest radius in that
/// band. The free centres are the window without each section grown by its disc, so neither the cutter nor
/// what stands over it touches anything at any height. Shank and holder keep off the shadows at theirs.
class FormCentres {
  public:
    /// Keeps `bands`.
    FormCentres(const FormBands& bands, const ToolAssembly& tool);

    /// In rooms where the cutter would meet stairs; others have no free centres. Errs inwards by the guard of
    /// paths, and by what a band is high times the sine of the wall's lean. Kept by height.
    Region at(double tip_z_mm) const { return from(tip_z_mm, tip_z_mm); }
    /// Those of the upper of two heights, in rooms where the cutter would meet stairs somewhere between. A
    /// tip that is lower has no others: more stands beside it.
    Region from(double top_z_mm, double bottom_z_mm) const;
    /// Where all of the cutter stays inside the window, whatever stands there.
    Region withinWindow() const;

  private:
    bool meetsStairs(std::size_t room, double top_z_mm, double bottom_z_mm) const;
    const Region& inRoom(std::size_t room, double tip_z_mm) const;
    std::vector<Region> keptOff(std::size_t room, double tip_z_mm) const;
    void addHolder(std::size_t room, double tip_z_mm, std::vector<Region>& kept_off) const;

    const FormBands& bands_;
    const ToolAssembly& tool_;
    std::vector<Region> within_;  ///< the rooms' windows less the cutter's radius
    mutable std::map<std::pair<double, std::size_t>, Region> in_rooms_;  ///< by height and room
};

}  // namespace stepmill
