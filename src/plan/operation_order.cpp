#include "stepmill/plan/operation_order.h"

#include "stepmill/core/error.h"

namespace stepmill {

std::string toString(OrderRule rule) {
    switch (rule) {
        case OrderRule::Nearest:
            return "nearest next";
        case OrderRule::Branches:
            return "branch by branch";
        case OrderRule::Levels:
            return "level by level";
    }
    throw Error(ErrorCode::Internal, "order rule", "unknown value");
}

}  // namespace stepmill
