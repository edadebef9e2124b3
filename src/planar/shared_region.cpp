#include "stepmill/planar/shared_region.h"

namespace stepmill {

const Region& SharedRegion::operator*() const {
    static const Region nothing;
    return region_ ? *region_ : nothing;
}

}  // namespace stepmill
