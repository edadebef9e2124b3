#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "stepmill/catalog/tool.h"

namespace stepmill::crib {

/// A tool type as other programs and people call it: "flat end mill", "ballend", "1/4 drill, carbide".
struct TypeWord {
    std::optional<ToolType> type;
    std::string unfit;  ///< why Stepmill has no such type; empty where it has, or where no word says a type
};

/// The type that words tell, whatever else they say; of several the most special: "ball end mill" is a ball.
TypeWord typeOfWords(std::string_view words);

/// Makes it a tool of that type, with the point that is usual until its file says another.
void setType(ToolAssembly& tool, ToolType type);

/// How Fusion and HSMWorks call a type, such as "flat end mill".
std::string hsmWord(ToolType type);

/// Lower-case letters and digits of a text, other runs of characters as one space each, a space at both ends.
std::string plainWords(std::string_view text);

}  // namespace stepmill::crib
