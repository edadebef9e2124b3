#pragma once

#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// A library and what of it no plan can use.
struct UsableLibrary {
    ToolLibrary library;
    std::vector<Warning> warnings;  ///< one "tool-unusable" for each tool that loses its data
};

/// The library less cutting data that no program can be made with: feeds that the machine's spindle slows
/// to nothing, and depths of cut so thin that the stock's height takes more than toolpath::kMostDepths of
/// them. Its tools stand in the machine: inSpindle() (catalog/spindle.h).
UsableLibrary usableLibrary(const ToolLibrary& library, const SequenceOptions& options,
                            const Machine& machine, double deepest_mm);

/// Height of the stock in the setup where it stands tallest [mm].
double tallestStockMm(const std::vector<Setup>& setups);

}  // namespace stepmill
