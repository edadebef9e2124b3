#include "drawing_options.h"

#include <charconv>
#include <cmath>

#include <fmt/core.h>

#include "stepmill/core/error.h"

namespace stepmill {

namespace {

/// What of a wrong value a message repeats.
constexpr std::size_t kLongestWordQuote = 60;

/// "LAYER=12": the layer's name may hold '=' itself.
void takeDepth(const std::string& word, DrawingOptions& options) {
    const std::size_t equals = word.rfind('=');
    double depth = 0;
    bool number = equals != std::string::npos && equals > 0;
    if (number) {
        const char* const end = word.data() + word.size();
        const auto [at, trouble] = std::from_chars(word.data() + equals + 1, end, depth);
        number = trouble == std::errc() && at == end && std::isfinite(depth);
    }
    if (!number)
        throw Error(
            ErrorCode::Usage, "--depth",
            fmt::format("expected LAYER=DEPTH with a number, found '{}'", word.substr(0, kLongestWordQuote)));
    const std::string layer = word.substr(0, equals);
    if (!options.depths.emplace(layer, depth).second)
        throw Error(
            ErrorCode::Usage, "--depth",
            fmt::format("expected one depth for '{}', found two", layer.substr(0, kLongestWordQuote)));
}

}  // namespace

void addDrawingOptions(CLI::App& command, DrawingWords& words) {
    command
        .add_option("--depth", words.depths,
                    "of a drawing: LAYER=DEPTH below the top, in its unit; LAYER may be colour:...")
        ->type_name("LAYER=DEPTH")
        ->allow_extra_args(false);
    command.add_option("--outline", words.outline, "of a drawing: layer of the part's outer profile")
        ->type_name("LAYER");
    command.add_option("--thickness", words.thickness, "of a drawing: how thick the part is, in its unit");
}

Part readDrawnPart(const std::string& file, const DrawingWords& words, const std::string& unit,
                   std::uintmax_t max_bytes) {
    DrawingOptions options;
    for (const std::string& word : words.depths)
        takeDepth(word, options);
    options.outline = words.outline;
    options.thickness = words.thickness;
    options.unit = unit;
    options.max_file_bytes = max_bytes;
    return readDrawing(file, options);
}

bool isDrawn(const std::string& file, const DrawingWords& words) {
    return isDrawing(file) || !words.depths.empty() || !words.outline.empty() || words.thickness != 0;
}

}  // namespace stepmill
