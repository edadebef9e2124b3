#pragma once

namespace stepmill {

/// Walls that lean back no more than this from the vertical are drafted (20 degrees, as a sine): casting and
/// moulding want them, and form cutters finish them level by level from above.
inline constexpr double kDraftSine = 0.3420201433256687;

}  // namespace stepmill
