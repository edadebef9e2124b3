#pragma once

#include <set>
#include <string>
#include <vector>

#include "stepmill/catalog/hole_table.h"
#include "stepmill/feature/feature.h"
#include "stepmill/feature/hole.h"
#include "stepmill/plan/plan.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// Places of a hole feature that one entry of the hole table chooses.
struct HoleWish {
    const HoleEntry* entry = nullptr;
    std::vector<Vec2> places;  ///< in the order of holeCentres()
    bool whole = false;        ///< all places of the feature
};

/// What a hole table says of the holes of a part.
class HoleWishes {
  public:
    /// \param table  outlives this
    HoleWishes(const HoleTable& table, const Part& part, const Tolerances& tol);

    /// By the entries' order; none for what is no hole, and for holes that no entry chooses.
    std::vector<HoleWish> of(const Feature& feature, const Setup& setup) const;
    /// How all of its places are to be made; null: as without a table.
    const HoleEntry* entryOf(const Feature& feature, const Setup& setup) const;

    /// Entries that choose no hole of the setups, and those that would have some holes of a group of equal
    /// ones made in another way than the rest: a group is made as one.
    std::vector<Warning> unused(const std::vector<PlannedSetup>& setups) const;

  private:
    bool chooses(const HoleEntry& entry, const Feature& feature, const Vec2& place, const Setup& setup) const;
    bool names(const HoleEntry& entry, const Feature& feature, const Vec2& place, const Setup& setup) const;

    const HoleTable& table_;
    std::vector<Hole> holes_;  ///< of the part, where the table names some
};

}  // namespace stepmill
