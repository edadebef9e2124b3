#include "record/read_region.h"

#include "record/plan_rules.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/region_json.h"

namespace stepmill::record {

Region readRegion(const nlohmann::ordered_json& json, const std::string& pointer) {
    try {
        Region region = regionFromJson(json, "plan.json" + pointer);
        if (const auto fault = diagnose(region)) failAt(pointer, "is no region: " + *fault);
        return region;
    } catch (const Error& error) {
        if (error.code() != ErrorCode::InvalidRegion) throw;
        failAt(pointer, std::string(error.what()).substr(error.subject().size() + 2));
    }
}

}  // namespace stepmill::record
