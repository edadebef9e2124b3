// A plan.json from a stranger: read or refused with Error(InvalidCatalog); what is read is a plan: setups,
// ids that lead somewhere, regions that are regions.

#include <cstdint>
#include <cstdlib>

#include <fmt/core.h>

#include "stepmill/core/error.h"
#include "stepmill/record/plan_record.h"

namespace stepmill {
namespace {

void require(bool holds, const char* law) {
    if (holds) return;
    fmt::print(stderr, "law broken: {}\n", law);
    std::abort();
}

void check(const PlanRecord& record) {
    require(!record.setups.empty(), "a plan has a setup");
    for (const RecordedSetup& setup : record.setups) {
        require(setup.program.find('/') == std::string::npos && setup.program.find('\0') == std::string::npos,
                "a program is a plain file name");
        for (const std::string& id : setup.feature_ids)
            require(record.features.count(id) == 1, "a listed feature exists");
        for (const std::string& id : setup.operation_ids)
            require(record.operations.count(id) == 1, "a listed operation exists");
    }
    for (const auto& [id, planned] : record.features) {
        require(!planned.feature.target.empty() && !diagnose(planned.feature.target), "a target is a region");
        require(!diagnose(planned.feature.obstruction), "an obstruction is a region");
    }
    for (const auto& [id, operation] : record.operations)
        require(operation.speed_rpm >= 1 && operation.depths >= 1, "an operation cuts");
}

}  // namespace
}  // namespace stepmill

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace stepmill;
    try {
        check(planRecordFromText({reinterpret_cast<const char*>(data), size}, Tolerances{}));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::InvalidCatalog) throw;
    }
    return 0;
}
