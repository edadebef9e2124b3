#include <fmt/format.h>

#include "stepmill/crib/import_tools.h"

namespace stepmill {

std::string importText(const ImportedLibrary& imported) {
    std::string text =
        fmt::format("{}: {} of {} tools taken, lengths in {}\n", imported.library.file,
                    imported.library.tools.size(), imported.tools.size(), imported.library.unit);
    for (const std::string& note : imported.notes)
        text += fmt::format("  {}\n", note);
    for (const ImportedTool& tool : imported.tools) {
        text += fmt::format("{}: {}{}\n", tool.place, tool.name,
                            tool.left_out.empty() ? "" : ", left out: " + tool.left_out);
        for (const std::string& gap : tool.gaps)
            text += fmt::format("  not told: {}\n", gap);
        for (const std::string& note : tool.notes)
            text += fmt::format("  note: {}\n", note);
        for (const FilledField& filled : tool.filled)
            text += fmt::format("  filled: {} ({})\n", filled.field, filled.source);
    }
    return text;
}

}  // namespace stepmill
