#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace stepmill {

/// A field of a tool that its maker's file did not say and a table of usual values filled in: no measurement.
struct FilledField {
    std::string field;   ///< "stick_out", "cutting/aluminium"
    std::string source;  ///< where the value is from
};

/// By tool id; tools of which all was told are not in it.
using FilledFields = std::map<std::string, std::vector<FilledField>>;

/// What a tool library says of its tools' filled fields.
/// \pre toolLibraryFromText() takes the text
FilledFields filledFieldsIn(std::string_view library_text);

}  // namespace stepmill
