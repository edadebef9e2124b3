#pragma once

#include "stepmill/core/error.h"

namespace stepmill {

/// An offset of which nothing sure is found: each that was tried comes closer to the boundary than it should.
///
/// Who can do without that offset may catch this one and no other Error; to all others it is a bug as any
/// (Internal).
class UnsureOffset : public Error {
  public:
    UnsureOffset()
        : Error(ErrorCode::Internal, "clearance diagram",
                "an offset comes closer to the boundary than it should") {}
};

}  // namespace stepmill
