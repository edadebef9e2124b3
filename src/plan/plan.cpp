#include "stepmill/plan/plan.h"

#include "stepmill/plan/books.h"

namespace stepmill {

bool Plan::complete(const Tolerances& tol) const {
    return threads_missing == 0 && leavesNothing(balance, request.roughing.has_value(), tol) &&
           balance.gapShare() <= tol.volume_share;
}

}  // namespace stepmill
