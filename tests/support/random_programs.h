#pragma once

#include <string>

namespace stepmill::test {

/// A program that a generator made.
struct RandomProgram {
    std::string text;
    /// What in it our reader refuses by design whatever a controller does
    /// [docs/adr/0008-the-reader-is-a-controller.md]; empty: nothing.
    std::string beyond;
};

/// A legal or nearly legal LinuxCNC program for tools 1 to 8: modal words of every group in any order,
/// rapids, feeds, arcs in every form, cycles, both units, absolute and incremental, dwells, tool changes,
/// home; words in every spelling. About one in three has a fault of one of many kinds, one in ten something
/// beyond the reader. The same seed makes the same program.
RandomProgram randomProgram(unsigned seed);

}  // namespace stepmill::test
