#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stepmill {

/// A part that a batch is to plan.
struct ListedPart {
    std::filesystem::path file;  ///< where it is opened
    std::string name;            ///< as reports show it: below the folder, or as the list has it
    int quantity = 1;
    std::string due;       ///< date in the words of the list; may be empty
    std::string material;  ///< empty: the batch's
    std::string options;   ///< of `stepmill plan`, for this part alone; may be empty
};

/// STEP files (.step, .stp, .p21 in any case) in a folder and all below it, by name, byte by byte. Folders
/// whose name begins with a point and those behind links are left out. A folder below that cannot be read is
/// listed as a part is, so that it is named as missing.
/// \param without  a folder below that is left out with all it holds: the batch's own
/// \throws Error(FileUnreadable) where the folder itself cannot be read
std::vector<ListedPart> findParts(const std::filesystem::path& folder, const std::filesystem::path& without);

/// The rows of a list, in its order: a CSV file [RFC 4180] whose first line names its columns: file, and if
/// wanted material, quantity, due, options. Files are found from the list's folder.
/// \param text  of the file
/// \throws Error(InvalidCatalog) naming file and line
std::vector<ListedPart> readPartList(const std::filesystem::path& list, std::string_view text);

/// What a folder may be called on any disk: what of a name is letters and digits, and ten digits that stand
/// for what it is of, so that two that look alike are two.
std::string safeFolderName(const std::string& name, std::string_view identity);

}  // namespace stepmill
