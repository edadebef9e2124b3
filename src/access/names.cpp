#include "stepmill/access/access.h"
#include "stepmill/core/error.h"

namespace stepmill {

std::string toString(ExclusionReason reason) {
    switch (reason) {
        case ExclusionReason::WrongType:
            return "wrong type";
        case ExclusionReason::NoCuttingData:
            return "no cutting data";
        case ExclusionReason::TooWide:
            return "too wide";
        case ExclusionReason::NoEntry:
            return "no entry";
        case ExclusionReason::TooShort:
            return "too short";
        case ExclusionReason::HolderCollision:
            return "holder collision";
    }
    throw Error(ErrorCode::Internal, "exclusion reason", "unknown value");
}

std::string toString(EntryKind kind) {
    switch (kind) {
        case EntryKind::OpenEdge:
            return "open edge";
        case EntryKind::Helix:
            return "helix";
        case EntryKind::Ramp:
            return "ramp";
        case EntryKind::Plunge:
            return "plunge";
    }
    throw Error(ErrorCode::Internal, "entry kind", "unknown value");
}

}  // namespace stepmill
