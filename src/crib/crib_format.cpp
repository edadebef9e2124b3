#include <algorithm>

#include "stepmill/core/enum_words.h"
#include "stepmill/crib/read_foreign.h"

namespace stepmill {
namespace {

constexpr EnumWord<CribFormat> kFormats[] = {
    {CribFormat::Fusion, "fusion"},   {CribFormat::FusionZip, "fusion-zip"}, {CribFormat::Hsm, "hsm"},
    {CribFormat::FreeCad, "freecad"}, {CribFormat::LinuxCnc, "linuxcnc"},    {CribFormat::Csv, "csv"}};

constexpr EnumWord<CribFormat> kEndings[] = {
    {CribFormat::Fusion, ".json"},  {CribFormat::FusionZip, ".tools"}, {CribFormat::Hsm, ".hsmlib"},
    {CribFormat::FreeCad, ".fctb"}, {CribFormat::FreeCad, ".fctl"},    {CribFormat::LinuxCnc, ".tbl"},
    {CribFormat::Csv, ".csv"}};

}  // namespace

std::string toString(CribFormat format) {
    return wordOf(kFormats, format);
}

std::optional<CribFormat> cribFormatFrom(std::string_view word) {
    return valueOf(kFormats, word);
}

std::optional<CribFormat> cribFormatOf(const std::filesystem::path& file) {
    if (std::filesystem::is_directory(file)) return CribFormat::FreeCad;
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return valueOf(kEndings, ending);
}

}  // namespace stepmill
