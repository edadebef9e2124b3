#include "stepmill/feature/reason.h"

#include <optional>
#include <utility>

#include "stepmill/core/error.h"

namespace stepmill {
namespace {

/// A detail stands after the words, between these two.
struct ReasonWords {
    Reason reason;
    const char* words;
    const char* open = " (";
    const char* close = ")";
};

/// Those of walls that are not vertical have their cause's words.
constexpr ReasonWords kWords[] = {
    {Reason::Undercut, "undercut"},
    {Reason::LeftForLater, "left for later setups"},
    {Reason::Sliver, "sliver"},
    {Reason::LeftByEarlierSetups, "left by earlier setups, no face to finish from here"},
    {Reason::CornerRadius, "corner radius"},
    {Reason::NoNarrowCutter, "no cutter narrow enough"},
    {Reason::HolderCollision, "holder collision"},
    {Reason::TooDeep, "too deep"},
    {Reason::NoWayIn, "no way in"},
    {Reason::NoCuttingData, "no cutting data"},
    {Reason::Fixture, "fixture"},
    {Reason::BelowStanding, "below material that stays in ", "", ""},
    {Reason::Allowance, "allowance"},
    {Reason::Holding, "holding"},
    {Reason::AsAsked, "left as the hole table asks"},
    {Reason::LeftBetweenPasses, "left between passes"},
    {Reason::NotProven, "proof"},
    {Reason::PlanningFailed, "planning failed: ", "", ""},
    {Reason::TimeLimit, "time limit"},
};

constexpr std::pair<SlopeCause, Reason> kSlopes[] = {
    {SlopeCause::Draft, Reason::LeaningWall},       {SlopeCause::SlantedFace, Reason::SlantedFace},
    {SlopeCause::Chamfer, Reason::Chamfer},         {SlopeCause::EdgeFillet, Reason::EdgeFillet},
    {SlopeCause::FloorFillet, Reason::FloorFillet}, {SlopeCause::DrillPoint, Reason::DrillPoint},
    {SlopeCause::AcrossAxis, Reason::AcrossAxis},   {SlopeCause::FreeForm, Reason::FreeForm},
    {SlopeCause::Overhang, Reason::Overhang},
};

/// The words followed by the detail; nothing where the text is another's.
std::optional<std::string> detailIn(std::string_view text, const ReasonWords& row) {
    if (text == row.words) return "";
    const std::string begin = std::string(row.words) + row.open;
    const std::string_view end = row.close;
    if (!text.starts_with(begin) || !text.ends_with(end)) return std::nullopt;
    return std::string(text.substr(begin.size(), text.size() - begin.size() - end.size()));
}

}  // namespace

Reason reasonOf(SlopeCause cause) {
    for (const auto& [slope, reason] : kSlopes)
        if (slope == cause) return reason;
    throw Error(ErrorCode::Internal, "slope cause", "unknown value");
}

bool isLeftUncut(const StayReason& reason) {
    return reason == Reason::Allowance || reason == Reason::Holding;
}

bool isOnLeaningWall(const StayReason& reason) {
    switch (reason.kind) {
        case Reason::LeaningWall:
        case Reason::SlantedFace:
        case Reason::Chamfer:
        case Reason::EdgeFillet:
        case Reason::FloorFillet:
        case Reason::DrillPoint:
        case Reason::FreeForm:
            return true;
        default:
            return false;
    }
}

bool isLeftByRoughing(const StayReason& reason) {
    return reason == Reason::Allowance || isOnLeaningWall(reason);
}

std::string toString(const StayReason& reason) {
    for (const auto& [slope, of_slope] : kSlopes)
        if (of_slope == reason.kind) return toString(slope);
    for (const ReasonWords& row : kWords) {
        if (row.reason != reason.kind) continue;
        return reason.detail.empty() ? row.words : row.words + (row.open + reason.detail) + row.close;
    }
    return reason.detail;
}

StayReason stayReasonFrom(std::string_view words) {
    for (const auto& [slope, reason] : kSlopes)
        if (words == toString(slope)) return {reason, {}};
    for (const ReasonWords& row : kWords)
        if (const auto detail = detailIn(words, row)) return {row.reason, *detail};
    return {Reason::Unknown, std::string(words)};
}

}  // namespace stepmill
