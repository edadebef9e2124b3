#pragma once

#include <random>

#include "stepmill/planar/region.h"

namespace stepmill::test {

/// What makes a pair of operands hard for a boolean.
enum class PairKind {
    Scattered,  ///< anywhere: few ties
    Lattice,    ///< on a coarse lattice: shared edges, tangent arcs, equal circles, touching corners
    Shifted,    ///< lattice shapes a nanometre to a micrometre off
    Turned,     ///< lattice shapes turned by a little or by any angle: walls that nearly coincide
    Tangent,    ///< also turned slots, tangent circles, slivers and shallow arcs
    Chained,    ///< results of earlier booleans as operands, nudged in between
    Tiny,       ///< parts of a tenth of a millimetre
    Huge        ///< parts of two metres
};
inline constexpr PairKind kPairKinds[] = {PairKind::Scattered, PairKind::Lattice, PairKind::Shifted,
                                          PairKind::Turned,    PairKind::Tangent, PairKind::Chained,
                                          PairKind::Tiny,      PairKind::Huge};

/// Valid regions of one kind, one after the other; the same for the same seed everywhere.
class PairMaker {
  public:
    PairMaker(unsigned seed, PairKind kind);

    Region region();
    Path path();

  private:
    unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }
    double real(double low, double high) { return low + (high - low) * (random_() / 4294967296.0); }
    bool onLattice() const { return kind_ != PairKind::Scattered; }
    bool wide() const { return kind_ >= PairKind::Tangent; }
    double coordinate() { return onLattice() ? 5.0 * scale_ * below(9) : snapToGrid(real(0, 40)); }
    double size() { return onLattice() ? 5.0 * scale_ * (1 + below(4)) : real(1, 20); }
    Region plainShape(unsigned which);
    Region wideShape(unsigned which);
    Region shape();
    Region nudged(const Region& region);

    std::mt19937 random_;
    PairKind kind_;
    double scale_;
};

}  // namespace stepmill::test
