#pragma once

#include <string_view>

/// The scripts and the style sheet of the viewer; written by cmake/embed_files.cmake.
namespace stepmill::report {

/// three.js and what turns its camera, as they are packaged, and what their licence asks to stand beside
/// them.
extern const std::string_view kThreeLicence;
extern const std::string_view kThree;
extern const std::string_view kOrbitControls;

/// viewer.css.
extern const std::string_view kViewerStyle;

/// Ours: one script in pieces, each of which takes what those before it define.
extern const std::string_view kViewerDataScript;
extern const std::string_view kViewerPathScript;
extern const std::string_view kViewerFieldScript;
extern const std::string_view kViewerRunScript;
extern const std::string_view kViewerShapesScript;
extern const std::string_view kViewerStageScript;
extern const std::string_view kViewerPanelScript;
extern const std::string_view kViewerMainScript;

}  // namespace stepmill::report
