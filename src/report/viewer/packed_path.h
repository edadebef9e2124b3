#pragma once

#include <cstdint>
#include <vector>

#include "report/viewer/packed_bytes.h"
#include "stepmill/planar/region.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill::report {

/// A tool path for the viewer.
///
/// Its start as three numbers, then each move: a byte (bits 0 to 2 the kind, 3 arc, 4 counter-clockwise, 5 in
/// air, 6 changes its height, 7 changes the feed), the feed in whole mm/min where it changes (0, as at the
/// start: that of the kind; rapids keep it), how far x and y go, z where it changes, of an arc the centre
/// from where the move starts. All in whole steps of kPackedStepMm; places are rounded, so no error adds up.
struct PackedPath {
    std::size_t moves = 0;
    PackedBytes bytes;
    PackedBytes loads;  ///< runs: how many moves, and their class; empty where none were given
};

/// \param tolerance_mm  straight moves of one kind, feed and load one after another become one where that
///                      changes the way by no more
/// \param load_classes  of the path's moves; empty: not known
PackedPath packed(const Toolpath& path, double tolerance_mm, const std::vector<std::uint8_t>& load_classes);

/// The highest feed of the path [mm/min].
double fastestFeed(const Toolpath& path);

/// Loops of chords for the viewer: how many, then of each how many corners and each corner from the one
/// before, the first from zero.
PackedBytes packed(const Region& region, double chord_mm);

}  // namespace stepmill::report
