#include "stepmill/crib/read_foreign.h"

#include "crib/freecad_folder.h"

namespace stepmill {

ForeignLibrary readForeign(const std::filesystem::path& file, CribFormat format,
                           const ForeignOptions& options) {
    if (format == CribFormat::FreeCad) return crib::readFreeCad(file, options);
    const std::string name = file.filename().string();
    const std::string text = readFile(file, options.max_file_bytes);
    switch (format) {
        case CribFormat::FusionZip:
            return fusionFromText(jsonOfZip(text, name, options.max_file_bytes), name, options);
        case CribFormat::Hsm:
            return hsmFromText(text, name, options);
        case CribFormat::LinuxCnc:
            return toolTableFromText(text, name, options);
        case CribFormat::Csv:
            return csvFromText(text, name, options);
        case CribFormat::Fusion:
        case CribFormat::FreeCad:
            break;
    }
    return fusionFromText(text, name, options);
}

}  // namespace stepmill
