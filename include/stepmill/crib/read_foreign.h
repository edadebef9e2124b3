#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "stepmill/core/file.h"
#include "stepmill/crib/foreign_library.h"

namespace stepmill {

/// The formats of other programs' tool libraries.
enum class CribFormat {
    Fusion,     ///< .json of Fusion
    FusionZip,  ///< .tools: the same in a zip
    Hsm,        ///< .hsmlib of HSMWorks and Inventor CAM
    FreeCad,    ///< .fctb, .fctl and folders of .fctb
    LinuxCnc,   ///< tool.tbl
    Csv
};
std::string toString(CribFormat format);
/// The reverse; nothing for another word.
std::optional<CribFormat> cribFormatFrom(std::string_view word);
/// The format by the name's ending, folders are FreeCAD's; nothing where it is none of ours.
std::optional<CribFormat> cribFormatOf(const std::filesystem::path& file);

/// What a file does not say of itself.
struct ForeignOptions {
    std::string unit;  ///< "mm" or "inch" where the format is silent; empty: not told
    std::map<std::string, std::string> columns;    ///< of a CSV file: our field -> its column
    std::map<std::string, std::string> materials;  ///< name of a preset or of its material -> ours
    bool leave_out = false;  ///< leave tools out that cannot be, such as those without a diameter
    std::uintmax_t max_file_bytes = kMaxFileBytes;
};

/// Reads another program's library. Lengths become mm by the unit that each tool names.
/// \throws Error(InvalidCatalog) with file and place as subject and what was expected: no file of that
///         format, a tool without a diameter, numbers that are none, a zip that swells beyond all measure;
///         Error(Usage) naming --unit where neither file nor options say the unit; Error(FileUnreadable)
ForeignLibrary readForeign(const std::filesystem::path& file, CribFormat format,
                           const ForeignOptions& options);

// The same from text in memory; `name` is what messages say.

/// A library of Fusion: an object with the list "data".
ForeignLibrary fusionFromText(std::string_view text, const std::string& name, const ForeignOptions& options);
/// XML in any encoding that says so. Document types and entities beyond XML's own five are not looked at.
ForeignLibrary hsmFromText(std::string_view text, const std::string& name, const ForeignOptions& options);
/// One tool bit of FreeCAD.
/// \param number  of the tool; 0: not known
ForeignTool freeCadBitFromText(std::string_view text, const std::string& name, int number,
                               const ForeignOptions& options);
/// A tool a line: T, P, D and a remark behind a semicolon, from which the tool's type is read.
ForeignLibrary toolTableFromText(std::string_view text, const std::string& name,
                                 const ForeignOptions& options);
/// A tool a row under a row of heads; heads are our fields' names unless `columns` tells others.
ForeignLibrary csvFromText(std::string_view text, const std::string& name, const ForeignOptions& options);

/// The only JSON file of a zip.
/// \throws Error(InvalidCatalog) when it is no zip, holds none or several, or swells beyond `max_bytes` or
///         kMostSwelling times what it takes in the zip
std::string jsonOfZip(std::string_view zip, const std::string& name, std::uintmax_t max_bytes);
/// Libraries swell to some 20 times their size; deflate's most is about 1030.
inline constexpr double kMostSwelling = 200;

}  // namespace stepmill
