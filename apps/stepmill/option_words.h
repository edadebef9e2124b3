#pragma once

#include <map>
#include <string>
#include <vector>

#include "options.h"

namespace stepmill {

/// Options of plan that change it, by name without dashes, with what was typed for each.
using OptionWords = std::map<std::string, std::vector<std::string>>;

/// Those that the command got: one that addPlanningOptions() and addOfferOptions() gave its options.
OptionWords optionWords(const CLI::App& command);

/// Those in a line of a list, as typed behind `stepmill plan`.
/// \throws Error(Usage)
OptionWords optionWords(const std::string& line);

/// Takes the second where both say something.
OptionWords merged(OptionWords all, const OptionWords& own);

/// What the words mean.
/// \throws Error(Usage)
PlanOptions planOptions(const OptionWords& words);

/// SHA-256 of all that a plan is told: the words, and of files that they name the content. Words that say the
/// default change nothing.
/// \throws Error(FileUnreadable)
std::string sha256Of(const OptionWords& words, std::uintmax_t max_file_bytes);

}  // namespace stepmill
