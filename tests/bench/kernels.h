#pragma once

#include <functional>
#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::bench {

/// Seconds of processor time all threads have used together.
double processorSeconds();

/// Result of all pairs, or of as many as the time allowed.
struct Pairs {
    double area_mm2 = 0;  ///< sum over the pairs done
    int done = 0;
    int all = 0;
    double seconds = 0;  ///< processor time for all pairs, scaled up from those done
};

/// Pairs of radii m > n in an order that spreads any beginning of it evenly, until `budget_s` is used up.
/// `first_s`: processorSeconds() when the work common to all pairs began; `pair` returns an area.
Pairs runPairs(std::size_t radii, double first_s, double budget_s,
               const std::function<double(std::size_t m, std::size_t n)>& pair);

/// What the planar bench asks of a kernel. Every call starts from the region: building what the kernel keeps
/// counts. Returns the sum of the areas of all results [mm2], so that kernels can be compared.
class Kernel {
  public:
    virtual ~Kernel() = default;
    /// Openings for all radii.
    virtual double openings(const Region& region, const std::vector<double>& radii_mm) const = 0;
    /// Insets of the region itself.
    virtual double insets(const Region& region, const std::vector<double>& distances_mm) const = 0;
    /// Insets by step/2, 3 step/2, ... until nothing is left.
    virtual double rings(const Region& region, double step_mm) const = 0;
    /// For each pair of radii m > n: what n has left to sweep after m,
    /// D = grow(shrink(T, n) - shrink(open(T, m), n), n).
    /// \pre radii rise
    virtual Pairs decomposed(const Region& region, const std::vector<double>& radii_mm,
                             double budget_s) const = 0;
};

/// Sagitta of the chords that stand for arcs in the kernels that know none [mm].
inline constexpr double kChordMm = 2.5e-4;

class StepmillKernel : public Kernel {
  public:
    double openings(const Region& region, const std::vector<double>& radii_mm) const override;
    double insets(const Region& region, const std::vector<double>& distances_mm) const override;
    double rings(const Region& region, double step_mm) const override;
    Pairs decomposed(const Region& region, const std::vector<double>& radii_mm,
                     double budget_s) const override;
};

/// GEOS: BufferOp and OverlayNG on floating-point polygons.
class GeosKernel : public Kernel {
  public:
    double openings(const Region& region, const std::vector<double>& radii_mm) const override;
    double insets(const Region& region, const std::vector<double>& distances_mm) const override;
    double rings(const Region& region, double step_mm) const override;
    Pairs decomposed(const Region& region, const std::vector<double>& radii_mm,
                     double budget_s) const override;
};

/// Clipper 6.4.2 on a 1 nm integer grid.
class ClipperKernel : public Kernel {
  public:
    double openings(const Region& region, const std::vector<double>& radii_mm) const override;
    double insets(const Region& region, const std::vector<double>& distances_mm) const override;
    double rings(const Region& region, double step_mm) const override;
    Pairs decomposed(const Region& region, const std::vector<double>& radii_mm,
                     double budget_s) const override;
};

}  // namespace stepmill::bench
