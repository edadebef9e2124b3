#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "stepmill/drawing/drawing.h"

namespace stepmill {

/// What is typed of a drawing's profiles.
struct DrawingWords {
    std::vector<std::string> depths;  ///< "LAYER=12"
    std::string outline;
    double thickness = 0;
};

/// Adds --depth, --outline and --thickness.
void addDrawingOptions(CLI::App& command, DrawingWords& words);

/// The part of a drawing.
/// \param unit  empty: as the file says
/// \throws Error(Usage) naming the option; what readDrawing() throws
Part readDrawnPart(const std::string& file, const DrawingWords& words, const std::string& unit,
                   std::uintmax_t max_bytes);

/// Is the part a drawing: by the file's name, or since words on profiles are given (STEP files of curves)?
bool isDrawn(const std::string& file, const DrawingWords& words);

}  // namespace stepmill
