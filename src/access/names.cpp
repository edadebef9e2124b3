#include "stepmill/access/access.h"
#include "stepmill/core/enum_words.h"

namespace stepmill {
namespace {

constexpr EnumWord<ExclusionReason> kExclusionReasons[] = {
    {ExclusionReason::WrongType, "wrong type"}, {ExclusionReason::NoCuttingData, "no cutting data"},
    {ExclusionReason::TooWide, "too wide"},     {ExclusionReason::NoEntry, "no entry"},
    {ExclusionReason::TooShort, "too short"},   {ExclusionReason::HolderCollision, "holder collision"}};
constexpr EnumWord<EntryKind> kEntryKinds[] = {{EntryKind::OpenEdge, "open edge"},
                                               {EntryKind::Helix, "helix"},
                                               {EntryKind::Ramp, "ramp"},
                                               {EntryKind::Plunge, "plunge"}};

}  // namespace

std::string toString(ExclusionReason reason) {
    return wordOf(kExclusionReasons, reason);
}

std::string toString(EntryKind kind) {
    return wordOf(kEntryKinds, kind);
}

}  // namespace stepmill
