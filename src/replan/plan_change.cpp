#include "stepmill/replan/plan_change.h"

#include <algorithm>

#include "stepmill/core/enum_words.h"

namespace stepmill {
namespace {

constexpr EnumWord<Change> kChanges[] = {
    {Change::Kept, "kept"}, {Change::Changed, "changed"}, {Change::New, "new"}, {Change::Dropped, "dropped"}};

constexpr EnumWord<ChangeCause> kCauses[] = {
    {ChangeCause::Ground, "ground"}, {ChangeCause::Depth, "depth"},
    {ChangeCause::Kind, "kind"},     {ChangeCause::Surroundings, "surroundings"},
    {ChangeCause::Tools, "tools"},   {ChangeCause::Path, "path"}};

}  // namespace

std::string toString(Change change) {
    return wordOf(kChanges, change);
}

std::string toString(ChangeCause cause) {
    return wordOf(kCauses, cause);
}

bool PlanChange::sameMachining() const {
    return std::all_of(programs.begin(), programs.end(),
                       [](const ProgramChange& program) { return program.change == Change::Kept; });
}

}  // namespace stepmill
