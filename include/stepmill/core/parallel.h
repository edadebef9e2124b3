#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_group.h>

namespace stepmill {

// Loops over all threads that are all done when they return. An inner loop of oneTBB's own is cancelled when
// a task of the loop around it throws, as at a deadline, and returns as if it were done, with half of the
// values that it was to make. These are cancelled by their own exceptions alone, which they throw on.

/// body(i) for each i from 0 to count - 1, in no order.
/// \throws what one of them throws, once those that were begun are done; others are left out
template <typename Index, typename Body>
void parallelFor(Index count, const Body& body) {
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::parallel_for(Index{0}, count, body, own);
}

/// body(first, last) for parts of the numbers from 0 to count - 1, none of fewer than half of `at_once`
/// unless all are fewer.
template <typename Index, typename Body>
void parallelForParts(Index count, Index at_once, const Body& body) {
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::parallel_for(
        tbb::blocked_range<Index>(0, count, at_once),
        [&](const tbb::blocked_range<Index>& part) { body(part.begin(), part.end()); }, own);
}

/// Both, in no order.
template <typename One, typename Other>
void parallelInvoke(const One& one, const Other& other) {
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::parallel_invoke(one, other, own);
}

}  // namespace stepmill
