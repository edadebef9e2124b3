#pragma once

#include <functional>

#include "stepmill/post/read_program.h"
#include "stepmill/record/plan_record.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill::verify {

/// A read operation, or some of its moves, as the path that prove() takes, with the line of every move.
struct LinedPath {
    Toolpath path;
    std::vector<int> lines;

    /// The first moves alone.
    LinedPath first(std::size_t count) const;
};

/// An operation with its glides as rapids: what an adaptive one feeds faster than the tool may cut, and what
/// a mill goes straight down faster than it may through material, is proven as one. Feeds the machine does
/// not have stay what they are.
ReadOperation withGlidesAsRapids(const ReadOperation& operation, const RecordedOperation& planned,
                                 const Machine& machine);

/// All moves. A stay is added where a plunge ends, which is how prove() knows of what went straight down.
LinedPath wholePath(const ReadOperation& operation);

/// The moves that `wanted`, raised by that much, with hops between them that nobody looks at; all of them
/// feeds.
using Wanted = std::function<bool(const Vec3& from, const Move& move)>;
LinedPath somePath(const ReadOperation& operation, double raised_mm, const Wanted& wanted);

/// Line of the first move up to which `fails` does; moves after a failing one must not mend it.
/// \pre fails(path)
int firstFailingLine(const LinedPath& path, const std::function<bool(const Toolpath&)>& fails);

}  // namespace stepmill::verify
