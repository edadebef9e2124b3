#pragma once

#include "stepmill/catalog/tool.h"

namespace stepmill {

/// What a cutter is turned to: its radius over the height from its tip. The radius never gets less upwards.
/// Of a tap it is the thread's core: what teeth cut beyond is the thread, no volume of the part.
class CutterForm {
  public:
    explicit CutterForm(const ToolAssembly& tool);

    /// At that height over the tip: 0 below it, the full radius from heightMm() on [mm].
    double radiusAt(double height_mm) const;
    /// The greatest height over the tip up to which the cutter is no wider than that radius: infinity for the
    /// full one and more, 0 for less than it has at its tip [mm].
    double heightUnder(double radius_mm) const;
    /// The height from which the radius is the full one; 0 for a flat end mill [mm].
    double heightMm() const { return height_mm_; }
    double fullRadiusMm() const { return full_mm_; }

  private:
    double full_mm_;
    double tip_mm_;
    double corner_mm_;  ///< 0 for a cone
    double height_mm_;
};

/// Sine of the lean from upright of the face that a cone's flank makes: 0.707 for 90 degrees between flanks.
/// \pre tool.hasFlanks()
double flankLean(const ToolAssembly& tool);

/// Chamfer mills and countersinks make the faces whose lean is their flank's to this.
inline constexpr double kSameLean = 0.02;

}  // namespace stepmill
