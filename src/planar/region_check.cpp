#include "stepmill/core/error.h"
#include "stepmill/planar/region.h"
namespace stepmill {
std::optional<std::string> diagnose(const Region&) {
    return std::nullopt;
}
void validate(const Region& region, const std::string& subject) {
    if (const auto trouble = diagnose(region)) throw Error(ErrorCode::InvalidRegion, subject, *trouble);
}
}  // namespace stepmill
