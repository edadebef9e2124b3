// Tool libraries of other programs and drawings, from strangers: each text is read or refused as bad input,
// and what is read keeps what imports count on. The first byte says which format.

#include <cstdint>
#include <cstdlib>

#include <fmt/core.h>

#include "drawing/chain.h"
#include "drawing/sketch.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/catalog/write_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/crib/import_tools.h"
#include "stepmill/crib/read_foreign.h"

namespace stepmill {
namespace {

void require(bool holds, const char* law) {
    if (holds) return;
    fmt::print(stderr, "law broken: {}\n", law);
    std::abort();
}

/// What is imported is a library that plans read.
void import(const ForeignLibrary& foreign) {
    static const UsualValues usual = builtInUsualValues();
    const ImportedLibrary imported = importTools(foreign, &usual);
    const std::string text = toolLibraryJson(imported.library, "", imported.filled());
    const ToolLibrary library = toolLibraryFromText(text, "shop.json");
    require(library.tools.size() == imported.library.tools.size(), "every tool reads back");
    for (const ToolAssembly& tool : library.tools)
        require(tool.id == plainLine(tool.id), "no name steers a terminal");
}

/// Profiles are closed and turn to the left.
void join(drawing::Sketch sketch) {
    drawing::Healing healing;
    for (const drawing::Profile& profile :
         drawing::closedProfiles(std::move(sketch.strokes), "plate", healing))
        require(profile.shape.segments.empty() || profile.shape.closed(), "a profile is closed");
}

void read(char format, std::string_view text) {
    ForeignOptions options;
    options.unit = "mm";
    constexpr std::uintmax_t kMostBytes = 1U << 20U;
    switch (format) {
        case 'z':
            return import(fusionFromText(jsonOfZip(text, "lib.tools", kMostBytes), "lib.tools", options));
        case 'h':
            return import(hsmFromText(text, "lib.hsmlib", options));
        case 'b':
            return import({"bit.fctb", {freeCadBitFromText(text, "bit.fctb", 1, options)}});
        case 't':
            return import(toolTableFromText(text, "tool.tbl", options));
        case 'v':
            return import(csvFromText(text, "tools.csv", options));
        case 'd':
            return join(drawing::readDxf(text, "plate.dxf"));
        case 's':
            return join(drawing::readSvg(text, "plate.svg"));
        default:
            return import(fusionFromText(text, "lib.json", options));
    }
}

}  // namespace
}  // namespace stepmill

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        stepmill::read(static_cast<char>(data[0]), text);
    } catch (const stepmill::Error& error) {
        if (!stepmill::isInputError(error.code())) throw;
    }
    return 0;
}
