#pragma once

#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// What comes of not heeding a warning, the gravest first.
enum class Consequence { Danger, MissingOnThePart, Cost, Note };
Consequence consequenceOf(const Warning& warning);

/// Warnings as a reader wants them: those alike as one with a count, the gravest first. Danger comes before
/// what is missing on the part, that before cost, that before notes; among equals the order stays. Alike are
/// those of one code that say the same of several features of one setup, or tools; a proof that failed and
/// pieces that are held by nothing stay warnings of their own.
std::vector<Warning> byConsequence(std::vector<Warning> warnings);

/// The setup whose sheet tells of it: "S1" of "S1.F2.3"; empty where it is the whole plan's.
std::string setupOf(const Warning& warning);

/// Does the machine travel as far as the setup's program goes? Where it does not, the plan warns of it and no
/// program is written.
bool isWithinTravel(const Plan& plan, const std::string& setup_id);

}  // namespace stepmill
