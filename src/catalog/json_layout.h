#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace stepmill {

/// The value as text for people and readers alike: what fits on a line of 110 characters stands on one, lists
/// of numbers, words or rows of them fill their lines, and of all else every item has a line of its own, a
/// space farther in. U+FFFD for bytes that are no UTF-8. No line end at the end.
std::string laidOut(const nlohmann::ordered_json& value);

}  // namespace stepmill
