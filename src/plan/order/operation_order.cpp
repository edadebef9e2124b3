#include "stepmill/plan/operation_order.h"

#include "stepmill/core/enum_words.h"

namespace stepmill {
namespace {

constexpr EnumWord<OrderRule> kOrderRules[] = {{OrderRule::Nearest, "nearest next"},
                                               {OrderRule::Branches, "branch by branch"},
                                               {OrderRule::Levels, "level by level"},
                                               {OrderRule::Earlier, "as before"}};

}  // namespace

std::string toString(OrderRule rule) {
    return wordOf(kOrderRules, rule);
}

}  // namespace stepmill
