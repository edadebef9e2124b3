#include "plan/operations/earlier_operations.h"

#include "plan/id_number.h"
#include "plan/operations/make_operations.h"

namespace stepmill {
EarlierOperations::EarlierOperations(const PlannedSetup& setup, const std::vector<EarlierSetup>& earlier)
    : setup_id_(setup.setup.id), earlier_(earlierOf(setup.setup, earlier)) {
    for (const Operation& operation : setup.operations)
        last_number_ = std::max(last_number_, numberOfId(operation.id));
    if (earlier_ == nullptr) return;
    found_.resize(earlier_->operations.size(), false);
    for (const EarlierOperation& operation : earlier_->operations)
        last_number_ = std::max(last_number_, numberOfId(operation.id));
}

std::optional<std::size_t> EarlierOperations::find(const Operation& operation) {
    for (std::size_t i = 0; i < found_.size(); ++i) {
        const EarlierOperation& before = earlier_->operations[i];
        const bool same = !found_[i] && before.feature_id == operation.feature_id &&
                          before.tool_id == operation.tool_id && before.role == operation.role;
        if (!same) continue;
        found_[i] = true;
        return i;
    }
    return std::nullopt;
}

std::string EarlierOperations::idOf(const Operation& operation) {
    if (const std::optional<std::size_t> place = find(operation)) return earlier_->operations[*place].id;
    return operationId(setup_id_, ++last_number_);
}

}  // namespace stepmill
